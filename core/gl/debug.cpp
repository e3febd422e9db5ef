// SPDX-License-Identifier: Apache-2.0
#include "core/gl/debug.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace burin::gl {
namespace {

constexpr std::size_t kMaxLabel = 255;  // GL_MAX_LABEL_LENGTH is at least 256, the end included

void Report(GLenum source, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* text, const void*) {
  if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) return;
  if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;  // Program::Create reports it
  const std::string_view message = length >= 0 ? std::string_view(text, static_cast<std::size_t>(length)) : text;
  if (message.find("GL_OUT_OF_MEMORY") != std::string_view::npos) return;
  std::fprintf(stderr, "OpenGL: %.*s\n", static_cast<int>(message.size()), message.data());
  std::abort();
}

}  // namespace

void SetLabel(std::uint32_t identifier, std::uint32_t name, std::string_view label) {
  const std::size_t length = std::min(label.size(), kMaxLabel);
  glObjectLabel(identifier, name, static_cast<GLsizei>(length), label.data());
}

void AbortOnDriverErrors() {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(&Report, nullptr);
}

}  // namespace burin::gl
