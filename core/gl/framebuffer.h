// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "core/base/error.h"
#include "core/gl/handle.h"
#include "core/gl/texture.h"

namespace burin::gl {

/// Colour attachments 0..n-1 and an optional depth-stencil renderbuffer texture, all of one size.
class Framebuffer {
 public:
  Framebuffer() = default;
  /// `depth_stencil`: a texture of GL_DEPTH24_STENCIL8 or GL_DEPTH32F_STENCIL8 (CreateDepthStencil), or null. The
  /// textures must outlive the framebuffer.
  [[nodiscard]] static Result<Framebuffer> Create(std::span<const Texture* const> colors, const Texture* depth_stencil,
                                                  std::string_view label);
  /// Binds for drawing to all colour attachments and sets the viewport to the whole.
  void Bind() const;
  [[nodiscard]] std::uint32_t id() const { return handle_.id(); }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  explicit operator bool() const { return static_cast<bool>(handle_); }

 private:
  FramebufferHandle handle_;
  int width_ = 0;
  int height_ = 0;
  int colors_ = 0;
};

/// A depth-stencil texture, GL_DEPTH32F_STENCIL8.
[[nodiscard]] Result<Texture> CreateDepthStencil(int width, int height, std::string_view label);

}  // namespace burin::gl
