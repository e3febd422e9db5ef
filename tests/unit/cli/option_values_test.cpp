// SPDX-License-Identifier: Apache-2.0
#include "cli/option_values.h"

#include <gtest/gtest.h>

#include <cmath>

namespace burin::cli {
namespace {

TEST(FrameRate, NtscDecimalsBecomeTheirRatios) {
  const auto rate = [](const char* text) {
    const auto value = ParseFrameRate(text);
    return value ? std::pair(value->numerator, value->denominator) : std::pair(0, 0);
  };
  EXPECT_EQ(rate("24"), std::pair(24, 1));
  EXPECT_EQ(rate("23.976"), std::pair(24000, 1001));
  EXPECT_EQ(rate("29.97"), std::pair(30000, 1001));
  EXPECT_EQ(rate("59.94"), std::pair(60000, 1001));
  EXPECT_EQ(rate("12.5"), std::pair(12500, 1000));
  EXPECT_EQ(rate("30000/1001"), std::pair(30000, 1001));
  for (const char* text : {"0", "-1", "1e9", "inf", "nan", "24fps", "", "24/", "24/0", "/1", "99999/1"}) {
    EXPECT_EQ(rate(text), std::pair(0, 0)) << text;
  }
}

TEST(Color, DisplayColoursAreLinearised) {
  const auto grey = ParseColor("#bcbcbc");
  ASSERT_TRUE(grey);
  // 188/255 through the formula of IEC 61966-2-1, worked out apart.
  EXPECT_NEAR((*grey)[0], std::pow((188 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
  EXPECT_EQ((*grey)[3], 1.0f);
  const auto half = ParseColor("#00000080");
  ASSERT_TRUE(half);
  EXPECT_NEAR((*half)[3], 128 / 255.0, 1e-6);
}

TEST(Color, NumbersAreSceneLinear) {
  const auto color = ParseColor("0.5,2,0.25,0.5");
  ASSERT_TRUE(color);
  EXPECT_EQ(*color, (std::array<float, 4>{0.5f, 2.0f, 0.25f, 0.5f}));
  EXPECT_EQ((*ParseColor("white"))[0], 1.0f);
  for (const char* text : {"", "#12345", "#gggggg", "1,2", "1,2,3,4,5", "-1,0,0", "1,1,1,2", "nan,0,0", "red"}) {
    EXPECT_FALSE(ParseColor(text)) << text;
  }
}

}  // namespace
}  // namespace burin::cli
