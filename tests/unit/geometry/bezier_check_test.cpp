// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/bezier_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/bezier_networks.h"

namespace burin::geometry {
namespace {

BezierPatches TwoPatches(bool is_rational = false) {
  BezierPatches patches;
  const auto point = [](int i, int j) { return glm::vec4(i, j, 0.0f, 1.0f); };
  test::AddQuad(patches, 4, 3, point, is_rational);
  test::AddTriangle(patches, 4, point, is_rational);
  return patches;
}

std::string MessageOf(const BezierPatches& patches) {
  const auto result = CheckPatches(patches, "jug.bpt");
  if (result) return "";
  EXPECT_EQ(result.error().kind, ErrorKind::kInput);
  return result.error().message;
}

TEST(CheckPatches, AcceptsWhatCanBeEvaluated) {
  EXPECT_EQ(MessageOf(TwoPatches()), "");
  EXPECT_EQ(MessageOf(TwoPatches(true)), "");
  EXPECT_EQ(MessageOf({}), "");
}

TEST(CheckPatches, NamesPatchAndPointOfNumbersThatAreNone) {
  BezierPatches patches = TwoPatches();
  patches.positions[12 + 4].y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(MessageOf(patches), "jug.bpt: patch 2: positions: point 5 is (0, nan, 0, 1), expected finite numbers");
  patches.positions[3].x = -std::numeric_limits<float>::infinity();
  EXPECT_EQ(MessageOf(patches), "jug.bpt: patch 1: positions: point 4 is (-inf, 0, 0, 1), expected finite numbers");
}

TEST(CheckPatches, RefusesOrdersOutOfRange) {
  BezierPatches patches = TwoPatches();
  patches.patches[0].position.u_order = 1;
  EXPECT_EQ(MessageOf(patches), "jug.bpt: patch 1: positions have order 1 x 3, expected 2 to 8");
  patches.patches[0].position.u_order = 9;
  EXPECT_EQ(MessageOf(patches), "jug.bpt: patch 1: positions have order 9 x 3, expected 2 to 8");
  patches = TwoPatches(true);
  patches.patches[1].position.u_order = patches.patches[1].position.v_order = 5;
  EXPECT_EQ(MessageOf(patches), "jug.bpt: patch 2: rational positions have order 5 x 5, expected 2 to 4");
  patches = TwoPatches();
  patches.patches[1].position.v_order = 3;
  EXPECT_EQ(MessageOf(patches), "jug.bpt: patch 2: positions have order 4 x 3, expected one order for a triangle");
  patches = TwoPatches();
  patches.patches[0].color = {0, 9, 1};
  EXPECT_EQ(MessageOf(patches), "jug.bpt: patch 1: colours have order 9 x 1, expected 1 to 8");
}

TEST(CheckPatches, RefusesNetsBeyondTheirArrays) {
  BezierPatches patches = TwoPatches();
  patches.positions.pop_back();
  EXPECT_EQ(MessageOf(patches), "jug.bpt: patch 2: positions are 10 from 12 on, of 21 there are");
  patches = TwoPatches();
  patches.patches[0].position.first = 4'000'000'000u;
  EXPECT_EQ(MessageOf(patches), "jug.bpt: patch 1: positions are 12 from 4000000000 on, of 22 there are");
  patches = TwoPatches();
  patches.patches[1].texcoord[1] = {0, 2, 2};
  EXPECT_EQ(MessageOf(patches), "jug.bpt: patch 2: second texture coordinates are 3 from 0 on, of 0 there are");
  patches = TwoPatches();
  patches.patches[0].normal = {0, 2, 2};
  patches.normals.resize(4);
  patches.normals[2].z = INFINITY;
  EXPECT_EQ(MessageOf(patches), "jug.bpt: patch 1: normals: point 3 is (0, 0, inf), expected finite numbers");
}

TEST(CheckPatches, RefusesWeightsThatAreNotPositive) {
  BezierPatches patches = TwoPatches(true);
  patches.positions[6].w = 0.0f;
  EXPECT_EQ(MessageOf(patches), "jug.bpt: patch 1: rational positions: point 7 has the weight 0, expected more than 0");
  patches.positions[6].w = -2.0f;
  EXPECT_EQ(MessageOf(patches),
            "jug.bpt: patch 1: rational positions: point 7 has the weight -2, expected more than 0");
}

}  // namespace
}  // namespace burin::geometry
