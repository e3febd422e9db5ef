// SPDX-License-Identifier: Apache-2.0
#include "core/image/half.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace burin::image {
namespace {

// The value of a half by its definition: sign, 5 exponent bits with bias 15, 10 mantissa bits.
double ValueOf(std::uint16_t half) {
  const double sign = (half & 0x8000) != 0 ? -1.0 : 1.0;
  const int exponent = (half >> 10) & 0x1F;
  const int mantissa = half & 0x3FF;
  if (exponent == 31) return mantissa == 0 ? sign * INFINITY : NAN;
  if (exponent == 0) return sign * std::ldexp(mantissa, -24);
  return sign * std::ldexp(1024 + mantissa, exponent - 25);
}

TEST(Half, EveryHalfHasItsValueAndComesBack) {
  for (std::uint32_t bits = 0; bits <= 0xFFFF; ++bits) {
    const std::uint16_t half = static_cast<std::uint16_t>(bits);
    const float value = FloatFromHalf(half);
    if (std::isnan(ValueOf(half))) {
      ASSERT_TRUE(std::isnan(value)) << bits;
      ASSERT_TRUE(std::isnan(FloatFromHalf(HalfFromFloat(value)))) << bits;
    } else {
      ASSERT_EQ(static_cast<double>(value), ValueOf(half)) << bits;
      ASSERT_EQ(HalfFromFloat(value), half) << bits;
    }
  }
}

TEST(Half, RoundsToNearestTiesToEven) {
  for (std::uint16_t half = 0; half < 0x7BFF; ++half) {
    const std::uint16_t next = static_cast<std::uint16_t>(half + 1);
    const float middle = static_cast<float>((ValueOf(half) + ValueOf(next)) / 2.0);
    ASSERT_EQ(HalfFromFloat(middle), half % 2 == 0 ? half : next);
    ASSERT_EQ(HalfFromFloat(std::nextafter(middle, 0.0F)), half);
    ASSERT_EQ(HalfFromFloat(std::nextafter(middle, INFINITY)), next);
    ASSERT_EQ(HalfFromFloat(-middle), (half % 2 == 0 ? half : next) | 0x8000);
  }
}

TEST(Half, TooLargeBecomesInfinity) {
  EXPECT_EQ(HalfFromFloat(65519.996F), 0x7BFF);
  EXPECT_EQ(HalfFromFloat(65520.0F), 0x7C00);
  EXPECT_EQ(HalfFromFloat(-1e30F), 0xFC00);
  EXPECT_EQ(HalfFromFloat(std::numeric_limits<float>::infinity()), 0x7C00);
  EXPECT_EQ(HalfFromFloat(1e-30F), 0);
  EXPECT_EQ(HalfFromFloat(-0.0F), 0x8000);
}

TEST(Half, ArraysAgreeWithSingleValues) {
  constexpr unsigned kSeed = 20240;
  std::mt19937 random(kSeed);
  std::vector<float> floats(1003);
  for (float& value : floats) value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
  std::vector<std::uint16_t> halves(floats.size());
  HalvesFromFloats(floats.data(), halves.data(), floats.size());
  std::vector<float> back(floats.size());
  FloatsFromHalves(halves.data(), back.data(), floats.size());
  for (std::size_t i = 0; i < floats.size(); ++i) {
    ASSERT_EQ(halves[i], HalfFromFloat(floats[i])) << "seed " << kSeed << " item " << i;
    ASSERT_EQ(std::bit_cast<std::uint32_t>(back[i]), std::bit_cast<std::uint32_t>(FloatFromHalf(halves[i])));
  }
}

}  // namespace
}  // namespace burin::image
