// SPDX-License-Identifier: Apache-2.0
#include "core/scene/patch_orientation.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/geometry/bezier_evaluate.h"
#include "tests/support/bezier_networks.h"

namespace burin::scene {
namespace {

/// Four sides of a box and its ends as bilinear patches, or the same seen from inside.
geometry::BezierPatches Box(bool is_inside_out) {
  geometry::BezierPatches patches;
  const glm::vec3 axes[3] = {{1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const glm::vec3 out = side * axes[axis];
      const bool turns = (side > 0.0f) == is_inside_out;
      const glm::vec3 u = axes[(axis + (turns ? 2 : 1)) % 3], v = axes[(axis + (turns ? 1 : 2)) % 3];
      test::AddQuad(patches, 2, 2, [&](int i, int j) {
        return glm::vec4(out + (2.0f * static_cast<float>(i) - 1.0f) * u + (2.0f * static_cast<float>(j) - 1.0f) * v,
                         1.0f);
      });
    }
  }
  return patches;
}

void ExpectOutwards(const geometry::BezierPatches& patches) {
  for (const geometry::BezierPatch& patch : patches.patches) {
    const auto point = geometry::EvaluateBezier(patches, patch, 0.5, 0.5);
    EXPECT_GT(glm::dot(point.normal, point.position), 0.0);
  }
}

TEST(TurnOutwards, TurnsWhatIsInsideOut) {
  geometry::BezierPatches patches = Box(true);
  TurnOutwards(patches);
  ExpectOutwards(patches);
}

TEST(TurnOutwards, LeavesWhatLooksOutwards) {
  geometry::BezierPatches patches = Box(false);
  const auto before = patches.positions;
  TurnOutwards(patches);
  EXPECT_EQ(patches.positions, before);
  ExpectOutwards(patches);
}

TEST(TurnOutwards, MirrorsTriangles) {
  // A tetrahedron, inside out; its patches are of degree 2.
  const glm::vec3 corners[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int faces[4][3] = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  geometry::BezierPatches patches;
  for (const auto& face : faces) {
    test::AddTriangle(patches, 3, [&](int i, int j) {
      const float u = static_cast<float>(i) / 2.0f, v = static_cast<float>(j) / 2.0f;
      return glm::vec4((1.0f - u - v) * corners[face[0]] + u * corners[face[1]] + v * corners[face[2]], 1.0f);
    });
  }
  TurnOutwards(patches);
  for (const geometry::BezierPatch& patch : patches.patches) {
    const auto point = geometry::EvaluateBezier(patches, patch, 1.0 / 3.0, 1.0 / 3.0);
    EXPECT_GT(glm::dot(point.normal, point.position - glm::dvec3(0.2)), 0.0);
  }
}

TEST(TurnOutwards, LeavesFlatSheets) {
  geometry::BezierPatches patches;
  test::AddQuad(patches, 2, 2,
                [](int i, int j) { return glm::vec4(static_cast<float>(i), static_cast<float>(j), 0.0f, 1.0f); });
  const auto before = patches.positions;
  TurnOutwards(patches);
  EXPECT_EQ(patches.positions, before);
}

}  // namespace
}  // namespace burin::scene
