// SPDX-License-Identifier: Apache-2.0
#include "core/image/convert.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "core/base/target_clones.h"
#include "core/image/half.h"

namespace burin::image {
namespace {

using U8 = std::uint8_t;
using U16 = std::uint16_t;
using U32 = std::uint32_t;

// NaN fails the comparison and becomes 0.
[[gnu::always_inline]] inline float Clamp01(float v) {
  const float low = v > 0.0F ? v : 0.0F;
  return low < 1.0F ? low : 1.0F;
}

BURIN_TARGET_CLONES void FloatsFromU8(const U8* __restrict from, float* __restrict to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<float>(from[i]) / 255.0F;
}

BURIN_TARGET_CLONES void FloatsFromU16(const U16* __restrict from, float* __restrict to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<float>(from[i]) / 65535.0F;
}

BURIN_TARGET_CLONES void U8FromFloats(const float* __restrict from, U8* __restrict to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<U8>(static_cast<int>(Clamp01(from[i]) * 255.0F + 0.5F));
}

BURIN_TARGET_CLONES void U16FromFloats(const float* __restrict from, U16* __restrict to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    to[i] = static_cast<U16>(static_cast<int>(Clamp01(from[i]) * 65535.0F + 0.5F));
  }
}

BURIN_TARGET_CLONES void U16FromU8(const U8* __restrict from, U16* __restrict to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<U16>(from[i] * 257);
}

BURIN_TARGET_CLONES void U8FromU16(const U16* __restrict from, U8* __restrict to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<U8>((from[i] * U32{255} + 32767U) / 65535U);
}

// 2^32 itself is out of range, so the limit is the largest float below it.
U32 U32FromFloat(float v) { return v > 0.0F ? static_cast<U32>(std::min(v, 4294967040.0F)) : 0U; }

// One block of at most kBlock samples goes through floats; exact for every pair but kU32, which is handled apart.
constexpr std::size_t kBlock = 4096;

void ToFloats(const std::byte* from, SampleType type, float* to, std::size_t count) {
  switch (type) {
    case SampleType::kU8:
      FloatsFromU8(reinterpret_cast<const U8*>(from), to, count);
      break;
    case SampleType::kU16:
      FloatsFromU16(reinterpret_cast<const U16*>(from), to, count);
      break;
    case SampleType::kF16:
      FloatsFromHalves(reinterpret_cast<const U16*>(from), to, count);
      break;
    case SampleType::kF32:
      std::memcpy(to, from, count * sizeof(float));
      break;
    case SampleType::kU32:
      for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<float>(reinterpret_cast<const U32*>(from)[i]);
      break;
  }
}

void FromFloats(const float* from, std::byte* to, SampleType type, std::size_t count) {
  switch (type) {
    case SampleType::kU8:
      U8FromFloats(from, reinterpret_cast<U8*>(to), count);
      break;
    case SampleType::kU16:
      U16FromFloats(from, reinterpret_cast<U16*>(to), count);
      break;
    case SampleType::kF16:
      HalvesFromFloats(from, reinterpret_cast<U16*>(to), count);
      break;
    case SampleType::kF32:
      std::memcpy(to, from, count * sizeof(float));
      break;
    case SampleType::kU32:
      for (std::size_t i = 0; i < count; ++i) reinterpret_cast<U32*>(to)[i] = U32FromFloat(from[i]);
      break;
  }
}

template <class To, class From>
void CopyIds(const std::byte* from, std::byte* to, std::size_t count) {
  constexpr From kLargest = std::numeric_limits<To>::max() < std::numeric_limits<From>::max()
                                ? static_cast<From>(std::numeric_limits<To>::max())
                                : std::numeric_limits<From>::max();
  for (std::size_t i = 0; i < count; ++i) {
    reinterpret_cast<To*>(to)[i] = static_cast<To>(std::min(reinterpret_cast<const From*>(from)[i], kLargest));
  }
}

// Integer pairs that must not go through 0..1 floats. False: not such a pair.
bool ConvertIntegers(const std::byte* from, SampleType from_type, std::byte* to, SampleType to_type,
                     std::size_t count) {
  using enum SampleType;
  if (from_type == kU8 && to_type == kU16) {
    U16FromU8(reinterpret_cast<const U8*>(from), reinterpret_cast<U16*>(to), count);
  } else if (from_type == kU16 && to_type == kU8) {
    U8FromU16(reinterpret_cast<const U16*>(from), reinterpret_cast<U8*>(to), count);
  } else if (from_type == kU32 && to_type == kU8) {
    CopyIds<U8, U32>(from, to, count);
  } else if (from_type == kU32 && to_type == kU16) {
    CopyIds<U16, U32>(from, to, count);
  } else if (from_type == kU8 && to_type == kU32) {
    CopyIds<U32, U8>(from, to, count);
  } else if (from_type == kU16 && to_type == kU32) {
    CopyIds<U32, U16>(from, to, count);
  } else {
    return false;
  }
  return true;
}

template <class T>
constexpr T Opaque(SampleType type) {
  switch (type) {
    case SampleType::kF16:
      return static_cast<T>(0x3C00);  // 1.0 as a half
    case SampleType::kU8:
      return static_cast<T>(0xFF);
    case SampleType::kU16:
      return static_cast<T>(0xFFFF);
    default:
      return static_cast<T>(1);  // 1.0F, and an id of 1
  }
}

// Luminance in the image's own type. Weights of ITU-R BT.709-6, section 3.
template <class T>
T Luminance(const T* rgb, SampleType type) {
  const auto weigh = [](float r, float g, float b) { return 0.2126F * r + 0.7152F * g + 0.0722F * b; };
  if constexpr (sizeof(T) == 2) {
    if (type == SampleType::kF16) {
      return HalfFromFloat(weigh(FloatFromHalf(rgb[0]), FloatFromHalf(rgb[1]), FloatFromHalf(rgb[2])));
    }
  }
  const float y = weigh(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]));
  if constexpr (std::is_floating_point_v<T>) return y;
  return static_cast<T>(y + 0.5F);
}

template <class T>
void CopyChannels(const Image& from, Image& to) {
  const T opaque = Opaque<T>(from.type);
  const std::size_t count = static_cast<std::size_t>(from.width) * static_cast<std::size_t>(from.height);
  const T* source = from.As<T>().data();
  T* target = to.As<T>().data();
  const bool from_alpha = from.channels == 2 || from.channels == 4;
  const bool to_alpha = to.channels == 2 || to.channels == 4;
  const bool weigh = from.channels >= 3 && to.channels <= 2 && from.encoding != Encoding::kData;
  for (std::size_t i = 0; i < count; ++i, source += from.channels, target += to.channels) {
    if (to.channels <= 2) {
      target[0] = weigh ? Luminance(source, from.type) : source[0];
    } else {
      for (int c = 0; c < 3; ++c) target[c] = source[from.channels >= 3 ? c : 0];
    }
    if (to_alpha) target[to.channels - 1] = from_alpha ? source[from.channels - 1] : opaque;
  }
}

// The commonest pair, a frame for a file without alpha: one pass over bytes.
BURIN_TARGET_CLONES void Rgb8FromRgba8(const U8* __restrict from, U8* __restrict to, std::size_t pixels) {
  for (std::size_t i = 0; i < pixels; ++i) {
    to[3 * i] = from[4 * i];
    to[3 * i + 1] = from[4 * i + 1];
    to[3 * i + 2] = from[4 * i + 2];
  }
}

}  // namespace

void ConvertSamples(std::span<const std::byte> from, SampleType from_type, std::span<std::byte> to, SampleType to_type,
                    std::size_t count) {
  assert(from.size() >= count * SampleBytes(from_type) && to.size() >= count * SampleBytes(to_type));
  if (count == 0) return;
  if (from_type == to_type) {
    std::memcpy(to.data(), from.data(), count * SampleBytes(from_type));
    return;
  }
  if (ConvertIntegers(from.data(), from_type, to.data(), to_type, count)) return;
  std::array<float, kBlock> block;
  for (std::size_t done = 0; done < count; done += kBlock) {
    const std::size_t n = std::min(kBlock, count - done);
    const std::byte* source = from.data() + done * SampleBytes(from_type);
    std::byte* target = to.data() + done * SampleBytes(to_type);
    if (to_type == SampleType::kF32) {
      ToFloats(source, from_type, reinterpret_cast<float*>(target), n);
    } else if (from_type == SampleType::kF32) {
      FromFloats(reinterpret_cast<const float*>(source), target, to_type, n);
    } else {
      ToFloats(source, from_type, block.data(), n);
      FromFloats(block.data(), target, to_type, n);
    }
  }
}

Image MakeImage(int width, int height, int channels, SampleType type, Encoding encoding) {
  Image image{width, height, channels, type, encoding, {}};
  image.pixels.resize(image.RowBytes() * static_cast<std::size_t>(height));
  return image;
}

Image ToType(const Image& image, SampleType type) {
  Image converted = MakeImage(image.width, image.height, image.channels, type, image.encoding);
  ConvertSamples(image.pixels, image.type, converted.pixels, type, image.pixels.size() / SampleBytes(image.type));
  return converted;
}

Image ToChannels(const Image& image, int channels) {
  assert(channels >= 1 && channels <= 4 && image.channels >= 1 && image.channels <= 4);
  if (channels == image.channels) return image;
  Image converted = MakeImage(image.width, image.height, channels, image.type, image.encoding);
  if (image.type == SampleType::kU8 && image.channels == 4 && channels == 3) {
    Rgb8FromRgba8(image.As<U8>().data(), converted.As<U8>().data(), image.pixels.size() / 4);
    return converted;
  }
  switch (image.type) {
    case SampleType::kU8:
      CopyChannels<U8>(image, converted);
      break;
    case SampleType::kU16:
    case SampleType::kF16:
      CopyChannels<U16>(image, converted);
      break;
    case SampleType::kU32:
      CopyChannels<U32>(image, converted);
      break;
    case SampleType::kF32:
      CopyChannels<float>(image, converted);
      break;
  }
  return converted;
}

void Premultiply(std::span<float> rgba) {
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    const float alpha = rgba[i + 3];
    if (alpha == 0.0F) continue;
    for (std::size_t c = 0; c < 3; ++c) rgba[i + c] *= alpha;
  }
}

void Unpremultiply(std::span<float> rgba) {
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    const float alpha = rgba[i + 3];
    if (alpha == 0.0F || alpha == 1.0F) continue;
    for (std::size_t c = 0; c < 3; ++c) rgba[i + c] /= alpha;
  }
}

void FlipRows(Image& image) {
  const std::size_t row = image.RowBytes();
  for (int top = 0, bottom = image.height - 1; top < bottom; ++top, --bottom) {
    std::byte* a = image.pixels.data() + static_cast<std::size_t>(top) * row;
    std::swap_ranges(a, a + row, image.pixels.data() + static_cast<std::size_t>(bottom) * row);
  }
}

}  // namespace burin::image
