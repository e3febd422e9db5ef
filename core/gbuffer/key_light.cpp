// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/key_light.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "core/gbuffer/environment.h"
#include "core/scene/shown_nodes.h"

namespace burin::gbuffer {
std::vector<int> LightNodes(const scene::Scene& scene) {
  const std::vector<bool> shown = scene::ShownNodes(scene);
  std::vector<int> nodes;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const int light = scene.nodes[i].light;
    if (shown[i] && light >= 0 && static_cast<std::size_t>(light) < scene.lights.size())
      nodes.push_back(static_cast<int>(i));
  }
  return nodes;
}

KeyLight FindKeyLight(const scene::Scene& scene, const scene::Pose& pose) {
  const std::vector<int> nodes = LightNodes(scene);
  if (nodes.empty()) {
    KeyLight studio;
    studio.direction = -StudioKeyDirection();
    return studio;
  }
  const auto node = static_cast<std::size_t>(nodes.front());
  const scene::Light& light = scene.lights[static_cast<std::size_t>(scene.nodes[node].light)];
  const glm::mat4& world = pose.world_from_node.at(node);
  const glm::vec3 axis = -glm::vec3(world[2]);
  KeyLight key;
  key.type = light.type;
  key.position = glm::vec3(world[3]);
  if (glm::dot(axis, axis) > 0.0f) key.direction = glm::normalize(axis);
  key.color = light.color;
  return key;
}

}  // namespace burin::gbuffer
