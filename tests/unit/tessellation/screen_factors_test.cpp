// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <random>

#include "core/tessellation/tessellate.h"
#include "tests/support/bezier_networks.h"

namespace burin::tessellation {
namespace {

/// Reversed depth, infinitely far, as the scene's cameras have it.
glm::mat4 Perspective(float near) {
  glm::mat4 clip(0.0f);
  clip[0][0] = clip[1][1] = 1.0f;
  clip[2][3] = -1.0f;
  clip[3][2] = near;
  return clip;
}

test::BezierPatches Square(float size) {
  test::BezierPatches patches;
  test::AddQuad(patches, 4, 4,
                [&](float i, float j) { return glm::vec4(size * i / 3.0f, size * j / 3.0f, 0.0f, 1.0f); });
  return patches;
}

TEST(ScreenFactors, AreSideLengthsInPixels) {
  const auto patches = Square(0.5f);
  // Clip space is two units wide: half a unit is a quarter of the picture.
  const auto factors = ScreenFactors(patches, {.width = 640, .height = 320, .edge_length_px = 8.0f});
  EXPECT_FLOAT_EQ(factors[0][0], 160.0f / 8.0f);
  EXPECT_FLOAT_EQ(factors[0][1], 20.0f);
  EXPECT_FLOAT_EQ(factors[0][2], 80.0f / 8.0f);
  EXPECT_FLOAT_EQ(factors[0][3], 10.0f);
}

/// As wide as `middle` half-way between sides that are half a unit wide.
test::BezierPatches Barrel(float middle) {
  test::BezierPatches patches;
  test::AddQuad(patches, 2, 3, [&](int i, int j) {
    const float half = 0.5f * (j == 1 ? 2.0f * middle - 0.5f : 0.5f);
    return glm::vec4(i == 0 ? -half : half, 0.5f * static_cast<float>(j), 0.0f, 1.0f);
  });
  return patches;
}

TEST(ScreenFactors, MeasurePatchesInside) {
  const auto inside = [](float middle) {
    const auto factors = ScreenFactors(Barrel(middle), {.width = 800, .height = 400, .edge_length_px = 8.0f});
    EXPECT_FLOAT_EQ(factors[0][0], 25.0f);
    EXPECT_FLOAT_EQ(factors[0][1], 25.0f);
    return factors[0][kInsideU];
  };
  // At 1/4 and 3/4 three quarters of what the middle has more, so five sixths of it on average.
  EXPECT_NEAR(inside(1.1f), 25.0f * (1.0f + 1.2f * 5.0f / 6.0f), 1e-4f);
  EXPECT_FLOAT_EQ(inside(0.2f), 25.0f) << "narrower inside";
  EXPECT_FLOAT_EQ(inside(0.55f), 25.0f) << "hardly wider";
  const float part = inside(0.65f);  // wider by a quarter on average
  EXPECT_NEAR(part, 25.0f * (1.0f + 0.5f * 0.1f / 0.35f), 1e-3f);
}

TEST(ScreenFactors, ClampAndCount) {
  const auto patches = Square(2.0f);
  std::size_t clamped = 0;
  auto factors = ScreenFactors(patches, {.width = 4000, .height = 40, .edge_length_px = 8.0f}, &clamped);
  EXPECT_EQ(factors[0], (Factors{256.0f, 256.0f, 5.0f, 5.0f, 256.0f, 5.0f}));
  EXPECT_EQ(clamped, 2u);
  factors = ScreenFactors(patches, {.width = 4, .height = 4}, &clamped);
  EXPECT_EQ(factors[0], (Factors{1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f}));
  EXPECT_EQ(clamped, 0u);
}

TEST(ScreenFactors, DoNotDependOnTheDirectionOfASide) {
  std::mt19937 random(9);
  std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
  for (int n = 0; n < 500; ++n) {
    std::array<glm::vec4, 4> side;
    for (glm::vec4& point : side) point = {coordinate(random), coordinate(random), coordinate(random) - 2.0f, 1.0f};
    test::BezierPatches patches;
    test::AddQuad(patches, 4, 2,
                  [&](int i, int j) { return j == 0 ? side[static_cast<std::size_t>(i)] : glm::vec4(0, 0, -9, 1); });
    test::AddTriangle(patches, 4, [&](float i, float j) {
      return i == 0 ? side[static_cast<std::size_t>(j)] : glm::vec4(1, 1, -9, 1);
    });
    const auto factors = ScreenFactors(
        patches, {.clip_from_object = Perspective(0.1f), .width = 999, .height = 777, .edge_length_px = 1.0f});
    // Side 2 of a triangle runs from (0, 1) to (0, 0).
    ASSERT_EQ(factors[0][0], factors[1][2]);
  }
}

TEST(ScreenFactors, ClipAtTheNearPlane) {
  // A side from in front of the eye to behind it: what is in front of the plane counts, and no more.
  test::BezierPatches patches;
  test::AddQuad(patches, 2, 2, [](float i, float j) { return glm::vec4(0.5f, j, i == 0 ? -1.5f : 1.0f, 1.0f); });
  const ScreenMetric metric{.clip_from_object = Perspective(0.5f), .width = 200, .height = 200, .edge_length_px = 1.0f};
  // From x / w = 1/3 to 1 at w = 1/2, times 100 pixels.
  EXPECT_NEAR(ScreenFactors(patches, metric)[0][0], 200.0f / 3.0f, 1e-4f);
  // All of a side behind the eye.
  EXPECT_EQ(ScreenFactors(patches, metric)[0][3], 1.0f);
}

/// The largest change of a factor while the camera moves by `step` at a time.
float LargestChange(const test::BezierPatches& patches, float from, float to, float step) {
  std::vector<Factors> last;
  float most = 0.0f;
  for (float z = from; z < to; z += step) {
    const glm::mat4 clip = Perspective(0.25f) * glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, z));
    const auto factors = ScreenFactors(patches, {.clip_from_object = clip, .width = 256, .height = 256});
    for (std::size_t p = 0; p < last.size(); ++p) {
      for (std::size_t s = 0; s < 4; ++s) most = std::max(most, std::abs(factors[p][s] - last[p][s]));
    }
    last = factors;
  }
  return most;
}

TEST(ScreenFactors, AreContinuousAsTheCameraComesNear) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
  test::BezierPatches patches;
  for (int n = 0; n < 20; ++n)
    test::AddQuad(patches, 4, 4, [&](int, int) {
      return glm::vec4(coordinate(random), coordinate(random), coordinate(random), 1.0f);
    });
  // To where the nearest points are a little in front of the near plane.
  EXPECT_LT(LargestChange(patches, -5.0f, -1.3f, 0.001f), 1.0f);
}

TEST(ScreenFactors, AreContinuousAsTheCameraMovesThrough) {
  // No part of the sides is parallel to the near plane, which all of it would pass at once.
  test::BezierPatches patches;
  test::AddQuad(patches, 4, 4, [](float i, float j) {
    return glm::vec4(0.3f * i - 0.2f * j, 0.25f * j - 0.1f * i, 0.4f * i + 0.3f * j - 1.0f, 1.0f);
  });
  EXPECT_LT(LargestChange(patches, -5.0f, 2.0f, 0.001f), 0.5f);
}

TEST(ScreenFactors, MayMakePatchesOutsideThePictureCoarse) {
  test::BezierPatches patches = Square(0.5f);
  // Beside the picture, and across its right border.
  for (const float left : {1.2f, 0.8f}) {
    test::AddQuad(patches, 2, 2, [&](float i, float j) { return glm::vec4(left + 0.5f * i, 0.5f * j, 0.0f, 1.0f); });
  }
  ScreenMetric metric{.width = 256, .height = 256, .edge_length_px = 8.0f};
  for (const Factors& factors : ScreenFactors(patches, metric)) EXPECT_NEAR(factors[0], 8.0f, 1e-4f);
  metric.skips_invisible = true;
  const auto factors = ScreenFactors(patches, metric);
  EXPECT_NEAR(factors[0][0], 8.0f, 1e-4f);
  EXPECT_EQ(factors[1], (Factors{1.0f, 1.0f, 1.0f, 1.0f}));
  EXPECT_NEAR(factors[2][0], 8.0f, 1e-4f);
}

TEST(ScreenFactors, GiveCollapsedSidesAndBadMetricsOne) {
  test::BezierPatches patches;
  test::AddQuad(patches, 4, 4, [](float i, float j) { return glm::vec4(j == 0 ? 0.0f : i, j, 0.0f, 1.0f); });
  EXPECT_EQ(ScreenFactors(patches, {.width = 100, .height = 100, .edge_length_px = 1.0f})[0][0], 1.0f);
  const auto none = ScreenFactors(patches, {.clip_from_object = glm::mat4(NAN), .width = 100, .height = 100});
  EXPECT_EQ(none[0], (Factors{1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f}));
}

}  // namespace
}  // namespace burin::tessellation
