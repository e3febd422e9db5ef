// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "core/base/error.h"
#include "core/gl/format.h"
#include "core/gl/handle.h"
#include "core/image/image.h"

namespace burin::gl {

/// A 2D texture of immutable storage, row 0 on top, with its format's swizzle set.
class Texture {
 public:
  Texture() = default;
  /// `levels` 0: the full mipmap chain. Errors: kFailed when the size is over the device's limit or memory is short.
  [[nodiscard]] static Result<Texture> Create(const Format& format, int width, int height, int levels,
                                              std::string_view label);

  [[nodiscard]] std::uint32_t id() const { return handle_.id(); }
  [[nodiscard]] const Format& format() const { return format_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int levels() const { return levels_; }
  explicit operator bool() const { return static_cast<bool>(handle_); }

  /// Replaces level 0 with `image`, which has this size and 1 to 4 channels of any type but kU32.
  void Upload(const image::Image& image);
  void GenerateMipmaps();

 private:
  TextureHandle handle_;
  Format format_;
  int width_ = 0;
  int height_ = 0;
  int levels_ = 1;
};

/// The natural format of an image's pixels: R8..RGBA8, R16..RGBA16, R16F..RGBA16F, R32F..RGBA32F, with a
/// swizzle that gives grey for one channel, grey and alpha for two.
[[nodiscard]] Format FormatFor(const image::Image& image);

/// A colour format with no special swizzle, e.g. PlainFormat(Numeric::kFloat, 32, 4) is RGBA32F. bits: 8, 16, 32
/// (floats 16 or 32); missing components read as (0,0,0,1).
[[nodiscard]] Format PlainFormat(Numeric numeric, int bits, int components);

}  // namespace burin::gl
