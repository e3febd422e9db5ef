// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/pass_target.h"

#include <epoxy/gl.h>

#include "core/gl/debug.h"

namespace burin::translucency {
namespace {

gl::Format Plain(GLenum internal, int components) {
  return {.internal = internal,
          .swizzle = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA},
          .numeric = gl::Numeric::kFloat,
          .bits = 32,
          .components = components};
}

}  // namespace

Result<gl::Texture> CreateDepthTexture(int width, int height, std::string_view label) {
  return gl::Texture::Create(Plain(GL_DEPTH_COMPONENT32F, 1), width, height, 1, label);
}

Result<gl::Texture> CreateFloatTexture(int width, int height, std::string_view label) {
  return gl::Texture::Create(Plain(GL_RGBA32F, 4), width, height, 1, label);
}

Result<gl::Texture> CreateBitsTexture(int width, int height, std::string_view label) {
  return gl::Texture::Create(Plain(GL_RGBA32UI, 4), width, height, 1, label);
}

gl::FramebufferHandle CreateTarget(std::array<const gl::Texture*, 2> colors, const gl::Texture* depth,
                                   std::string_view label) {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  gl::FramebufferHandle framebuffer(id);
  std::array<GLenum, 2> buffers = {GL_NONE, GL_NONE};
  for (std::size_t i = 0; i < colors.size(); ++i) {
    if (colors[i] == nullptr) continue;
    buffers[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    glNamedFramebufferTexture(id, buffers[i], colors[i]->id(), 0);
  }
  glNamedFramebufferDrawBuffers(id, 2, buffers.data());
  if (depth != nullptr) glNamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, depth->id(), 0);
  gl::SetLabel(GL_FRAMEBUFFER, id, label);
  return framebuffer;
}

void BindForFetch(unsigned unit, const gl::Texture& texture) {
  glBindSampler(unit, 0);
  glBindTextureUnit(unit, texture.id());
}

}  // namespace burin::translucency
