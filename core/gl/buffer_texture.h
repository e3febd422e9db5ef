// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/gl/handle.h"

namespace burin::gl {

/// An array for one frame's use that shaders read with texelFetch: a buffer as a texture. On software rasterizers that
/// is several times faster than a shader storage buffer.
class BufferTexture {
 public:
  /// `format`: the GLenum of an element, such as GL_RGBA32UI.
  BufferTexture(std::uint32_t format, std::string_view label);
  /// Replaces what it holds.
  void Upload(std::span<const std::byte> bytes);
  /// Of the texture.
  [[nodiscard]] std::uint32_t id() const { return texture_.id(); }

 private:
  std::uint32_t format_;
  BufferHandle buffer_;
  TextureHandle texture_;
};

}  // namespace burin::gl
