// SPDX-License-Identifier: Apache-2.0
#include "core/effect/srgb_view.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>
#include <vector>

namespace burin::effect {

gl::TextureHandle CreateSrgbView(const gl::Texture& texture) {
  GLenum internal = 0;
  if (texture.format().internal == GL_RGBA8) internal = GL_SRGB8_ALPHA8;
  if (texture.format().internal == GL_RGB8) internal = GL_SRGB8;
  if (internal == 0) return {};
  GLuint id = 0;
  glGenTextures(1, &id);  // a view must not have been bound: no glCreateTextures
  gl::TextureHandle view(id);
  glTextureView(id, GL_TEXTURE_2D, texture.id(), internal, 0, static_cast<GLuint>(texture.levels()), 0, 1);
  glTextureParameteriv(id, GL_TEXTURE_SWIZZLE_RGBA, texture.format().swizzle.data());
  return view;
}

Result<gl::FramebufferHandle> CreateFramebuffer(std::span<const std::uint32_t> colors, std::uint32_t depth_stencil,
                                                std::string_view label) {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  gl::FramebufferHandle framebuffer(id);
  std::vector<GLenum> buffers;
  for (const std::uint32_t color : colors) {
    buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
    glNamedFramebufferTexture(id, buffers.back(), color, 0);
  }
  glNamedFramebufferDrawBuffers(id, static_cast<GLsizei>(buffers.size()), buffers.data());
  if (depth_stencil != 0) glNamedFramebufferTexture(id, GL_DEPTH_STENCIL_ATTACHMENT, depth_stencil, 0);
  const GLenum status = glCheckNamedFramebufferStatus(id, GL_DRAW_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    return Fail(ErrorKind::kFailed,
                fmt::format("{}: this device cannot draw to these formats (status 0x{:04x})", label, status));
  }
  return framebuffer;
}

}  // namespace burin::effect
