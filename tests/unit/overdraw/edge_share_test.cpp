// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_share.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <utility>

namespace burin::overdraw {
namespace {

image::Image Sums(int width, int height, std::initializer_list<std::pair<int, int>> set) {
  image::Image sums;
  sums.width = width;
  sums.height = height;
  sums.channels = 4;
  sums.type = image::SampleType::kF32;
  sums.pixels.resize(sums.RowBytes() * static_cast<std::size_t>(height));
  for (const auto& [x, y] : set) sums.As<float>()[static_cast<std::size_t>(4 * (y * width + x) + 3)] = 0.01f;
  return sums;
}

TEST(ShareNearEdges, CountsTwoPixelsToAllSides) {
  EXPECT_FLOAT_EQ(ShareNearEdges(Sums(10, 8, {{4, 4}})), 25.0f / 80.0f);
  EXPECT_FLOAT_EQ(ShareNearEdges(Sums(10, 8, {{4, 4}, {5, 4}})), 30.0f / 80.0f) << "no pixel twice";
}

TEST(ShareNearEdges, StopsAtTheBorder) {
  EXPECT_FLOAT_EQ(ShareNearEdges(Sums(10, 8, {{0, 0}})), 9.0f / 80.0f);
  EXPECT_FLOAT_EQ(ShareNearEdges(Sums(10, 8, {{9, 7}})), 9.0f / 80.0f);
}

TEST(ShareNearEdges, IsZeroWithoutEdgesOrPixels) {
  EXPECT_FLOAT_EQ(ShareNearEdges(Sums(10, 8, {})), 0.0f);
  EXPECT_FLOAT_EQ(ShareNearEdges(Sums(0, 0, {})), 0.0f);
}

}  // namespace
}  // namespace burin::overdraw
