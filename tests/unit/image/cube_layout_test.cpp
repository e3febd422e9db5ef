// SPDX-License-Identifier: Apache-2.0
#include "core/image/cube_layout.h"

#include <gtest/gtest.h>

namespace burin::image {
namespace {

TEST(CubeLayout, IsToldByProportions) {
  EXPECT_EQ(CubeLayoutOf(64, 48), CubeLayout::kHorizontalCross);
  EXPECT_EQ(CubeLayoutOf(48, 64), CubeLayout::kVerticalCross);
  EXPECT_EQ(CubeLayoutOf(96, 16), CubeLayout::kRow);
  EXPECT_EQ(CubeLayoutOf(16, 96), CubeLayout::kColumn);
  EXPECT_EQ(CubeLayoutOf(1024, 512), std::nullopt);
  EXPECT_EQ(CubeLayoutOf(1, 1), std::nullopt);
  EXPECT_EQ(CubeLayoutOf(65, 48), std::nullopt);
  EXPECT_EQ(CubeLayoutOf(0, 0), std::nullopt);
}

}  // namespace
}  // namespace burin::image
