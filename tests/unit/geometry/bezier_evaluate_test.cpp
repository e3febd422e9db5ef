// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/bezier_evaluate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/bezier_networks.h"

namespace burin::geometry {
namespace {

constexpr double kExact = 1e-14;

void ExpectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(EvaluateBezier, KnowsAPolynomialQuad) {
  // x = u, y = v, z = u^2 v: as Bézier points of order 3 x 2.
  BezierPatches patches;
  test::AddQuad(patches, 3, 2,
                [](float i, float j) { return glm::vec4(0.5f * i, j, i == 2 && j == 1 ? 1.0f : 0.0f, 1.0f); });
  for (const auto& [u, v] : {std::pair(0.0, 0.0), std::pair(0.25, 0.75), std::pair(1.0, 0.5)}) {
    const BezierPoint at = EvaluateBezier(patches, patches.patches[0], u, v);
    ExpectNear(at.position, {u, v, u * u * v}, kExact);
    ExpectNear(at.du, {1, 0, 2 * u * v}, kExact);
    ExpectNear(at.dv, {0, 1, u * u}, kExact);
    ExpectNear(at.normal, glm::normalize(glm::dvec3(-2 * u * v, -u * u, 1)), kExact);
  }
}

TEST(EvaluateBezier, KnowsAPolynomialTriangle) {
  // z = u v has the point at (1, 1) of order 3 at 1/2 and all others at 0.
  BezierPatches patches;
  test::AddTriangle(
      patches, 3, [](float i, float j) { return glm::vec4(0.5f * i, 0.5f * j, i == 1 && j == 1 ? 0.5f : 0.0f, 1.0f); });
  for (const auto& [u, v] : {std::pair(0.0, 0.0), std::pair(0.25, 0.5), std::pair(0.0, 1.0)}) {
    const BezierPoint at = EvaluateBezier(patches, patches.patches[0], u, v);
    ExpectNear(at.position, {u, v, u * v}, kExact);
    ExpectNear(at.du, {1, 0, v}, kExact);
    ExpectNear(at.dv, {0, 1, u}, kExact);
  }
}

/// An eighth of the unit sphere; side v = 1 is the pole (0, 0, 1).
BezierPatches Octant() {
  const float h = std::numbers::sqrt2_v<float> / 2.0f;
  const float x[3] = {1, h, 0}, y[3] = {0, h, 1}, w[3] = {1, h, 1};
  const float rho[3] = {1, 1, 0}, z[3] = {0, 1, 1};
  BezierPatches patches;
  test::AddQuad(
      patches, 3, 3,
      [&](int i, int j) {
        // The product of two quarter circles: the profile's weighted radius turns the ring's point.
        const float radius = rho[j] * w[j];
        return glm::vec4(x[i] * radius, y[i] * radius, z[j] * w[j] * w[i], w[i] * w[j]);
      },
      true);
  return patches;
}

TEST(EvaluateBezier, KnowsARationalSphere) {
  const BezierPatches patches = Octant();
  for (const double u : {0.0, 0.3, 0.5, 1.0}) {
    for (const double v : {0.0, 0.2, 0.5, 0.9}) {
      const BezierPoint at = EvaluateBezier(patches, patches.patches[0], u, v);
      EXPECT_NEAR(glm::length(at.position), 1.0, 1e-7);
      ExpectNear(at.normal, at.position, 1e-6);
    }
  }
}

TEST(EvaluateBezier, TakesTheLimitAtPoles) {
  const BezierPatches patches = Octant();
  for (const double u : {0.0, 0.3, 1.0})
    ExpectNear(EvaluateBezier(patches, patches.patches[0], u, 1.0).normal, {0, 0, 1}, 1e-6);
  // A cone with its tip at side v = 1: each line down from the tip has a normal of its own.
  BezierPatches cone;
  test::AddQuad(cone, 2, 2, [](float i, float j) {
    return j == 1 ? glm::vec4(0, 0, 1, 1) : i == 0 ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 1, 0, 1);
  });
  // All of it lies in the plane x + y + z = 1.
  const glm::dvec3 plane = glm::normalize(glm::dvec3(1, 1, 1));
  for (const double u : {0.0, 0.5, 1.0}) ExpectNear(EvaluateBezier(cone, cone.patches[0], u, 1.0).normal, plane, 1e-9);
}

TEST(EvaluateBezier, TakesTheLimitWhereControlPointsCoincide) {
  // Both derivatives vanish at (0, 0); the surface there is the plane z = 0.
  BezierPatches patches;
  test::AddQuad(patches, 3, 3,
                [](float i, float j) { return glm::vec4(i == 2 ? 1.0f : 0.0f, j == 2 ? 1.0f : 0.0f, 0.0f, 1.0f); });
  ExpectNear(EvaluateBezier(patches, patches.patches[0], 0.0, 0.0).normal, {0, 0, 1}, 1e-9);
}

TEST(EvaluateBezier, GivesPatchesWithoutAreaSomeUnitNormal) {
  BezierPatches patches;
  test::AddQuad(patches, 4, 4, [](int, int) { return glm::vec4(1, 2, 3, 1); });
  test::AddTriangle(patches, 3, [](float i, int) { return glm::vec4(i, 0, 0, 1); });
  for (const BezierPatch& patch : patches.patches)
    EXPECT_DOUBLE_EQ(glm::length(EvaluateBezier(patches, patch, 0.25, 0.25).normal), 1.0);
}

TEST(EvaluateBezier, PrefersNormalsThatAreGiven) {
  BezierPatches patches;
  test::AddQuad(patches, 2, 2, [](float i, float j) { return glm::vec4(i, j, 0, 1); });
  patches.patches[0].normal = {0, 2, 1};
  patches.normals = {{0, 0, 2}, {2, 0, 0}};
  ExpectNear(EvaluateBezier(patches, patches.patches[0], 0.5, 0.25).normal, glm::normalize(glm::dvec3(1, 0, 1)),
             kExact);
  // Where they vanish, the surface's own.
  patches.normals = {{1, 0, 0}, {-1, 0, 0}};
  ExpectNear(EvaluateBezier(patches, patches.patches[0], 0.5, 0.25).normal, {0, 0, 1}, kExact);
}

}  // namespace
}  // namespace burin::geometry
