// SPDX-License-Identifier: Apache-2.0
#include "core/image/luma.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "core/image/convert.h"

namespace burin::image {
namespace {

TEST(Luma, IsBt709WithinOneStepAndKeepsGreys) {
  constexpr unsigned kSeed = 20260;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  Image rgba = MakeImage(257, 3, 4, SampleType::kU8, Encoding::kDisplay);
  const auto bytes = rgba.As<std::uint8_t>();
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  for (int i = 0; i < 256; ++i) {  // the first row: every grey
    for (int c = 0; c < 3; ++c) bytes[static_cast<std::size_t>(4 * i + c)] = static_cast<std::uint8_t>(i);
  }
  Image luma;
  LumaOfRgba8(rgba, luma);
  ASSERT_EQ(luma.width, 257);
  ASSERT_EQ(luma.height, 3);
  ASSERT_EQ(luma.channels, 1);
  const auto values = luma.As<std::uint8_t>();
  ASSERT_EQ(values.size(), 257U * 3U);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double exact = 0.2126 * bytes[4 * i] + 0.7152 * bytes[4 * i + 1] + 0.0722 * bytes[4 * i + 2];
    EXPECT_NEAR(values[i], exact, 0.51) << "pixel " << i;
    if (i < 256) EXPECT_EQ(values[i], i);
  }
}

}  // namespace
}  // namespace burin::image
