// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/extract_edges.h"

#include <gmock/gmock.h>

#include <cmath>
#include <glm/matrix.hpp>
#include <limits>

#include "tests/support/triangle_mesh.h"

namespace burin::overdraw {
namespace {

/// Two faces along y whose normals lean 45 degrees to either side of z: left towards -x, right towards +x. The ridge,
/// the one edge between them, is a crease.
class Ridge : public ::testing::Test {
 protected:
  void Build(EdgeMeshOptions options = {.crease_angle_deg = 30}) {
    std::vector<std::uint8_t> sides = {double_sided_left_, double_sided_right_};
    mesh_ = *BuildEdgeMesh({.name = "ridge",
                            .positions = positions_,
                            .triangles = triangles_,
                            .face_materials = materials_,
                            .face_double_sided = sides},
                           options);
    for (ridge_ = 0; mesh_.edges[ridge_].right == geometry::kNoFace;) ++ridge_;
  }
  /// The ridge as it is drawn; nothing if it isn't.
  [[nodiscard]] std::optional<RenderedEdge> Drawn(const EdgeView& view) {
    std::vector<RenderedEdge> edges;
    ExtractEdges(mesh_, view, edges, statistics_);
    for (const RenderedEdge& e : edges) {
      if (e.edge == ridge_) return e;
    }
    return std::nullopt;
  }
  /// From the direction `angle_deg` from z towards +x, at distance 10.
  [[nodiscard]] static EdgeView From(float angle_deg) {
    const float a = angle_deg * 0.017453293f;
    return {.eye = {10 * std::sin(a), 0.5f, 10 * std::cos(a), 1}};
  }
  /// Shares as if left were the face that leans towards -x.
  [[nodiscard]] float ShareOfPositiveX(const RenderedEdge& e) const {
    return mesh_.planes.Normal(mesh_.edges[e.edge].right).x > 0 ? e.beta : 1 - e.beta;
  }

  std::vector<glm::vec3> positions_ = {{0, 0, 0}, {0, 1, 0}, {-1, 0, -1}, {1, 0, -1}};
  std::vector<std::uint32_t> triangles_ = {0, 1, 2, 1, 0, 3};
  std::vector<int> materials_;
  std::uint8_t double_sided_left_ = 0, double_sided_right_ = 0;
  EdgeMesh mesh_;
  std::uint32_t ridge_ = 0;
  EdgeStatistics statistics_;
};

TEST_F(Ridge, TakesTheLeftFaceUntilNearTheSilhouette) {
  Build();
  const geometry::Edge& edge = mesh_.edges[ridge_];
  ASSERT_LT(mesh_.planes.Normal(edge.left).x * mesh_.planes.Normal(edge.right).x, 0);
  const float to_right = mesh_.planes.Normal(edge.right).x > 0 ? 1.0f : -1.0f;
  // beta = cos(45 - t) / (cos(45 + t) + cos(45 - t)) = (1 + tan t) / 2, t towards the right face.
  const auto even = Drawn(From(0));
  ASSERT_TRUE(even);
  EXPECT_EQ(even->cls, EdgeClass::kCrease);
  EXPECT_EQ(even->beta, 0.0f);
  EXPECT_FALSE(even->is_sorted);
  const float t = 42.0f;
  const auto near = Drawn(From(to_right * t));
  ASSERT_TRUE(near);
  const float beta = 0.5f * (1 + std::tan(t * 0.017453293f));
  EXPECT_NEAR(near->beta, (beta - 0.9f) / 0.1f, 1e-4f);
  EXPECT_TRUE(near->is_sorted);
  EXPECT_EQ(statistics_.blended, 1u);
  const auto other = Drawn(From(-to_right * t));
  ASSERT_TRUE(other);
  EXPECT_EQ(other->beta, 0.0f);
  EXPECT_TRUE(other->is_sorted) << "beta below 0.1";
}

TEST_F(Ridge, TauMovesTheStartOfBlending) {
  Build();
  const float to_right = mesh_.planes.Normal(mesh_.edges[ridge_].right).x > 0 ? 1.0f : -1.0f;
  EdgeView view = From(to_right * 20);
  const float beta = 0.5f * (1 + std::tan(20 * 0.017453293f));
  view.tau = 0.5f;
  EXPECT_NEAR(Drawn(view)->beta, (beta - 0.5f) / 0.5f, 1e-4f);
  view.tau = 0.0f;
  EXPECT_NEAR(Drawn(view)->beta, beta, 1e-4f);
  view.tau = 1.0f;
  EXPECT_EQ(Drawn(view)->beta, 0.0f);
}

TEST_F(Ridge, SilhouetteTakesItsFrontFaceAlone) {
  Build();
  for (const float angle : {60.0f, -60.0f}) {
    const auto e = Drawn(From(angle));
    ASSERT_TRUE(e);
    EXPECT_EQ(e->cls, EdgeClass::kSilhouette);
    EXPECT_EQ(mesh_.kinds[e->edge], EdgeKind::kCrease) << "its kind is kept apart";
    EXPECT_EQ(ShareOfPositiveX(*e), angle > 0 ? 1.0f : 0.0f);
    EXPECT_NE(e->is_front_left, e->is_front_right);
    EXPECT_TRUE(e->is_sorted);
  }
}

TEST_F(Ridge, IsNotDrawnFromBehindUnlessAFaceShowsThere) {
  Build();
  EXPECT_FALSE(Drawn(From(180)));
  Build({.crease_angle_deg = 30, .shows_back_faces = true});
  EXPECT_TRUE(Drawn(From(180)));
  double_sided_left_ = double_sided_right_ = 1;
  Build();
  const auto e = Drawn(From(180));
  ASSERT_TRUE(e);
  EXPECT_EQ(e->cls, EdgeClass::kCrease);
  EXPECT_FALSE(e->is_front_left || e->is_front_right);
  double_sided_left_ = 0;
  Build();
  const auto one = Drawn(From(180));
  ASSERT_TRUE(one);
  const bool double_is_right = mesh_.edges[ridge_].right == 1;
  EXPECT_EQ(one->beta, double_is_right ? 1.0f : 0.0f) << "the face that is on screen";
}

TEST_F(Ridge, ValleySilhouetteTakesTheBackFaceWhereItShows) {
  // The same faces turned over are a valley, seen from +x past the right wall's back.
  triangles_ = {1, 0, 2, 0, 1, 3};
  const EdgeView view = {.eye = {10, 0.5f, -5, 1}};
  Build();
  const auto single = Drawn(view);
  ASSERT_TRUE(single);
  EXPECT_EQ(single->cls, EdgeClass::kSilhouette);
  EXPECT_EQ(single->beta, single->is_front_right ? 1.0f : 0.0f) << "culled back faces hide nothing";
  double_sided_left_ = double_sided_right_ = 1;
  Build();
  const auto both = Drawn(view);
  ASSERT_TRUE(both);
  EXPECT_EQ(both->beta, both->is_front_right ? 0.0f : 1.0f) << "the wall nearer to the eye shows its back";
}

TEST_F(Ridge, BlendsByWorldAnglesUnderNonUniformScale) {
  Build();
  const float to_right = mesh_.planes.Normal(mesh_.edges[ridge_].right).x > 0 ? 1.0f : -1.0f;
  // World: three times as long along (1, 0, 1), which is across one face and in the other. The eye is in object space.
  const glm::dvec3 along = glm::normalize(glm::dvec3(1, 0, 1));
  const glm::dmat3 world = glm::dmat3(1) + 2.0 * glm::outerProduct(along, along);
  const glm::dmat3 normals = glm::transpose(glm::inverse(world));
  const EdgeView view{.eye = {to_right * 2.0f, 0.5f, 9.0f, 1}, .normal_matrix = glm::mat3(normals), .tau = 0.0f};
  const glm::dvec3 v = world * glm::dvec3(to_right * 2.0, 0, 9);
  const auto cosine = [&](std::uint32_t face) {
    return glm::dot(v, glm::normalize(normals * glm::dvec3(mesh_.planes.Normal(face))));
  };
  const double l = cosine(mesh_.edges[ridge_].left), r = cosine(mesh_.edges[ridge_].right);
  EXPECT_NEAR(Drawn(view)->beta, r / (l + r), 1e-5);
  EXPECT_NEAR(Drawn(view)->distance2, glm::dot(v, v), 1e-3) << "world distance to the midpoint";
}

TEST_F(Ridge, MirroredTransformShowsTheSameFaces) {
  Build();
  EdgeView view = From(60);
  const auto plain = Drawn(view);
  view.normal_matrix[0][0] = -1;
  const auto mirrored = Drawn(view);
  ASSERT_TRUE(plain && mirrored);
  EXPECT_EQ(plain->beta, mirrored->beta);
  EXPECT_EQ(plain->is_front_left, mirrored->is_front_left);
  EXPECT_EQ(plain->distance2, mirrored->distance2);
}

TEST_F(Ridge, SingularTransformCountsAsTheIdentity) {
  Build();
  EdgeView view = From(0);
  view.normal_matrix = glm::mat3(0);
  EXPECT_NEAR(Drawn(view)->distance2, 100.0f, 1e-3f);
  view.normal_matrix = glm::mat3(std::numeric_limits<float>::quiet_NaN());
  EXPECT_NEAR(Drawn(view)->distance2, 100.0f, 1e-3f);
}

TEST_F(Ridge, OrthographicViewMeasuresAlongTheDirection) {
  Build();
  EdgeView view{.eye = {0, 0, 2, 0}, .eye_distance = 5};
  const auto e = Drawn(view);
  ASSERT_TRUE(e);
  EXPECT_NEAR(e->distance2, 25.0f, 1e-4f);
  view.eye_distance = -3;
  EXPECT_NEAR(Drawn(view)->distance2, -9.0f, 1e-4f) << "behind the plane sorts as nearer";
}

TEST_F(Ridge, MaterialAndSeamKeepTheirClass) {
  materials_ = {0, 1};
  Build();
  EXPECT_EQ(Drawn(From(0))->cls, EdgeClass::kMaterial);
}

TEST_F(Ridge, BoundariesAreSilhouettesOfTheirFaceInEveryViewThatShowsIt) {
  Build();
  std::ignore = Drawn(From(0));
  EXPECT_EQ(statistics_.boundaries, 4u);
  EXPECT_EQ(statistics_.silhouettes, 4u);
  EXPECT_EQ(statistics_.rendered, 5u);
  std::ignore = Drawn(From(60));
  EXPECT_EQ(statistics_.silhouettes, 2u) << "of the front face";
}

TEST(ExtractEdges, SortsWhatCanHideOthersBackToFrontAndLast) {
  const test::TriangleMesh torus = test::Torus(40, 20);
  const EdgeMesh mesh = *BuildEdgeMesh({.name = "torus", .positions = torus.positions, .triangles = torus.triangles},
                                       {.crease_angle_deg = 9, .least_tree_edges = 1});
  std::vector<RenderedEdge> edges, unsorted;
  EdgeStatistics statistics;
  ExtractEdges(mesh, {.eye = {2, 3, 1, 1}}, edges, statistics);
  ASSERT_GT(statistics.sorted, 100u);
  ASSERT_GT(statistics.rendered - statistics.sorted, 100u);
  const std::size_t first = statistics.rendered - statistics.sorted;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    ASSERT_EQ(edges[i].is_sorted, i >= first);
    if (i > first) {
      ASSERT_GE(edges[i - 1].distance2, edges[i].distance2);
    }
  }
  ExtractEdges(mesh, {.eye = {2, 3, 1, 1}, .sorted = false}, unsorted, statistics);
  EXPECT_EQ(unsorted.size(), edges.size());
  EXPECT_EQ(statistics.sorted, 0u);
}

TEST(ExtractEdges, CubeShowsAsManyCreasesAsItsViewHas) {
  const test::TriangleMesh cube = test::Cube();
  const EdgeMesh mesh = *BuildEdgeMesh(
      {.name = "cube", .positions = cube.positions, .normals = cube.normals, .triangles = cube.triangles});
  EdgeStatistics statistics;
  std::vector<RenderedEdge> edges;
  const auto count = [&](const glm::vec4& eye) {
    ExtractEdges(mesh, {.eye = eye}, edges, statistics);
    return edges.size();
  };
  EXPECT_EQ(count({0, 0, 5, 1}), 4u);
  EXPECT_EQ(count({0, 5, 5, 1}), 7u);
  EXPECT_EQ(count({5, 5, 5, 1}), 9u);
  EXPECT_EQ(count({0, 0, 1, 0}), 4u);
  EXPECT_EQ(count({1, 1, 1, 0}), 9u);
  EXPECT_EQ(count({0, 0, 0, 1}), 0u) << "from inside no single-sided face shows";
  EXPECT_EQ(statistics.way, SilhouetteWay::kScan);
}

TEST(ExtractEdges, DeformationFollowsPositionsAndDropsTheTree) {
  const test::TriangleMesh sphere = test::Icosphere(4);
  EdgeMesh mesh = *BuildEdgeMesh({.name = "sphere", .positions = sphere.positions, .triangles = sphere.triangles},
                                 {.least_tree_edges = 1});
  ASSERT_FALSE(mesh.tree.empty());
  std::vector<glm::vec3> moved = sphere.positions;
  for (glm::vec3& p : moved) p.z *= 0.01f;
  UpdateDeformed(mesh, moved);
  std::vector<RenderedEdge> edges;
  EdgeStatistics statistics;
  ExtractEdges(mesh, {.eye = {0, 0, 30, 1}}, edges, statistics);
  EXPECT_EQ(statistics.way, SilhouetteWay::kScan);
  ASSERT_GT(edges.size(), 20u);
  for (const RenderedEdge& e : edges) EXPECT_LT(std::abs(mesh.Midpoint(mesh.edges[e.edge]).z), 0.002f);
  moved[7].x = std::numeric_limits<float>::quiet_NaN();
  UpdateDeformed(mesh, moved);
  ExtractEdges(mesh, {.eye = {0, 0, 30, 1}}, edges, statistics);
  EXPECT_GT(edges.size(), 20u);
}

}  // namespace
}  // namespace burin::overdraw
