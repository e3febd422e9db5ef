// SPDX-License-Identifier: Apache-2.0
#include "core/gl/framebuffer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <vector>

#include "core/gl/debug.h"

namespace burin::gl {

Result<Framebuffer> Framebuffer::Create(std::span<const Texture* const> colors, const Texture* depth_stencil,
                                        std::string_view label) {
  AssertContextThread();
  const Texture* first = colors.empty() ? depth_stencil : colors.front();
  if (first == nullptr) return Fail(ErrorKind::kFailed, fmt::format("{}: a framebuffer without attachments", label));
  Framebuffer framebuffer;
  framebuffer.width_ = first->width();
  framebuffer.height_ = first->height();
  framebuffer.colors_ = static_cast<int>(colors.size());

  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  framebuffer.handle_ = FramebufferHandle(id);
  const auto same_size = [&](const Texture& texture) {
    return texture.width() == framebuffer.width_ && texture.height() == framebuffer.height_;
  };
  std::vector<GLenum> buffers;
  for (const Texture* color : colors) {
    if (!same_size(*color)) return Fail(ErrorKind::kFailed, fmt::format("{}: targets of different sizes", label));
    buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
    glNamedFramebufferTexture(id, buffers.back(), color->id(), 0);
  }
  glNamedFramebufferDrawBuffers(id, static_cast<GLsizei>(buffers.size()), buffers.data());
  if (depth_stencil != nullptr) {
    if (!same_size(*depth_stencil)) {
      return Fail(ErrorKind::kFailed, fmt::format("{}: a depth buffer of another size", label));
    }
    glNamedFramebufferTexture(id, GL_DEPTH_STENCIL_ATTACHMENT, depth_stencil->id(), 0);
  }
  const GLenum status = glCheckNamedFramebufferStatus(id, GL_DRAW_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    return Fail(ErrorKind::kFailed,
                fmt::format("{}: this device cannot render to these formats (status 0x{:04x})", label, status));
  }
  SetLabel(GL_FRAMEBUFFER, id, label);
  return framebuffer;
}

void Framebuffer::Bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, id());
  glViewport(0, 0, width_, height_);
}

Result<Texture> CreateDepthStencil(int width, int height, std::string_view label) {
  const Format format{.internal = GL_DEPTH32F_STENCIL8,
                      .swizzle = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA},
                      .numeric = Numeric::kFloat,
                      .bits = 32,
                      .components = 1};
  return Texture::Create(format, width, height, 1, label);
}

}  // namespace burin::gl
