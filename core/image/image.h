// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin::image {

/// The type of one sample. kU8 and kU16 are normalised (0..1) unless the image holds ids.
enum class SampleType : std::uint8_t { kU8, kU16, kU32, kF16, kF32 };

/// What the samples mean. kDisplay: encoded for a display (sRGB by default); kSceneLinear: scene-referred
/// linear light; kData: no colour (normals, depth, ids), never converted.
enum class Encoding : std::uint8_t { kDisplay, kSceneLinear, kData };

[[nodiscard]] constexpr std::size_t SampleBytes(SampleType type) {
  switch (type) {
    case SampleType::kU8:
      return 1;
    case SampleType::kU16:
    case SampleType::kF16:
      return 2;
    case SampleType::kU32:
    case SampleType::kF32:
      return 4;
  }
  return 0;
}

/// Pixels on the CPU: rows top first, tightly packed, channels interleaved (1 Y, 2 YA, 3 RGB, 4 RGBA with
/// unassociated alpha for kU8/kU16 files and associated alpha for kSceneLinear, as their files hold them).
/// `pixels.size() == width * height * channels * SampleBytes(type)`.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;
  SampleType type = SampleType::kU8;
  Encoding encoding = Encoding::kDisplay;
  std::vector<std::byte> pixels;

  [[nodiscard]] std::size_t RowBytes() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels) * SampleBytes(type);
  }
  template <class T>
  [[nodiscard]] std::span<const T> As() const {
    return {reinterpret_cast<const T*>(pixels.data()), pixels.size() / sizeof(T)};
  }
  template <class T>
  [[nodiscard]] std::span<T> As() {
    return {reinterpret_cast<T*>(pixels.data()), pixels.size() / sizeof(T)};
  }
};

}  // namespace burin::image
