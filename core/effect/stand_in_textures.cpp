// SPDX-License-Identifier: Apache-2.0
#include "core/effect/stand_in_textures.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <functional>
#include <vector>

namespace burin::effect {
namespace {

using Pixel = std::array<std::uint8_t, 4>;
using Filler = std::function<Pixel(int x, int y, int z)>;

constexpr Pixel kWhite = {255, 255, 255, 255};
constexpr Pixel kBlack = {0, 0, 0, 255};
constexpr Pixel kFlatNormal = {128, 128, 255, 255};
constexpr Pixel kMidGrey = {128, 128, 128, 255};

constexpr int kNoiseSize = 128;
constexpr int kNoiseVolumeSize = 32;
constexpr int kRampSize = 256;

struct Extent {
  int width = 1, height = 1, depth = 1;
};

std::vector<std::uint8_t> Fill(const Extent& extent, const Filler& filler) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(4u * static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height) *
                static_cast<std::size_t>(extent.depth));
  for (int z = 0; z < extent.depth; ++z) {
    for (int y = 0; y < extent.height; ++y) {
      for (int x = 0; x < extent.width; ++x) {
        const Pixel pixel = filler(x, y, z);
        bytes.insert(bytes.end(), pixel.begin(), pixel.end());
      }
    }
  }
  return bytes;
}

gl::TextureHandle Make(fx::Dimension dimension, const Extent& extent, const Filler& filler) {
  const int longest = std::max({extent.width, extent.height, extent.depth});
  const int levels = std::bit_width(static_cast<unsigned>(longest));
  GLuint id = 0;
  const auto create = [&](GLenum target) { glCreateTextures(target, 1, &id); };
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  const std::vector<std::uint8_t> bytes = Fill(extent, filler);
  switch (dimension) {
    case fx::Dimension::k1D:
      create(GL_TEXTURE_1D);
      glTextureStorage1D(id, levels, GL_RGBA8, extent.width);
      glTextureSubImage1D(id, 0, 0, extent.width, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
      break;
    case fx::Dimension::k3D:
      create(GL_TEXTURE_3D);
      glTextureStorage3D(id, levels, GL_RGBA8, extent.width, extent.height, extent.depth);
      glTextureSubImage3D(id, 0, 0, 0, 0, extent.width, extent.height, extent.depth, GL_RGBA, GL_UNSIGNED_BYTE,
                          bytes.data());
      break;
    case fx::Dimension::kCube:
      create(GL_TEXTURE_CUBE_MAP);
      glTextureStorage2D(id, levels, GL_RGBA8, extent.width, extent.height);
      for (GLint face = 0; face < 6; ++face) {
        glTextureSubImage3D(id, 0, 0, 0, face, extent.width, extent.height, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
      }
      break;
    case fx::Dimension::k2D:
    case fx::Dimension::kUnknown:
      create(GL_TEXTURE_2D);
      glTextureStorage2D(id, levels, GL_RGBA8, extent.width, extent.height);
      glTextureSubImage2D(id, 0, 0, 0, extent.width, extent.height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
      break;
  }
  if (levels > 1) glGenerateTextureMipmap(id);
  return gl::TextureHandle(id);
}

// Four independent numbers a texel, by the finaliser of MurmurHash3.
Pixel NoisePixel(int x, int y, int z) {
  std::uint32_t h = static_cast<std::uint32_t>(x) + static_cast<std::uint32_t>(y) * 0x9E3779B1u +
                    static_cast<std::uint32_t>(z) * 0x85EBCA77u;
  h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
  h = (h ^ (h >> 13)) * 0xC2B2AE35u;
  h ^= h >> 16;
  Pixel pixel;
  std::memcpy(pixel.data(), &h, sizeof(h));
  return pixel;
}

Pixel RampPixel(int x) {
  const auto value = static_cast<std::uint8_t>(x * 255 / (kRampSize - 1));
  return {value, value, value, 255};
}

gl::TextureHandle Create(TextureMeaning meaning, fx::Dimension dimension) {
  const bool is_volume = dimension == fx::Dimension::k3D;
  const bool is_row = dimension == fx::Dimension::k1D;
  if (dimension == fx::Dimension::kCube) return Make(dimension, {}, [](int, int, int) { return kMidGrey; });
  if (meaning == TextureMeaning::kNoise) {
    const int size = is_volume ? kNoiseVolumeSize : kNoiseSize;
    return Make(dimension, {size, is_row ? 1 : size, is_volume ? size : 1}, NoisePixel);
  }
  if (meaning == TextureMeaning::kRamp)
    return Make(dimension, {kRampSize, 1, 1}, [](int x, int, int) { return RampPixel(x); });
  const Pixel pixel = meaning == TextureMeaning::kNormal     ? kFlatNormal
                      : meaning == TextureMeaning::kEmissive ? kBlack
                                                             : kWhite;
  return Make(dimension, {}, [&](int, int, int) { return pixel; });
}

}  // namespace

std::uint32_t StandInTextures::Get(TextureMeaning meaning, fx::Dimension dimension) const {
  if (dimension == fx::Dimension::kUnknown) dimension = fx::Dimension::k2D;
  gl::TextureHandle& texture = textures_[{meaning, dimension}];
  if (!texture) texture = Create(meaning, dimension);
  return texture.id();
}

std::uint32_t StandInTextures::Plain(const std::array<std::uint8_t, 4>& color) const {
  gl::TextureHandle& texture = plain_[color];
  if (!texture) texture = Make(fx::Dimension::k2D, {}, [&](int, int, int) { return color; });
  return texture.id();
}

}  // namespace burin::effect
