// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/edges.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "core/geometry/degenerate.h"
#include "core/geometry/weld.h"
#include "tests/support/triangle_mesh.h"

namespace burin::geometry {
namespace {

using ::testing::ElementsAre;
using Triangles = std::vector<std::uint32_t>;

std::vector<std::uint32_t> Identity(std::size_t count) {
  std::vector<std::uint32_t> indices(count);
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

/// The edge between two vertices of a mesh without doubled vertices.
const Edge& Between(const std::vector<Edge>& edges, std::uint32_t a, std::uint32_t b) {
  const auto found = std::ranges::find_if(edges, [&](const Edge& e) {
    return e.corners_left == std::array{a, b} || e.corners_left == std::array{b, a};
  });
  if (found == edges.end()) throw std::runtime_error("no such edge");
  return *found;
}

bool RunsThrough(const Triangles& triangles, std::uint32_t face, const std::array<std::uint32_t, 2>& ends) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (triangles[3 * face + k] == ends[0] && triangles[3 * face + (k + 1) % 3] == ends[1]) return true;
  }
  return false;
}

TEST(Edges, LeftFaceRunsThroughTheEdgeAndRightFaceBack) {
  const Triangles triangles = {0, 1, 2, 2, 1, 3};
  const std::vector<Edge> edges = BuildEdges(triangles, Identity(4));
  ASSERT_EQ(edges.size(), 5u);
  const Edge& inner = Between(edges, 1, 2);
  EXPECT_THAT(inner.corners_left, ElementsAre(1, 2));
  EXPECT_EQ(inner.left, 0u);
  EXPECT_EQ(inner.right, 1u);
  EXPECT_FALSE(inner.is_non_manifold);
  const Edge& outer = Between(edges, 0, 2);
  EXPECT_THAT(outer.corners_left, ElementsAre(2, 0)) << "as its only face runs";
  EXPECT_THAT(outer.corners_right, ElementsAre(2, 0));
  EXPECT_EQ(outer.right, kNoFace);
}

TEST(Edges, ClosedMeshHasThreeEdgesForTwoFacesAllWithBoth) {
  const test::TriangleMesh mesh = test::Icosphere(2);
  const std::vector<Edge> edges = BuildEdges(mesh.triangles, Identity(mesh.positions.size()));
  EXPECT_EQ(edges.size(), mesh.triangles.size() / 2);
  for (const Edge& e : edges) {
    ASSERT_NE(e.right, kNoFace);
    ASSERT_FALSE(e.is_non_manifold);
    ASSERT_TRUE(RunsThrough(mesh.triangles, e.left, e.corners_left));
    ASSERT_TRUE(RunsThrough(mesh.triangles, e.right, {e.corners_right[1], e.corners_right[0]}));
  }
}

TEST(Edges, JoinsFacesThatHaveVerticesOfTheirOwn) {
  const test::TriangleMesh cube = test::Cube();
  const std::vector<std::uint32_t> welded = WeldPositions(cube.positions);
  const std::vector<Edge> edges = BuildEdges(cube.triangles, welded);
  EXPECT_EQ(edges.size(), 18u);
  for (const Edge& e : edges) {
    ASSERT_NE(e.right, kNoFace);
    for (std::size_t end = 0; end < 2; ++end) {
      EXPECT_EQ(cube.positions[e.corners_left[end]], cube.positions[e.corners_right[end]]);
    }
  }
}

TEST(Edges, FanOfThreeFacesIsOneNonManifoldEdge) {
  const std::vector<Edge> edges = BuildEdges(Triangles{0, 1, 2, 1, 0, 3, 0, 1, 4}, Identity(5));
  EXPECT_EQ(edges.size(), 7u);
  const Edge& fan = Between(edges, 0, 1);
  EXPECT_TRUE(fan.is_non_manifold);
  EXPECT_EQ(fan.left, 0u);
  EXPECT_EQ(fan.right, 1u);
}

TEST(Edges, FacesThatRunTheSameWayAreNonManifold) {
  const std::vector<Edge> edges = BuildEdges(Triangles{0, 1, 2, 0, 1, 3}, Identity(4));
  const Edge& clash = Between(edges, 0, 1);
  EXPECT_TRUE(clash.is_non_manifold);
  EXPECT_THAT(clash.corners_left, ElementsAre(0, 1));
  EXPECT_THAT(clash.corners_right, ElementsAre(0, 1)) << "the same order of ends on both faces";
}

TEST(Edges, DuplicateTrianglesAreNonManifoldWhicheverWayTheyRun) {
  for (const Triangles& twice : {Triangles{0, 1, 2, 0, 1, 2}, Triangles{0, 1, 2, 2, 1, 0}}) {
    const std::vector<Edge> edges = BuildEdges(twice, Identity(3));
    ASSERT_EQ(edges.size(), 3u);
    for (const Edge& e : edges) EXPECT_TRUE(e.is_non_manifold);
  }
}

TEST(Edges, CollapsedTriangleJoinsItsNeighboursToEachOther) {
  // Vertex 4 is at the place of vertex 1: the middle triangle has no width, its neighbours meet.
  const std::vector<std::uint32_t> welded = {0, 1, 2, 3, 1};
  const std::vector<Edge> edges = BuildEdges(Triangles{0, 1, 2, 1, 4, 2, 2, 4, 3}, welded);
  ASSERT_EQ(edges.size(), 5u);
  const auto joined = std::ranges::find_if(edges, [](const Edge& e) { return e.right != kNoFace; });
  ASSERT_NE(joined, edges.end());
  EXPECT_EQ(joined->left, 0u);
  EXPECT_EQ(joined->right, 2u);
}

TEST(Edges, NeighboursOfATriangleWithoutAreaAreBoundaries) {
  const std::vector<glm::vec3> p = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  const Triangles triangles = {0, 1, 2, 1, 0, 3};
  const std::vector<std::uint8_t> degenerate = FindDegenerate(triangles, p);
  EXPECT_THAT(degenerate, ElementsAre(1, 0));
  const std::vector<Edge> edges = BuildEdges(triangles, Identity(4), degenerate);
  ASSERT_EQ(edges.size(), 3u);
  for (const Edge& e : edges) EXPECT_EQ(e.right, kNoFace);
}

TEST(Edges, DoNotDependOnTheOrderOfTriangles) {
  constexpr std::uint32_t kSeed = 991;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  const test::TriangleMesh mesh = test::Torus(9, 7);
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    faces.push_back({mesh.triangles[t], mesh.triangles[t + 1], mesh.triangles[t + 2]});
  std::ranges::shuffle(faces, random);
  Triangles shuffled;
  for (auto f : faces) {
    std::ranges::rotate(f, f.begin() + random() % 3);
    shuffled.insert(shuffled.end(), f.begin(), f.end());
  }
  const auto a = BuildEdges(mesh.triangles, Identity(mesh.positions.size()));
  const auto b = BuildEdges(shuffled, Identity(mesh.positions.size()));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t e = 0; e < a.size(); ++e) {
    ASSERT_EQ(a[e].corners_left, b[e].corners_left);
    ASSERT_EQ(a[e].corners_right, b[e].corners_right);
  }
}

TEST(Degenerate, FindsThinTrianglesAndKeepsSmallOnes) {
  const std::vector<glm::vec3> p = {{0, 0, 0}, {1e-20f, 0, 0}, {0, 1e-20f, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  EXPECT_THAT(FindDegenerate(Triangles{0, 1, 2, 3, 4, 5, 0, 0, 3, 0, 3, 4}, p), ElementsAre(0, 1, 1, 1));
}

}  // namespace
}  // namespace burin::geometry
