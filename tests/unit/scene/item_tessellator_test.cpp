// SPDX-License-Identifier: Apache-2.0
#include "core/scene/item_tessellator.h"

#include <gmock/gmock.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "core/scene/item_geometry.h"
#include "tests/support/patch_models.h"
#include "tests/support/triangle_mesh.h"
#include "tests/unit/scene/scene_fixture.h"

namespace burin::scene {
namespace {

using enum TessellationMode;

Primitive Ball() {
  test::TriangleMesh mesh = test::Icosphere(1);
  Primitive primitive;
  primitive.positions = mesh.positions;
  primitive.normals = mesh.positions;
  primitive.indices = mesh.triangles;
  return primitive;
}

Primitive Points() {
  Primitive points;
  points.mode = PrimitiveMode::kPoints;
  points.positions = {{0, 0, 0}};
  points.indices = {0};
  return points;
}

Scene SceneOf(std::vector<Primitive> primitives) {
  Scene scene;
  scene.meshes.push_back({.name = "m", .primitives = std::move(primitives), .weights = {}});
  Node node;
  node.mesh = 0;
  scene.nodes.push_back(node);
  scene.roots = {0};
  return scene;
}

std::vector<DrawItem> ItemsOf(const Scene& scene) {
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  return BuildDrawItems(scene, pose, pose);
}

View From(float distance) {
  View view;
  view.clip_from_view = glm::perspectiveRH_ZO(0.8f, 1.0f, 0.1f, 100.0f);
  view.view_from_world = glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, -distance));
  return view;
}

TessellationOptions Options(TessellationMode mode, std::optional<float> factor = {}) {
  return {.mode = mode, .edge_length_px = {}, .factor = factor};
}

TEST(ItemTessellator, ByItselfOnlyPatchesAreCurved) {
  const Scene ball = SceneOf({Ball()});
  EXPECT_FALSE(ItemTessellator(ball, Options(kAuto)).is_active());
  EXPECT_TRUE(ItemTessellator(ball, Options(kAuto, 4.0f)).is_active());
  EXPECT_TRUE(ItemTessellator(ball, Options(kInteger)).is_active());
  EXPECT_FALSE(ItemTessellator(ball, Options(kOff, 4.0f)).is_active());
  const Scene pot = SceneOf({test::Pot()});
  EXPECT_TRUE(ItemTessellator(pot, Options(kAuto)).is_active());
  EXPECT_FALSE(ItemTessellator(pot, Options(kOff)).is_active());
}

TEST(ItemTessellator, AFixedFactorGivesTheClosedFormsCounts) {
  const Scene pot = SceneOf({test::Pot()});
  std::vector<DrawItem> items = ItemsOf(pot);
  ItemTessellator tessellator(pot, Options(kInteger, 5.0f));
  const auto counts = tessellator.Tessellate(From(6), 64, 64, items);
  ASSERT_TRUE(counts);
  EXPECT_EQ(counts->patches, pot.meshes[0].primitives[0].patches->patches.size());
  EXPECT_EQ(counts->triangles, 50 * counts->patches);
  EXPECT_EQ(GeometryOf(pot, items[0]).indices.size(), 3 * counts->triangles);
  EXPECT_EQ(items[0].first_primitive_id, 1u);
}

TEST(ItemTessellator, IdsRunOnAndPointsStayAsTheyAre) {
  const Scene scene = SceneOf({Ball(), Points(), Ball()});
  std::vector<DrawItem> items = ItemsOf(scene);
  ItemTessellator tessellator(scene, Options(kInteger, 2.0f));
  ASSERT_TRUE(tessellator.Tessellate(From(6), 64, 64, items));
  EXPECT_EQ(items[0].first_patch_id, 1u);
  EXPECT_EQ(items[1].surface, nullptr);
  EXPECT_EQ(items[1].first_patch_id, 0u);
  EXPECT_EQ(items[2].first_patch_id, 81u);
  const auto triangles = static_cast<std::uint32_t>(items[0].surface->triangles.indices.size() / 3);
  EXPECT_EQ(items[1].first_primitive_id, triangles + 1);
  EXPECT_EQ(items[2].first_primitive_id, triangles + 2);
}

TEST(ItemTessellator, NearerIsFiner) {
  const Scene pot = SceneOf({test::Pot()});
  ItemTessellator tessellator(pot, Options(kAuto));
  std::size_t last = 0;
  for (const float distance : {20.0f, 10.0f, 6.0f, 4.0f}) {
    std::vector<DrawItem> items = ItemsOf(pot);
    const auto counts = tessellator.Tessellate(From(distance), 2048, 2048, items);
    ASSERT_TRUE(counts);
    EXPECT_GT(counts->triangles, last);
    last = counts->triangles;
  }
}

TEST(ItemTessellator, WhatDoesNotChangeIsTheSameSurface) {
  const Scene scene = SceneOf({test::Pot(), Ball()});
  ItemTessellator tessellator(scene, Options(kFractional));
  std::vector<DrawItem> first = ItemsOf(scene), second = ItemsOf(scene), third = ItemsOf(scene);
  ASSERT_TRUE(tessellator.Tessellate(From(6), 1024, 1024, first));
  ASSERT_TRUE(tessellator.Tessellate(From(6), 1024, 1024, second));
  ASSERT_TRUE(tessellator.Tessellate(From(5), 1024, 1024, third));
  EXPECT_EQ(first[0].surface, second[0].surface);
  EXPECT_EQ(first[1].surface, second[1].surface);
  EXPECT_NE(first[0].surface, third[0].surface) << "and one that is still looked at is not written over";
}

TEST(ItemTessellator, MemoryIsUsedAgain) {
  const Scene pot = SceneOf({test::Pot()});
  ItemTessellator tessellator(pot, Options(kAuto));
  std::set<const ItemSurface*> seen;
  for (int i = 0; i < 20; ++i) {
    std::vector<DrawItem> items = ItemsOf(pot);
    ASSERT_TRUE(tessellator.Tessellate(From(4.0f + 0.1f * static_cast<float>(i)), 1024, 1024, items));
    seen.insert(items[0].surface.get());
  }
  EXPECT_LE(seen.size(), 2u);
}

TEST(ItemTessellator, OneFrameAloneHasTheBitsOfAFullRun) {
  const Scene scene = SceneOf({test::Pot(), Ball()});
  ItemTessellator run(scene, Options(kFractional)), alone(scene, Options(kFractional));
  std::vector<DrawItem> a = ItemsOf(scene), b = ItemsOf(scene);
  for (const float distance : {9.0f, 7.0f, 5.0f}) ASSERT_TRUE(run.Tessellate(From(distance), 700, 700, a));
  ASSERT_TRUE(alone.Tessellate(From(5.0f), 700, 700, b));
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].surface->triangles.positions, b[i].surface->triangles.positions);
    EXPECT_EQ(a[i].surface->triangles.indices, b[i].surface->triangles.indices);
  }
}

TEST(ItemTessellator, TooManyTrianglesAreRefusedBeforeTheyAreMade) {
  const Scene pot = SceneOf({test::Pot()});
  std::vector<DrawItem> items = ItemsOf(pot);
  ItemTessellator tessellator(pot, Options(kInteger, 256.0f));
  const auto counts = tessellator.Tessellate(From(6), 64, 64, items);
  ASSERT_FALSE(counts);
  EXPECT_EQ(counts.error().kind, ErrorKind::kFailed);
  EXPECT_EQ(counts.error().message,
            "tessellation: 67108864 triangles in a frame, over the limit of 32000000; a longer --edge-length or a "
            "smaller --tessellation-factor gives fewer");
}

TEST(ItemTessellator, BoundsAreThoseOfTheSurface) {
  const Scene pot = SceneOf({test::Pot()});
  std::vector<DrawItem> items = ItemsOf(pot);
  ItemTessellator tessellator(pot, Options(kAuto));
  ASSERT_TRUE(tessellator.TessellateEvenly(8.0f, items));
  const Bounds bounds = ComputeBounds(pot, items);
  EXPECT_LT(bounds.max.x, 1.5f) << "inside the cage";
  EXPECT_GT(bounds.max.x, 1.2f);
}

TEST(ItemTessellator, AFlatMeshWithoutNormalsBecomesRound) {
  Primitive ball = Ball();
  ball.normals.clear();
  Scene scene = SceneOf({ball});
  scene.meshes[0].primitives[0].normals.assign(ball.positions.size(), glm::vec3(0, 0, 1));
  scene.meshes[0].primitives[0].has_made_normals = true;
  std::vector<DrawItem> items = ItemsOf(scene);
  ItemTessellator tessellator(scene, Options(kFractional, 6.0f));
  ASSERT_TRUE(tessellator.Tessellate(From(6), 64, 64, items));
  float least = 1.0f;
  for (const glm::vec3& p : items[0].surface->triangles.positions) least = std::min(least, glm::length(p));
  EXPECT_GT(least, 0.99f) << "the flat triangles come within 0.94 of the middle";
}

}  // namespace
}  // namespace burin::scene
