// SPDX-License-Identifier: Apache-2.0
#include "core/scene/morph_to_sphere.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

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

}  // namespace
}  // namespace burin::scene
