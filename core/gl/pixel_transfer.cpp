// SPDX-License-Identifier: Apache-2.0
#include "core/gl/pixel_transfer.h"

#include <epoxy/gl.h>

#include <array>

namespace burin::gl {

std::uint32_t TransferType(image::SampleType type) {
  switch (type) {
    case image::SampleType::kU8:
      return GL_UNSIGNED_BYTE;
    case image::SampleType::kU16:
      return GL_UNSIGNED_SHORT;
    case image::SampleType::kU32:
      return GL_UNSIGNED_INT;
    case image::SampleType::kF16:
      return GL_HALF_FLOAT;
    case image::SampleType::kF32:
      return GL_FLOAT;
  }
  return GL_UNSIGNED_BYTE;
}

std::uint32_t TransferFormat(image::SampleType type, int channels) {
  constexpr std::array<GLenum, 4> kNormalised = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  constexpr std::array<GLenum, 4> kInteger = {GL_RED_INTEGER, GL_RG_INTEGER, GL_RGB_INTEGER, GL_RGBA_INTEGER};
  const auto column = static_cast<std::size_t>(channels - 1);
  return type == image::SampleType::kU32 ? kInteger.at(column) : kNormalised.at(column);
}

}  // namespace burin::gl
