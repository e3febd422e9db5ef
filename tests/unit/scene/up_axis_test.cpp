// SPDX-License-Identifier: Apache-2.0
#include "core/scene/up_axis.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/scene/pose.h"

namespace burin::scene {
namespace {

Scene OneNode() {
  Scene scene;
  Node node;
  node.transform.translation = {1.0f, 2.0f, 3.0f};
  scene.nodes.push_back(node);
  scene.roots = {0};
  return scene;
}

glm::vec3 World(const Scene& scene, const glm::vec3& point) {
  return glm::vec3(EvaluatePose(scene, {}, 0.0).world_from_node.at(0) * glm::vec4(point, 1.0f));
}

TEST(UpAxis, PointsUpwardsAfterTheTurn) {
  const std::pair<UpAxis, glm::vec3> cases[] = {{UpAxis::kX, {1, 0, 0}}, {UpAxis::kMinusX, {-1, 0, 0}},
                                                {UpAxis::kY, {0, 1, 0}}, {UpAxis::kMinusY, {0, -1, 0}},
                                                {UpAxis::kZ, {0, 0, 1}}, {UpAxis::kMinusZ, {0, 0, -1}}};
  for (const auto& [axis, up] : cases) {
    Scene scene = OneNode();
    TurnUpwards(axis, scene);
    const glm::vec3 turned = World(scene, up) - World(scene, glm::vec3(0.0f));
    EXPECT_LT(glm::distance(turned, glm::vec3(0, 1, 0)), 1e-6f) << static_cast<int>(axis);
    // A turn, no mirror.
    const glm::vec3 o = World(scene, glm::vec3(0.0f));
    const glm::vec3 x = World(scene, {1, 0, 0}) - o, y = World(scene, {0, 1, 0}) - o, z = World(scene, {0, 0, 1}) - o;
    EXPECT_NEAR(glm::dot(glm::cross(x, y), z), 1.0f, 1e-6f);
  }
}

TEST(UpAxis, LeavesScenesThatStandUprightAsTheyAre) {
  Scene scene = OneNode();
  TurnUpwards(UpAxis::kY, scene);
  EXPECT_EQ(scene.nodes.size(), 1u);
  EXPECT_EQ(scene.roots, std::vector<int>{0});
}

}  // namespace
}  // namespace burin::scene
