// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <glm/geometric.hpp>

#include "core/scene/pose.h"
#include "scene_fixture.h"

namespace burin::scene {
namespace {

constexpr float kTolerance = 2e-6f;

void ExpectNear(const glm::vec3& a, const glm::vec3& b) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], kTolerance) << c;
}

/// The node's item (a copy: callers pass temporaries), or a failure.
DrawItem ItemOf(const std::vector<DrawItem>& items, int node) {
  for (const DrawItem& item : items) {
    if (item.node == node) return item;
  }
  ADD_FAILURE() << "no item for node " << node;
  return {};
}

TEST(DrawItems, NumberObjectsMaterialsAndPrimitives) {
  const Scene scene = ReadOrDie(DataPath("everything.gltf"));
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  const std::vector<DrawItem> items = BuildDrawItems(scene, pose, pose);
  ASSERT_EQ(items.size(), 3u) << "the hidden node is not drawn";
  EXPECT_EQ(items[0].node, 0);
  EXPECT_EQ(items[0].object_id, 1u);
  EXPECT_EQ(items[0].material_id, 1u);
  EXPECT_EQ(items[0].first_primitive_id, 1u);
  EXPECT_EQ(items[1].object_id, 2u);
  EXPECT_EQ(items[1].material_id, 2u);
  EXPECT_EQ(items[1].first_primitive_id, 3u) << "after the square's two triangles";
  EXPECT_EQ(items[2].object_id, 3u);
  EXPECT_EQ(items[2].material_id, 0u) << "the default material";
  EXPECT_EQ(items[2].first_primitive_id, 4u);
  for (const DrawItem& item : items) {
    EXPECT_FALSE(item.is_deformed);
    EXPECT_TRUE(item.deformed.positions.empty());
    EXPECT_EQ(item.world_from_object, pose.world_from_node[static_cast<std::size_t>(item.node)]);
  }
}

TEST(DrawItems, PutSkinnedVerticesInWorldSpace) {
  const Scene scene = ReadOrDie(DataPath("rig.glb"));
  const Pose rest = EvaluatePose(scene, {}, 0.0);
  const DrawItem item = ItemOf(BuildDrawItems(scene, rest, rest), 5);
  EXPECT_TRUE(item.is_deformed);
  EXPECT_EQ(item.world_from_object, glm::mat4(1.0f)) << "a skin ignores its node's translation by 50";
  const Primitive& strip = scene.meshes[0].primitives[0];
  for (std::size_t i = 0; i < 8; ++i) ExpectNear(item.deformed.positions[i], strip.positions[i]);
  // The mesh's default weight of target 0 is 0.5: its top corners rise by 0.5 and 1.
  ExpectNear(item.deformed.positions[8], {-0.5f, 4.5f, 0.0f});
  ExpectNear(item.deformed.positions[9], {0.5f, 5.0f, 0.0f});
}

TEST(DrawItems, BlendJointsLinearly) {
  const Scene scene = ReadOrDie(DataPath("rig.glb"));
  const Pose bent = EvaluatePose(scene, {0}, 1.0);
  const DrawItem item = ItemOf(BuildDrawItems(scene, bent, bent), 5);
  // At 1 s joint 2, at (0, 2, 0), is turned by 90 degrees, and the weights are 0.5 and 1: each vertex is first moved by
  // target 1, (0, 0, 1). A vertex (x, 2, 1) of row 2 follows joint 2 by 0.75, to (0, 2 + x, 1), and joint 1 by 0.25, to
  // itself.
  ExpectNear(item.deformed.positions[4], {0.25f * -0.5f, 0.75f * 1.5f + 0.25f * 2.0f, 1.0f});
  ExpectNear(item.deformed.positions[5], {0.25f * 0.5f, 0.75f * 2.5f + 0.25f * 2.0f, 1.0f});
  // Row 3 follows joints 3 and 2, both turned about (0, 2, 0): (x, 3, 1) to (-1, 2 + x, 1).
  ExpectNear(item.deformed.positions[6], {-1.0f, 1.5f, 1.0f});
  // Its normal, (0, 0, 1) + (1, 0, -1), points along x, turned along y.
  ExpectNear(item.deformed.normals[6], {0.0f, 1.0f, 0.0f});
}

TEST(DrawItems, UseAllEightJoints) {
  Scene scene = ReadOrDie(DataPath("rig.glb"));
  scene.nodes[1].transform.translation = {8.0f, 1.0f, 0.0f};
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  const DrawItem item = ItemOf(BuildDrawItems(scene, pose, pose), 5);
  // Row 0: 0.5 of joint 0 in the first set, 0.25 of joints 0 and 1 each in the second: a quarter of joint 1's way.
  ExpectNear(item.deformed.positions[0], {-0.5f + 2.0f, 0.0f, 0.0f});
}

TEST(DrawItems, KeepMorphedVerticesInObjectSpace) {
  const Scene scene = ReadOrDie(DataPath("rig.glb"));
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  const DrawItem item = ItemOf(BuildDrawItems(scene, pose, pose), 6);
  EXPECT_TRUE(item.is_deformed);
  EXPECT_EQ(item.world_from_object[3], glm::vec4(0, 0, 7, 1));
  ExpectNear(item.deformed.positions[0], {-0.5f, 0.0f, 1.0f});
  ExpectNear(item.deformed.normals[0], {1.0f, 0.0f, 0.0f});
}

TEST(DrawItems, RememberThePreviousPositions) {
  const Scene scene = ReadOrDie(DataPath("rig.glb"));
  const Pose now = EvaluatePose(scene, {0, 1}, 1.3);
  const Pose before = EvaluatePose(scene, {0, 1}, 1.2);
  const std::vector<DrawItem> items = BuildDrawItems(scene, now, before);
  const std::vector<DrawItem> earlier = BuildDrawItems(scene, before, before);
  for (const int node : {5, 6}) {
    const DrawItem item = ItemOf(items, node);
    EXPECT_EQ(item.deformed.previous_positions, ItemOf(earlier, node).deformed.positions);
    EXPECT_EQ(item.previous_world_from_object, ItemOf(earlier, node).world_from_object);
  }
  EXPECT_NE(ItemOf(items, 5).deformed.positions, ItemOf(items, 5).deformed.previous_positions);
}

TEST(DrawItems, UpdateGivesWhatBuildGives) {
  const Scene scene = ReadOrDie(DataPath("rig.glb"));
  std::vector<DrawItem> items;
  for (const double t : {0.0, 0.7, 1.9, 0.3}) {
    const Pose now = EvaluatePose(scene, {0, 1}, t);
    const Pose before = EvaluatePose(scene, {0, 1}, t - 0.1);
    UpdateDrawItems(scene, now, before, items);
    const std::vector<DrawItem> built = BuildDrawItems(scene, now, before);
    ASSERT_EQ(items.size(), built.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      EXPECT_EQ(items[i].deformed.positions, built[i].deformed.positions);
      EXPECT_EQ(items[i].deformed.previous_positions, built[i].deformed.previous_positions);
      EXPECT_EQ(items[i].deformed.normals, built[i].deformed.normals);
      EXPECT_EQ(items[i].world_from_object, built[i].world_from_object);
    }
  }
}

/// One triangle in the z = 0 plane on one joint, with a tangent along x.
Scene SkinnedTriangle(const glm::mat4& joint) {
  Scene scene;
  Primitive triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.normals.assign(3, glm::normalize(glm::vec3(1, 0, 1)));
  triangle.tangents.assign(3, glm::vec4(glm::normalize(glm::vec3(1, 0, -1)), 1.0f));
  triangle.joints[0].assign(3, glm::u16vec4(0));
  triangle.weights[0].assign(3, glm::vec4(1, 0, 0, 0));
  triangle.indices = {0, 1, 2};
  scene.meshes.emplace_back().primitives.push_back(triangle);
  scene.nodes.resize(2);
  scene.nodes[0].mesh = 0;
  scene.nodes[0].skin = 0;
  scene.nodes[1].matrix = joint;
  scene.skins.push_back({"", {1}, {glm::mat4(1.0f)}});
  scene.roots = {0, 1};
  return scene;
}

TEST(DrawItems, SendNormalsByTheInverseTranspose) {
  glm::mat4 stretch(1.0f);
  stretch[0][0] = 3.0f;
  const Scene scene = SkinnedTriangle(stretch);
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  const DeformedVertices d = BuildDrawItems(scene, pose, pose)[0].deformed;
  ExpectNear(d.normals[0], glm::normalize(glm::vec3(1.0f / 3.0f, 0, 1)));
  ExpectNear(glm::vec3(d.tangents[0]), glm::normalize(glm::vec3(3, 0, -1)));
  EXPECT_EQ(d.tangents[0].w, 1.0f);
}

TEST(DrawItems, MirrorNormalsAndTurnHandedness) {
  glm::mat4 mirror(1.0f);
  mirror[0][0] = -1.0f;
  Scene scene = SkinnedTriangle(mirror);
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  const DeformedVertices mirrored = BuildDrawItems(scene, pose, pose)[0].deformed;
  ExpectNear(mirrored.normals[0], glm::normalize(glm::vec3(-1, 0, 1)));
  EXPECT_EQ(mirrored.tangents[0].w, -1.0f);
  // Flat normals stay on their side, too: +z before, +z after.
  Primitive& triangle = scene.meshes[0].primitives[0];
  triangle.flat_normals = true;
  triangle.normals.assign(3, glm::vec3(0, 0, 1));
  triangle.tangents.clear();
  ExpectNear(BuildDrawItems(scene, pose, pose)[0].deformed.normals[0], {0, 0, 1});
}

TEST(DrawItems, RemakeFlatNormalsAfterAMorph) {
  Scene scene;
  Primitive triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.normals.assign(3, glm::vec3(0, 0, 1));
  triangle.flat_normals = true;
  triangle.indices = {0, 1, 2};
  triangle.targets.push_back({{{0, 0, 0}, {0, 0, 0}, {0, -1, 1}}, {}, {}});
  scene.meshes.push_back({"", {triangle}, {1.0f}});
  scene.nodes.emplace_back().mesh = 0;
  scene.roots = {0};
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  ExpectNear(BuildDrawItems(scene, pose, pose)[0].deformed.normals[1], {0, -1, 0});
}

TEST(ComputeBounds, FollowsEverySpace) {
  const Scene rig = ReadOrDie(DataPath("rig.glb"));
  const Pose rest = EvaluatePose(rig, {}, 0.0);
  const Bounds bounds = ComputeBounds(rig, BuildDrawItems(rig, rest, rest));
  ExpectNear(bounds.min, {-0.5f, 0.0f, 0.0f});
  ExpectNear(bounds.max, {0.5f, 5.0f, 8.0f});
  EXPECT_TRUE(ComputeBounds(rig, {}).empty());
}

}  // namespace
}  // namespace burin::scene
