// SPDX-License-Identifier: Apache-2.0
#include "core/image/luma.h"

#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/base/target_clones.h"

namespace burin::image {
namespace {

static_assert(std::endian::native == std::endian::little, "pixels are taken apart as 32-bit words, red lowest");

// 0.2126, 0.7152 and 0.0722 of ITU-R BT.709 times 65536; together they are 65536, so that white stays white.
constexpr std::uint32_t kRed = 13933;
constexpr std::uint32_t kGreen = 46871;
constexpr std::uint32_t kBlue = 4732;
static_assert(kRed + kGreen + kBlue == 65536);

BURIN_TARGET_CLONES void Luma(const std::uint32_t* __restrict pixels, std::uint8_t* __restrict luma,
                              std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t pixel = pixels[i];
    const std::uint32_t sum =
        kRed * (pixel & 0xFFU) + kGreen * ((pixel >> 8U) & 0xFFU) + kBlue * ((pixel >> 16U) & 0xFFU);
    luma[i] = static_cast<std::uint8_t>((sum + 32768U) >> 16U);
  }
}

}  // namespace

void LumaOfRgba8(const Image& rgba, Image& luma) {
  luma.width = rgba.width;
  luma.height = rgba.height;
  luma.channels = 1;
  luma.type = SampleType::kU8;
  luma.encoding = rgba.encoding;
  const std::size_t count = static_cast<std::size_t>(rgba.width) * static_cast<std::size_t>(rgba.height);
  luma.pixels.resize(count);
  Luma(reinterpret_cast<const std::uint32_t*>(rgba.pixels.data()), reinterpret_cast<std::uint8_t*>(luma.pixels.data()),
       count);
}

}  // namespace burin::image
