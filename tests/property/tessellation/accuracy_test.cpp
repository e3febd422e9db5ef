// SPDX-License-Identifier: Apache-2.0
// Stepped vertices against exact evaluation (bezier_evaluate.h, whose own test knows it from closed forms).
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "core/geometry/bezier_evaluate.h"
#include "core/tessellation/boundary.h"
#include "core/tessellation/tessellate.h"
#include "tests/support/bezier_networks.h"

namespace burin::tessellation {
namespace {

constexpr std::uint32_t kSeed = 81'223;
constexpr double kPositionError = 1e-6;  // of the patch's extent
constexpr double kNormalErrorDeg = 0.01;

glm::vec4 RandomPoint(std::mt19937& random, bool is_rational) {
  std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f), weight(0.25f, 4.0f);
  const glm::vec4 point(coordinate(random), coordinate(random), coordinate(random), 1.0f);
  return is_rational ? point * weight(random) : point;
}

struct Errors {
  double position = 0.0, normal_deg = 0.0;
};

/// Whether a vertex lies on a side that is nearly a point, where normals are those next to it (see
/// NormalsOfATinyLoopAreThoseNextToIt).
bool HasLimitNormal(const test::BezierPatches& patches, const geometry::BezierPatch& patch, const glm::dvec2& uv) {
  const std::array<bool, 4> is_on{uv.y == 0.0, uv.y == 1.0, uv.x == 0.0, uv.x == 1.0};
  const auto shapes = SideShapes(patches, patch);
  for (std::uint32_t s = 0; s < 4; ++s) {
    if (is_on[s] && shapes[s] != SideShape::kOpen && IsNearlyPoint(patches, patch, s)) return true;
  }
  return false;
}

/// Of every `stride`-th vertex. Parameters are read from patch_uv, so factors must be powers of two for them to be
/// exact.
Errors WorstErrors(const test::BezierPatches& patches, const Surface& surface, std::size_t stride) {
  Errors worst;
  for (std::size_t v = 0; v < surface.positions.size(); v += stride) {
    const auto& patch = patches.patches[surface.patch_ids[v]];
    const glm::dvec2 uv(surface.patch_uv[v]);
    const auto exact = geometry::EvaluateBezier(patches, patch, uv.x, uv.y);
    worst.position = std::max(worst.position, glm::distance(glm::dvec3(surface.positions[v]), exact.position));
    if (HasLimitNormal(patches, patch, uv)) continue;
    // The chord tells small angles better than the cosine does.
    const double chord = glm::distance(glm::dvec3(surface.normals[v]), exact.normal);
    worst.normal_deg = std::max(worst.normal_deg, chord * 180.0 / std::numbers::pi);
  }
  return worst;
}

void Check(const test::BezierPatches& patches, Pattern pattern, float factor, std::size_t stride, const char* what) {
  const std::vector<Factors> factors(patches.patches.size(), Factors{factor, factor, factor, factor});
  Surface surface;
  Tessellate(patches, factors, {.pattern = pattern}, surface);
  const Errors errors = WorstErrors(patches, surface, stride);
  // Control points lie within the cube from -1 to 1.
  EXPECT_LE(errors.position, kPositionError * 2.0) << what << " factor " << factor << " seed " << kSeed;
  EXPECT_LE(errors.normal_deg, kNormalErrorDeg) << what << " factor " << factor << " seed " << kSeed;
}

TEST(Accuracy, HoldsUpToTheLargestFactorForAllOrders) {
  std::mt19937 random(kSeed);
  for (const bool is_rational : {false, true}) {
    for (int order = 2; order <= (is_rational ? 4 : 8); ++order) {
      test::BezierPatches quads, triangles;
      const auto point = [&](int, int) { return RandomPoint(random, is_rational); };
      test::AddQuad(quads, order, order, point, is_rational);
      test::AddTriangle(triangles, order, point, is_rational);
      for (const Pattern pattern : {Pattern::kInteger, Pattern::kFractional}) {
        for (const float factor : {4.0f, 64.0f, 256.0f}) {
          const std::size_t stride = factor > 200.0f ? 397 : factor > 60.0f ? 31 : 1;
          Check(quads, pattern, factor, stride, "quad");
          Check(triangles, pattern, factor, stride, "triangle");
        }
      }
    }
  }
}

TEST(Accuracy, HoldsForManyCubicPatches) {
  std::mt19937 random(kSeed + 1);
  test::BezierPatches quads;
  for (int n = 0; n < 60; ++n) test::AddQuad(quads, 4, 4, [&](int, int) { return RandomPoint(random, false); });
  Check(quads, Pattern::kFractional, 32.0f, 7, "cubics");
  Check(quads, Pattern::kInteger, 32.0f, 7, "cubics");
}

TEST(Accuracy, HoldsForMixedOrders) {
  std::mt19937 random(kSeed + 2);
  test::BezierPatches quads;
  for (const auto& [u, v] : {std::pair(2, 8), std::pair(8, 2), std::pair(3, 5), std::pair(7, 4)})
    test::AddQuad(quads, u, v, [&](int, int) { return RandomPoint(random, false); });
  Check(quads, Pattern::kFractional, 16.0f, 1, "mixed");
  Check(quads, Pattern::kInteger, 16.0f, 1, "mixed");
}

TEST(Accuracy, HoldsOnTheTeapot) {
  const auto teapot = test::ReadBpt(test::SharedData("bezier/teapot_32.bpt"));
  if (!teapot) GTEST_SKIP() << "no shared data";
  for (const Pattern pattern : {Pattern::kInteger, Pattern::kFractional}) {
    const std::vector<Factors> factors(teapot->patches.size(), Factors{32.0f, 32.0f, 32.0f, 32.0f});
    Surface surface;
    Tessellate(*teapot, factors, {.pattern = pattern}, surface);
    const Errors errors = WorstErrors(*teapot, surface, 3);
    EXPECT_LE(errors.position, kPositionError * 6.0);  // the teapot is 6.4 wide
    EXPECT_LE(errors.normal_deg, kNormalErrorDeg);
  }
}

}  // namespace
}  // namespace burin::tessellation
