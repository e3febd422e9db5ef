// SPDX-License-Identifier: Apache-2.0
#include "core/video/frame_rate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace burin::video {
namespace {

void Expect(double rate, int numerator, int denominator) {
  const FrameRate found = RateFromDouble(rate);
  EXPECT_EQ(found.numerator, numerator) << rate;
  EXPECT_EQ(found.denominator, denominator) << rate;
}

TEST(FrameRate, RecoversWholeAndNtscRates) {
  for (const int n : {1, 10, 24, 25, 30, 48, 50, 60, 120, 240}) {
    Expect(n, n, 1);
    Expect(n * 1000.0 / 1001.0, n * 1000, 1001);
  }
  Expect(23.976, 24000, 1001);
  Expect(29.97, 30000, 1001);
  Expect(59.94, 60000, 1001);
  Expect(24.00001, 24, 1);
}

TEST(FrameRate, FindsSimpleRatios) {
  Expect(12.5, 25, 2);
  Expect(7.5, 15, 2);
  Expect(1.0 / 3.0, 1, 3);
  Expect(14.985, 15000, 1001);
}

TEST(FrameRate, NonsenseIsTwentyFour) {
  Expect(0.0, 24, 1);
  Expect(-1.0, 24, 1);
  Expect(std::nan(""), 24, 1);
  Expect(INFINITY, 24, 1);
  Expect(1e9, 24, 1);
}

}  // namespace
}  // namespace burin::video
