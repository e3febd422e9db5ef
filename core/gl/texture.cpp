// SPDX-License-Identifier: Apache-2.0
#include "core/gl/texture.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "core/gl/debug.h"
#include "core/gl/pixel_transfer.h"

namespace burin::gl {
namespace {

int FullChain(int width, int height) { return std::bit_width(static_cast<unsigned>(std::max(width, height))); }

void DropPendingErrors() {
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
  }
}

std::size_t StoredComponents(const Format& format) {
  return static_cast<std::size_t>(std::ranges::count_if(ComponentBits(format), [](int bits) { return bits > 0; }));
}

// Grey and grey-alpha pixels as RGBA, for a texture that keeps its colours apart: GL would leave green and blue at 0.
std::vector<std::byte> ExpandGrey(const image::Image& image) {
  const std::size_t sample = image::SampleBytes(image.type);
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  std::vector<std::byte> one(sample, std::byte{0xFF});
  if (image.type == image::SampleType::kF32) {
    const float value = 1.0f;
    std::memcpy(one.data(), &value, sizeof(value));
  } else if (image.type == image::SampleType::kF16) {
    const std::uint16_t value = 0x3C00;   // 1.0 as IEEE 754 binary16
    std::memcpy(one.data(), &value, sizeof(value));
  }
  std::vector<std::byte> rgba(count * sample * 4);
  for (std::size_t i = 0; i < count; ++i) {
    const std::byte* grey = image.pixels.data() + i * channels * sample;
    const std::byte* alpha = channels == 2 ? grey + sample : one.data();
    std::byte* out = rgba.data() + i * sample * 4;
    for (std::size_t c = 0; c < 3; ++c) std::memcpy(out + c * sample, grey, sample);
    std::memcpy(out + 3 * sample, alpha, sample);
  }
  return rgba;
}

}  // namespace

Result<Texture> Texture::Create(const Format& format, int width, int height, int levels, std::string_view label) {
  AssertContextThread();
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (width < 1 || height < 1 || width > limit || height > limit) {
    return Fail(ErrorKind::kFailed, fmt::format("{}: a texture of {}x{} pixels; this device takes 1x1 to {}x{}", label,
                                                width, height, limit, limit));
  }
  Texture texture;
  texture.format_ = format;
  texture.width_ = width;
  texture.height_ = height;
  texture.levels_ = levels > 0 ? std::min(levels, FullChain(width, height)) : FullChain(width, height);

  DropPendingErrors();
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  texture.handle_ = TextureHandle(id);
  glTextureStorage2D(id, texture.levels_, format.internal, width, height);
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    return Fail(ErrorKind::kFailed, fmt::format("{}: no memory for a texture of {}x{} pixels (GL error 0x{:04x})", label,
                                                width, height, error));
  }
  glTextureParameteriv(id, GL_TEXTURE_SWIZZLE_RGBA, format.swizzle.data());
  // Without a sampler object a texture reads point by point, clamped, as Direct3D's defaults filter.
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  SetLabel(GL_TEXTURE, id, label);
  return texture;
}

void Texture::Upload(const image::Image& image) {
  const GLenum type = TransferType(image.type);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  if (image.channels < 3 && StoredComponents(format_) >= 3) {
    const std::vector<std::byte> rgba = ExpandGrey(image);
    glTextureSubImage2D(id(), 0, 0, 0, width_, height_, GL_RGBA, type, rgba.data());
    return;
  }
  glTextureSubImage2D(id(), 0, 0, 0, width_, height_, TransferFormat(image.type, image.channels), type,
                      image.pixels.data());
}

void Texture::GenerateMipmaps() {
  if (levels_ > 1) glGenerateTextureMipmap(id());
}

}  // namespace burin::gl
