// SPDX-License-Identifier: Apache-2.0
#include "core/gl/texture.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

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

template <class T>
std::vector<std::byte> ExpandAs(const image::Image& image, T one) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::span<const T> samples = image.As<T>();
  const std::size_t count = samples.size() / channels;
  std::vector<std::byte> bytes(count * 4 * sizeof(T));
  auto* out = reinterpret_cast<T*>(bytes.data());
  const T* in = samples.data();
  for (std::size_t i = 0; i < count; ++i, in += channels, out += 4) {
    out[0] = in[0];
    out[1] = channels == 3 ? in[1] : in[0];
    out[2] = channels == 3 ? in[2] : in[0];
    out[3] = channels == 2 ? in[1] : one;
  }
  return bytes;
}

// Grey, grey-alpha and RGB pixels as RGBA, for a texture that stores four components. GL would leave green and blue of
// grey ones at 0, and Mesa takes ten times as long to widen RGB as this does.
std::vector<std::byte> ExpandToRgba(const image::Image& image) {
  switch (image.type) {
    case image::SampleType::kU8:
      return ExpandAs<std::uint8_t>(image, 0xFF);
    case image::SampleType::kU16:
      return ExpandAs<std::uint16_t>(image, 0xFFFF);
    case image::SampleType::kF16:
      return ExpandAs<std::uint16_t>(image, 0x3C00);  // 1.0 as IEEE 754 binary16
    case image::SampleType::kU32:
      return ExpandAs<std::uint32_t>(image, 1);
    case image::SampleType::kF32:
      return ExpandAs<float>(image, 1.0f);
  }
  return {};
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
    return Fail(ErrorKind::kFailed, fmt::format("{}: no memory for a texture of {}x{} pixels (GL error 0x{:04x})",
                                                label, width, height, error));
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
  if (image.channels < 4 && StoredComponents(format_) == 4) {
    const std::vector<std::byte> rgba = ExpandToRgba(image);
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
