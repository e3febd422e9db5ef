// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/material_texture.h"

#include <epoxy/gl.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace burin::gbuffer {
namespace {

image::Image WhiteTexel() {
  image::Image white;
  white.width = white.height = 1;
  white.channels = 4;
  white.pixels.assign(4, std::byte{0xFF});
  return white;
}

// GL has no 16-bit sRGB format; 16 linear bits hold the darkest 8-bit step 20 times over.
image::Image Decode16(const image::Image& source) {
  image::Image decoded = source;
  const int color_channels = source.channels >= 3 ? 3 : 1;
  std::size_t i = 0;
  for (std::uint16_t& sample : decoded.As<std::uint16_t>()) {
    const bool is_alpha = static_cast<int>(i++ % static_cast<std::size_t>(source.channels)) >= color_channels;
    if (is_alpha) continue;
    const float c = static_cast<float>(sample) / 65535.0f;
    const float linear = c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
    sample = static_cast<std::uint16_t>(std::lround(linear * 65535.0f));
  }
  return decoded;
}

gl::Format FourComponents(const image::Image& image, bool is_srgb) {
  const bool is_float = image.type == image::SampleType::kF16 || image.type == image::SampleType::kF32;
  const int bits = static_cast<int>(image::SampleBytes(image.type)) * 8;
  gl::Format format = gl::PlainFormat(is_float ? gl::Numeric::kFloat : gl::Numeric::kUnorm, bits, 4);
  if (is_srgb) format.internal = GL_SRGB8_ALPHA8;
  return format;
}

}  // namespace

Result<gl::Texture> UploadMaterialTexture(const image::Image& image, bool is_color, std::string_view label) {
  if (image.width == 0 || image.height == 0) return UploadMaterialTexture(WhiteTexel(), is_color, label);
  const bool is_encoded = is_color && image.encoding == image::Encoding::kDisplay;
  const bool is_srgb = is_encoded && image.type == image::SampleType::kU8;
  Result<gl::Texture> texture =
      gl::Texture::Create(FourComponents(image, is_srgb), image.width, image.height, 0, label);
  if (!texture) return texture;
  texture->Upload(is_encoded && image.type == image::SampleType::kU16 ? Decode16(image) : image);
  texture->GenerateMipmaps();
  return texture;
}

}  // namespace burin::gbuffer
