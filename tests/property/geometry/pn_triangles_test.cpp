// SPDX-License-Identifier: Apache-2.0
// Curved triangles over random meshes: neighbours have the same control points on the side that they share.
#include "core/geometry/pn_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>

#include "core/geometry/bezier_check.h"
#include "core/geometry/bezier_evaluate.h"
#include "tests/support/triangle_mesh.h"

namespace burin::geometry {
namespace {

constexpr std::array<std::array<std::uint32_t, 4>, 3> kSides = {{{0, 1, 2, 3}, {3, 6, 8, 9}, {9, 7, 4, 0}}};

using Key = std::array<std::uint32_t, 12>;

Key KeyOf(const glm::vec4* net, const std::array<std::uint32_t, 4>& side, bool backwards) {
  Key key{};
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::vec4& p = net[side[backwards ? 3 - i : i]];
    for (int axis = 0; axis < 3; ++axis)
      key[3 * i + static_cast<std::size_t>(axis)] = std::bit_cast<std::uint32_t>(p[axis]);
  }
  return key;
}

/// For each side's control points how often they come in one direction and in the other.
std::map<Key, std::array<int, 2>> CountSides(const std::vector<BezierPatches>& parts) {
  std::map<Key, std::array<int, 2>> sides;
  for (const BezierPatches& part : parts) {
    for (const BezierPatch& patch : part.patches) {
      const glm::vec4* const net = &part.positions[patch.position.first];
      for (const auto& side : kSides) {
        const Key forward = KeyOf(net, side, false), backward = KeyOf(net, side, true);
        ++sides[std::min(forward, backward)][forward < backward ? 0 : 1];
      }
    }
  }
  return sides;
}

/// A closed mesh in several parts, each triangle with vertices of its own, some edges creased: random rotations of the
/// corners, random splits of the normals.
struct RandomMesh {
  std::vector<glm::vec3> positions, normals;
  std::vector<std::uint32_t> indices;
};

std::vector<RandomMesh> MakeParts(std::mt19937& random, int parts, double share_of_creases) {
  test::TriangleMesh mesh = test::Icosphere(2);
  std::uniform_real_distribution<float> jitter(-0.1f, 0.1f);
  for (glm::vec3& p : mesh.positions) p += glm::vec3(jitter(random), jitter(random), jitter(random));
  test::SmoothNormals(mesh);
  std::vector<RandomMesh> out(static_cast<std::size_t>(parts));
  std::uniform_int_distribution<std::size_t> part_of(0, out.size() - 1), turn_of(0, 2);
  std::bernoulli_distribution is_creased(share_of_creases);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    RandomMesh& part = out[part_of(random)];
    const std::size_t turn = turn_of(random);
    const glm::vec3 bend(jitter(random) * 6.0f, jitter(random) * 6.0f, jitter(random) * 6.0f);
    const bool creased = is_creased(random);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.triangles[t + (k + turn) % 3];
      part.indices.push_back(static_cast<std::uint32_t>(part.positions.size()));
      part.positions.push_back(mesh.positions[v]);
      part.normals.push_back(glm::normalize(mesh.normals[v] + (creased ? bend : glm::vec3(0.0f))));
    }
  }
  return out;
}

PnSurface SurfaceOf(const std::vector<RandomMesh>& meshes, bool has_normals, float crease_angle_deg = 60.0f) {
  std::vector<PnPart> parts;
  std::vector<PnPose> poses;
  for (const RandomMesh& mesh : meshes) {
    parts.push_back({.indices = mesh.indices,
                     .positions = mesh.positions,
                     .has_normals = has_normals,
                     .texcoords = {},
                     .colors = {}});
    poses.push_back({mesh.positions, mesh.normals});
  }
  PnSurface surface(parts, crease_angle_deg);
  surface.Pose(poses);
  return surface;
}

TEST(PnTriangles, SidesOfAClosedMeshAreSharedBitForBit) {
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::vector<RandomMesh> meshes = MakeParts(random, 1 + static_cast<int>(seed % 3), 0.1 * (seed % 5));
    const PnSurface surface = SurfaceOf(meshes, seed % 4 != 0);
    for (const BezierPatches& part : surface.parts()) {
      if (part.patches.empty()) continue;
      const auto checked = CheckPatches(part, "mesh");
      ASSERT_TRUE(checked) << checked.error().message;
    }
    for (const auto& [side, uses] : CountSides(surface.parts())) {
      ASSERT_EQ(uses[0], 1);
      ASSERT_EQ(uses[1], 1);
    }
  }
}

TEST(PnTriangles, ASphereIsRound) {
  test::TriangleMesh mesh = test::Icosphere(1);
  RandomMesh sphere{mesh.positions, mesh.positions, mesh.triangles};
  const PnSurface surface = SurfaceOf({sphere}, true);
  const BezierPatches& part = surface.parts()[0];
  double worst = 0.0, worst_normal = 1.0;
  for (const BezierPatch& patch : part.patches) {
    for (const auto& [u, v] : {std::pair(1 / 3.0, 1 / 3.0), {0.5, 0.0}, {0.5, 0.5}, {0.2, 0.1}}) {
      const BezierPoint point = EvaluateBezier(part, patch, u, v);
      worst = std::max(worst, std::abs(glm::length(point.position) - 1.0));
      worst_normal = std::min(worst_normal, glm::dot(point.normal, glm::normalize(point.position)));
    }
  }
  // The flat triangles are up to 0.06 away.
  EXPECT_LT(worst, 0.008);
  EXPECT_GT(worst_normal, std::cos(0.05));
}

TEST(PnTriangles, FlatStaysFlatAndACubeACube) {
  // A cube with a normal a face: every edge is a crease, and nothing bends.
  RandomMesh cube;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 n(0.0f), a(0.0f), b(0.0f);
      n[axis] = side;
      a[(axis + 1) % 3] = side;
      b[(axis + 2) % 3] = 1.0f;
      const auto at = static_cast<std::uint32_t>(cube.positions.size());
      for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        cube.positions.push_back(n + a * static_cast<float>(x) + b * static_cast<float>(y));
        cube.normals.push_back(n);
      }
      for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) cube.indices.push_back(at + k);
    }
  }
  for (const bool has_normals : {true, false}) {
    const PnSurface surface = SurfaceOf({cube}, has_normals);
    for (const glm::vec4& p : surface.parts()[0].positions) {
      EXPECT_FLOAT_EQ(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1.0f);
    }
  }
}

TEST(PnTriangles, ACapStaysFlatAndItsRimIsRound) {
  constexpr int kSlices = 12;
  RandomMesh can;
  const auto add = [&](const glm::vec3& p, const glm::vec3& n) {
    can.positions.push_back(p);
    can.normals.push_back(n);
    return static_cast<std::uint32_t>(can.positions.size() - 1);
  };
  const std::uint32_t middle = add({0, 1, 0}, {0, 1, 0});
  for (int i = 0; i < kSlices; ++i) {
    const auto around = [](int k) {
      const double angle = 2.0 * 3.14159265358979 * k / kSlices;
      return glm::vec3(std::cos(angle), 0.0, -std::sin(angle));
    };
    const glm::vec3 a = around(i), b = around((i + 1) % kSlices), up(0, 1, 0);
    const std::uint32_t cap[] = {middle, add(a + up, up), add(b + up, up)};
    const std::uint32_t side[] = {add(a, a), add(b, b), add(b + up, b), add(a + up, a)};
    can.indices.insert(can.indices.end(), std::begin(cap), std::end(cap));
    for (const int k : {0, 1, 2, 0, 2, 3}) can.indices.push_back(side[k]);
  }
  const PnSurface surface = SurfaceOf({can}, true);
  const BezierPatches& part = surface.parts()[0];
  int rims = 0;
  for (const BezierPatch& patch : part.patches) {
    const glm::vec4* const net = &part.positions[patch.position.first];
    const bool is_cap = net[0].y == 1.0f && net[3].y == 1.0f && net[9].y == 1.0f;
    if (!is_cap) continue;
    for (int i = 0; i < 10; ++i) EXPECT_FLOAT_EQ(net[i].y, 1.0f);
    const glm::dvec3 rim = EvaluateBezier(part, patch, 0.5, 0.5).position;  // between its second and third corner
    EXPECT_NEAR(std::hypot(rim.x, rim.z), 1.0, 2e-3) << "a chord's middle is at 0.966";
    ++rims;
  }
  EXPECT_EQ(rims, kSlices);
}

TEST(PnTriangles, ThePoseDoesNotDependOnEarlierOnes) {
  std::mt19937 random(7);
  std::vector<RandomMesh> meshes = MakeParts(random, 2, 0.2);
  const PnSurface fresh = SurfaceOf(meshes, false);
  PnSurface moved = SurfaceOf(meshes, false);
  std::vector<RandomMesh> other = meshes;
  for (RandomMesh& mesh : other) {
    for (glm::vec3& p : mesh.positions) p = glm::vec3(p.y, 2.0f * p.x, p.z + p.x);
  }
  moved.Pose(std::vector<PnPose>{{other[0].positions, {}}, {other[1].positions, {}}});
  EXPECT_NE(moved.parts()[0].positions, fresh.parts()[0].positions);
  moved.Pose(std::vector<PnPose>{{meshes[0].positions, {}}, {meshes[1].positions, {}}});
  EXPECT_EQ(moved.parts()[0].positions, fresh.parts()[0].positions);
  EXPECT_EQ(moved.parts()[0].normals, fresh.parts()[0].normals);
}

TEST(PnTriangles, VerticesThatComeApartPartTheSurface) {
  // Two triangles over one edge; in the pose the second has left it.
  RandomMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, -1, 0}};
  mesh.normals.assign(6, glm::vec3(0, 0, 1));
  mesh.indices = {0, 1, 2, 3, 4, 5};
  PnSurface surface = SurfaceOf({mesh}, true);
  EXPECT_EQ(CountSides(surface.parts()).size(), 5u);
  std::vector<glm::vec3> pose = mesh.positions;
  for (std::size_t i = 3; i < 6; ++i) pose[i].z = 1.0f;
  surface.Pose(std::vector<PnPose>{{pose, mesh.normals}});
  EXPECT_EQ(CountSides(surface.parts()).size(), 6u);
  EXPECT_EQ(surface.parts()[0].positions[10], glm::vec4(1, 0, 1, 1));
}

}  // namespace
}  // namespace burin::geometry
