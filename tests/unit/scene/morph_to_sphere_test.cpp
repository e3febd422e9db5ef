// SPDX-License-Identifier: Apache-2.0
#include "core/scene/morph_to_sphere.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/scene/item_geometry.h"
#include "core/scene/item_tessellator.h"
#include "core/scene/patch_primitive.h"

namespace burin::scene {
namespace {

/// A lopsided tetrahedron with normals of its own corners.
Scene Tetrahedron() {
  Scene scene;
  Primitive primitive;
  primitive.positions = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}, {0, 0, 1}, {0.5f, 0.75f, 0.125f}};
  primitive.normals = {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6f, 0.0f, 0.8f}};
  primitive.indices = {0, 2, 1, 0, 1, 3, 1, 2, 4};
  scene.meshes.emplace_back();
  scene.meshes[0].primitives.push_back(primitive);
  scene.nodes.emplace_back();
  scene.nodes[0].mesh = 0;
  scene.roots = {0};
  return scene;
}

std::vector<DrawItem> Items(const Scene& scene, float amount) {
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  std::vector<DrawItem> items = BuildDrawItems(scene, pose, pose);
  MorphToSphere(scene, amount, items);
  return items;
}

const glm::vec3 kCenter(1.0f, 2.0f, 0.5f);

TEST(MorphToSphere, NothingIsTouchedAtZero) { EXPECT_FALSE(Items(Tetrahedron(), 0.0f)[0].is_deformed); }

TEST(MorphToSphere, EveryVertexIsOnTheSphereAtOne) {
  const Scene scene = Tetrahedron();
  const std::vector<DrawItem> items = Items(scene, 1.0f);
  float radius = 0.0f;
  for (const glm::vec3& p : scene.meshes[0].primitives[0].positions)
    radius = std::max(radius, glm::distance(p, kCenter));
  for (std::size_t i = 0; i < items[0].deformed.positions.size(); ++i) {
    EXPECT_NEAR(glm::distance(items[0].deformed.positions[i], kCenter), radius, 1e-5f);
    const glm::vec3 outwards = glm::normalize(items[0].deformed.positions[i] - kCenter);
    EXPECT_NEAR(std::abs(glm::dot(items[0].deformed.normals[i], outwards)), 1.0f, 1e-5f);
  }
}

// A normal is orthogonal to what two directions in the surface become, by differences of the map.
TEST(MorphToSphere, NormalsFollowTheMap) {
  Scene scene = Tetrahedron();
  Primitive& primitive = scene.meshes[0].primitives[0];
  const glm::vec3 p = primitive.positions[4];
  const glm::vec3 n = primitive.normals[4];
  const glm::vec3 u = glm::normalize(glm::cross(n, glm::vec3(0, 1, 0)));
  const glm::vec3 v = glm::cross(n, u);
  constexpr float kStep = 0.01f;
  primitive.positions.insert(primitive.positions.end(), {p + kStep * u, p - kStep * u, p + kStep * v, p - kStep * v});
  primitive.normals.resize(primitive.positions.size(), n);
  const DeformedVertices moved = Items(scene, 0.6f)[0].deformed;
  const glm::vec3 du = glm::normalize(moved.positions[5] - moved.positions[6]);
  const glm::vec3 dv = glm::normalize(moved.positions[7] - moved.positions[8]);
  EXPECT_NEAR(glm::dot(moved.normals[4], du), 0.0f, 2e-3f);
  EXPECT_NEAR(glm::dot(moved.normals[4], dv), 0.0f, 2e-3f);
  EXPECT_NEAR(glm::length(moved.normals[4]), 1.0f, 1e-5f);
}

TEST(MorphToSphere, VelocitiesSeeTheSameMap) {
  const DeformedVertices moved = Items(Tetrahedron(), 0.5f)[0].deformed;
  EXPECT_EQ(moved.positions, moved.previous_positions);
}

/// One bilinear patch, from (-1, -1, 0) to (1, 1, 0), bent at one corner.
Scene PatchScene() {
  geometry::BezierPatches patches;
  patches.positions = {{-1, -1, 0, 1}, {1, -1, 0, 1}, {-1, 1, 0, 1}, {1, 1, 1, 1}};
  geometry::BezierPatch patch;
  patch.position = {.first = 0, .u_order = 2, .v_order = 2};
  patches.patches.push_back(patch);
  Scene scene;
  scene.meshes.emplace_back();
  scene.meshes[0].primitives.push_back(MakePatchPrimitive(std::move(patches), kNone));
  scene.nodes.emplace_back();
  scene.nodes[0].mesh = 0;
  scene.roots = {0};
  return scene;
}

// Patches have no vertices of their own before they are tessellated.
TEST(MorphToSphere, SurfacesOfPatchesAreMovedAfterTessellation) {
  const Scene scene = PatchScene();
  ItemTessellator tessellator(scene, {.mode = TessellationMode::kInteger, .edge_length_px = {}, .factor = 4.0f});
  SphereMorph morph(1.0f);
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  std::vector<DrawItem> items;
  std::shared_ptr<const ItemSurface> first;
  for (int frame = 0; frame < 2; ++frame) {
    UpdateDrawItems(scene, pose, pose, items, true);
    morph.MoveVertices(scene, items);
    ASSERT_TRUE(tessellator.TessellateEvenly(4.0f, items));
    const std::vector<glm::vec3> before = items[0].surface->triangles.positions;
    morph.MoveSurfaces(scene, items);
    const tessellation::Surface& moved = items[0].surface->triangles;
    ASSERT_EQ(moved.positions.size(), 25u);
    EXPECT_NE(moved.positions, before);
    for (std::size_t i = 0; i < moved.positions.size(); ++i) {
      const glm::vec3 out = moved.positions[i] - glm::vec3(0.0f, 0.0f, 0.5f);
      EXPECT_NEAR(glm::length(out), 1.5f, 1e-5f);
      EXPECT_NEAR(std::abs(glm::dot(moved.normals[i], out)), 1.5f, 1e-4f);
    }
    if (frame == 0) first = items[0].surface;
  }
  EXPECT_EQ(items[0].surface, first);  // what stands still is moved once
}

}  // namespace
}  // namespace burin::scene
