// SPDX-License-Identifier: Apache-2.0
// Half to float: the exponent and mantissa bits moved to a float's place are the value scaled by 2^-112; one
// multiplication by 2^112 sets exponents right, subnormals included. Float to half: for normal results the rounding is
// an integer addition below the last mantissa bit; for subnormal ones adding 0.5 (whose unit in the last place is
// 2^-24, the smallest half) lets the float adder round.
#include "core/image/half.h"

#include <bit>

#include "core/base/target_clones.h"

namespace burin::image {
namespace {

[[gnu::always_inline]] inline float ToFloat(std::uint16_t half) {
  const std::uint32_t sign = static_cast<std::uint32_t>(half & 0x8000U) << 16;
  const std::uint32_t magnitude = static_cast<std::uint32_t>(half & 0x7FFFU) << 13;
  const float scaled = std::bit_cast<float>(magnitude) * std::bit_cast<float>(0x77800000U);  // 2^112
  const std::uint32_t infinite = magnitude >= (0x7C00U << 13) ? 0x7F800000U : 0U;
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(scaled) | infinite | sign);
}

[[gnu::always_inline]] inline std::uint16_t ToHalf(float value) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = (bits >> 16) & 0x8000U;
  const std::uint32_t magnitude = bits & 0x7FFFFFFFU;
  // Rebias 127 -> 15 and round: half of the dropped 13 bits, less one, plus the last kept bit for ties to even.
  const std::uint32_t normal = (magnitude - (112U << 23) + 0x0FFFU + ((magnitude >> 13) & 1U)) >> 13;
  const float shifted = std::bit_cast<float>(magnitude < (113U << 23) ? magnitude : 0U) + 0.5F;
  const std::uint32_t subnormal = std::bit_cast<std::uint32_t>(shifted) - std::bit_cast<std::uint32_t>(0.5F);
  // 65520 is the first value that rounds to infinity.
  const std::uint32_t special = magnitude > 0x7F800000U ? 0x7E00U : 0x7C00U;
  const std::uint32_t finite = magnitude < (113U << 23) ? subnormal : normal;
  return static_cast<std::uint16_t>(sign | (magnitude >= std::bit_cast<std::uint32_t>(65520.0F) ? special : finite));
}

}  // namespace

float FloatFromHalf(std::uint16_t half) { return ToFloat(half); }
std::uint16_t HalfFromFloat(float value) { return ToHalf(value); }

BURIN_TARGET_CLONES void FloatsFromHalves(const std::uint16_t* __restrict halves, float* __restrict floats,
                                          std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) floats[i] = ToFloat(halves[i]);
}

BURIN_TARGET_CLONES void HalvesFromFloats(const float* __restrict floats, std::uint16_t* __restrict halves,
                                          std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) halves[i] = ToHalf(floats[i]);
}

}  // namespace burin::image
