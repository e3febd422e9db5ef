// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/slivers.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "core/geometry/weld.h"

namespace burin::overdraw {
namespace {

/// A triangle in the plane z = 0, and beside it one that is `height` high over their common edge of length 1 and turned
/// upwards by 45 degrees.
struct Pair {
  explicit Pair(float height)
      : positions{{0, 0, 0}, {1, 0, 0}, {0.5f, -1, 0}, {0.5f, 0.7071f * height, 0.7071f * height}},
        triangles{1, 0, 2, 0, 1, 3},
        edges(geometry::BuildEdges(triangles, geometry::WeldPositions(positions), {})) {
    ComputeFacePlanes(triangles, positions, {}, planes);
  }
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> triangles;
  std::vector<geometry::Edge> edges;
  FacePlanes planes;
};

constexpr glm::vec3 kUp(0.0f, 0.0f, 1.0f);

TEST(Slivers, ThinTrianglesThatTiltLookWhereTheSurfaceDoes) {
  Pair pair(0.05f);
  ASSERT_NEAR(std::abs(pair.planes.Normal(1).z), 0.7071f, 1e-3f);
  const std::vector<glm::vec3> normals(4, kUp);
  TurnSlivers(pair.triangles, pair.positions, normals, pair.edges, pair.planes);
  EXPECT_EQ(pair.planes.Normal(1), pair.planes.Normal(0));
}

TEST(Slivers, ThinTrianglesAlongTheSurfaceKeepTheirPlane) {
  Pair pair(0.05f);
  const glm::vec3 own = pair.planes.Normal(1);
  TurnSlivers(pair.triangles, pair.positions, std::vector<glm::vec3>(4, own), pair.edges, pair.planes);
  EXPECT_EQ(pair.planes.Normal(1), own);
  TurnSlivers(pair.triangles, pair.positions, {}, pair.edges, pair.planes);
  EXPECT_EQ(pair.planes.Normal(1), own) << "nothing says where the surface looks";
}

TEST(Slivers, WellShapedTrianglesKeepTheirPlane) {
  Pair pair(0.3f);
  const glm::vec3 own = pair.planes.Normal(1);
  TurnSlivers(pair.triangles, pair.positions, std::vector<glm::vec3>(4, kUp), pair.edges, pair.planes);
  EXPECT_EQ(pair.planes.Normal(1), own);
}

TEST(Slivers, TrianglesThinnerThanAThousandthNeedNoNormals) {
  Pair pair(0.0005f);
  TurnSlivers(pair.triangles, pair.positions, {}, pair.edges, pair.planes);
  EXPECT_EQ(pair.planes.Normal(1), pair.planes.Normal(0));
}

}  // namespace
}  // namespace burin::overdraw
