// SPDX-License-Identifier: Apache-2.0
#include "core/image/srgb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/image/convert.h"
#include "core/image/image_module.h"

namespace burin::image {
namespace {

// Twice the bound that srgb.h promises for one of the two ways would be 4e-6; one way must keep half of it.
constexpr double kRelative = 2e-6;

double EncodeExactly(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055; }
double DecodeExactly(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

float Encode(float v) {
  std::vector<float> pixel(4, v);
  SrgbFromLinearRgba(pixel);
  return pixel[0];
}
float Decode(float v) {
  std::vector<float> pixel(4, v);
  LinearFromSrgbRgba(pixel);
  return pixel[0];
}

TEST(Srgb, FastEncodingFollowsTheFormula) {
  for (double v = 1e-4; v < 1e6; v *= 1.0007) {
    const float value = static_cast<float>(v);
    const double exact = EncodeExactly(static_cast<double>(value));
    ASSERT_NEAR(static_cast<double>(Encode(value)), exact, kRelative * exact) << value;
  }
}

TEST(Srgb, FastDecodingFollowsTheFormula) {
  for (double v = 1e-4; v < 1e4; v *= 1.0007) {
    const float value = static_cast<float>(v);
    const double exact = DecodeExactly(static_cast<double>(value));
    ASSERT_NEAR(static_cast<double>(Decode(value)), exact, kRelative * exact) << value;
  }
}

TEST(Srgb, ReferenceFunctionsFollowTheFormula) {
  for (int i = 0; i <= 255; ++i) {
    const float v = static_cast<float>(i) / 255.0F;
    EXPECT_NEAR(static_cast<double>(LinearFromSrgb(v)), DecodeExactly(static_cast<double>(v)), 1e-7);
    EXPECT_NEAR(static_cast<double>(SrgbFromLinear(v)), EncodeExactly(static_cast<double>(v)), 1e-7);
    EXPECT_EQ(LinearFromSrgb8Table()[static_cast<std::size_t>(i)], LinearFromSrgb(v));
  }
}

TEST(Srgb, EveryEightAndSixteenBitValueComesBack) {
  for (int i = 0; i <= 65535; ++i) {
    const float v = static_cast<float>(i) / 65535.0F;
    ASSERT_EQ(std::lround(Encode(Decode(v)) * 65535.0F), i);
  }
}

TEST(Srgb, NegativeValuesStayOnTheLinearSegment) {
  EXPECT_FLOAT_EQ(Encode(-0.5F), -6.46F);
  EXPECT_FLOAT_EQ(Decode(-6.46F), -0.5F);
}

TEST(Srgb, SpecialValuesPassThrough) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(std::isnan(Encode(std::numeric_limits<float>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(Decode(std::numeric_limits<float>::quiet_NaN())));
  EXPECT_EQ(Encode(kInfinity), kInfinity);
  EXPECT_EQ(Decode(kInfinity), kInfinity);
  EXPECT_EQ(Encode(-kInfinity), -kInfinity);
  EXPECT_EQ(Encode(0.0F), 0.0F);
  EXPECT_EQ(Encode(1.0F), 1.0F);
  EXPECT_EQ(Decode(1.0F), 1.0F);
  EXPECT_EQ(Encode(1e-42F), 1e-42F * 12.92F);
}

TEST(Srgb, TransformLeavesAlphaAlone) {
  std::vector<float> pixels{0.5F, 0.25F, 2.0F, 0.5F, 0.0F, 1.0F, 0.1F, 7.0F};
  SrgbTransform()->SceneToDisplay(pixels);
  EXPECT_NEAR(pixels[0], 0.735357F, 1e-6F);
  EXPECT_EQ(pixels[3], 0.5F);
  EXPECT_EQ(pixels[7], 7.0F);
  EXPECT_TRUE(SrgbTransform()->is_srgb());
}

}  // namespace
}  // namespace burin::image
