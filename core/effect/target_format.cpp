// SPDX-License-Identifier: Apache-2.0
#include "core/effect/target_format.h"

#include <epoxy/gl.h>

namespace burin::effect {
namespace {

std::uint32_t InternalFormat(fx::Format format) {
  switch (format) {
    case fx::Format::kA8R8G8B8:
    case fx::Format::kX8R8G8B8:
    case fx::Format::kA8:
    case fx::Format::kA8L8:
      return GL_RGBA8;
    case fx::Format::kL8:
      return GL_R8;
    case fx::Format::kL16:
      return GL_R16;
    case fx::Format::kR5G6B5:
      return GL_RGB565;
    case fx::Format::kA2B10G10R10:
      return GL_RGB10_A2;
    case fx::Format::kG16R16:
      return GL_RG16;
    case fx::Format::kA16B16G16R16:
    case fx::Format::kB16G16R16:
      return GL_RGBA16;
    case fx::Format::kR16F:
      return GL_R16F;
    case fx::Format::kG16R16F:
      return GL_RG16F;
    case fx::Format::kA16B16G16R16F:
      return GL_RGBA16F;
    case fx::Format::kR32F:
      return GL_R32F;
    case fx::Format::kG32R32F:
      return GL_RG32F;
    case fx::Format::kA32B32G32R32F:
      return GL_RGBA32F;
  }
  return GL_RGBA8;
}

std::array<std::int32_t, 4> Swizzle(fx::Format format) {
  switch (format) {
    case fx::Format::kA8:
      return {GL_ZERO, GL_ZERO, GL_ZERO, GL_ALPHA};
    case fx::Format::kA8L8:
      return {GL_RED, GL_RED, GL_RED, GL_ALPHA};
    case fx::Format::kL8:
    case fx::Format::kL16:
      return {GL_RED, GL_RED, GL_RED, GL_ONE};
    case fx::Format::kR16F:
    case fx::Format::kR32F:
      return {GL_RED, GL_ONE, GL_ONE, GL_ONE};
    case fx::Format::kG16R16:
    case fx::Format::kG16R16F:
    case fx::Format::kG32R32F:
      return {GL_RED, GL_GREEN, GL_ONE, GL_ONE};
    case fx::Format::kX8R8G8B8:
    case fx::Format::kR5G6B5:
    case fx::Format::kB16G16R16:
      return {GL_RED, GL_GREEN, GL_BLUE, GL_ONE};
    case fx::Format::kA8R8G8B8:
    case fx::Format::kA2B10G10R10:
    case fx::Format::kA16B16G16R16:
    case fx::Format::kA16B16G16R16F:
    case fx::Format::kA32B32G32R32F:
      break;
  }
  return {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
}

}  // namespace

gl::Format TargetFormat(fx::Format format) {
  const fx::FormatInfo& info = fx::Info(format);
  return {.internal = InternalFormat(format),
          .swizzle = Swizzle(format),
          .numeric = info.is_float ? gl::Numeric::kFloat : gl::Numeric::kUnorm,
          .bits = info.bits,
          .components = info.components};
}

bool HasAlpha(fx::Format format) {
  switch (format) {
    case fx::Format::kA8R8G8B8:
    case fx::Format::kA8:
    case fx::Format::kA8L8:
    case fx::Format::kA2B10G10R10:
    case fx::Format::kA16B16G16R16:
    case fx::Format::kA16B16G16R16F:
    case fx::Format::kA32B32G32R32F:
      return true;
    case fx::Format::kX8R8G8B8:
    case fx::Format::kL8:
    case fx::Format::kL16:
    case fx::Format::kR5G6B5:
    case fx::Format::kG16R16:
    case fx::Format::kB16G16R16:
    case fx::Format::kR16F:
    case fx::Format::kG16R16F:
    case fx::Format::kR32F:
    case fx::Format::kG32R32F:
      break;
  }
  return false;
}

std::array<float, 4> ClearColor(const fx::Texture& texture) {
  std::array<float, 4> color{0, 0, 0, HasAlpha(texture.format) ? 0.0f : 1.0f};
  const fx::EffectAnnotation* annotation = fx::FindAnnotation(texture.annotations, "ClearColor");
  if (annotation == nullptr) return color;
  for (std::size_t i = 0; i < 4 && i < annotation->value.numbers.size(); ++i) {
    if (i < 3 || HasAlpha(texture.format)) color[i] = static_cast<float>(annotation->value.numbers[i]);
  }
  return color;
}

}  // namespace burin::effect
