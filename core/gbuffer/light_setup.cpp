// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/light_setup.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "core/gbuffer/key_light.h"

namespace burin::gbuffer {
namespace {

glm::vec3 AxisOf(const glm::mat4& world) {
  const glm::vec3 axis = -glm::vec3(world[2]);
  return glm::dot(axis, axis) > 0.0f ? glm::normalize(axis) : glm::vec3(0.0f, 0.0f, -1.0f);
}

const scene::Light& LightOf(const scene::Scene& scene, int node) {
  return scene.lights[static_cast<std::size_t>(scene.nodes[static_cast<std::size_t>(node)].light)];
}

// KHR_lights_punctual, "Inner and Outer Cone Angles".
glm::vec4 ConeOf(const scene::Light& light) {
  const float outer = std::cos(light.outer_cone_rad);
  const float scale = 1.0f / std::max(0.001f, std::cos(light.inner_cone_rad) - outer);
  return {scale, -outer * scale, 0.0f, 0.0f};
}

}  // namespace

std::vector<LightRecord> BuildLights(const scene::Scene& scene, const scene::Pose& pose, float exposure) {
  std::vector<LightRecord> records;
  for (const int node : LightNodes(scene)) {
    const scene::Light& light = LightOf(scene, node);
    const glm::mat4& world = pose.world_from_node.at(static_cast<std::size_t>(node));
    const float window = light.range && *light.range > 0.0f ? 1.0f / (*light.range * *light.range) : 0.0f;
    records.push_back({.position = glm::vec4(glm::vec3(world[3]), window),
                       .direction = glm::vec4(AxisOf(world), static_cast<float>(light.type)),
                       .color = glm::vec4(light.color * (light.intensity * exposure), 0.0f),
                       .cone = ConeOf(light)});
  }
  return records;
}

float LightExposure(const scene::Scene& scene) {
  const std::vector<int> nodes = LightNodes(scene);
  if (nodes.empty()) return 1.0f;
  const scene::Pose rest = scene::EvaluatePose(scene, {}, 0.0);
  const scene::Bounds bounds = scene::ComputeBounds(scene, scene::BuildDrawItems(scene, rest, rest));
  const glm::vec3 center = bounds.empty() ? glm::vec3(0.0f) : 0.5f * (bounds.min + bounds.max);
  const float radius = bounds.empty() ? 1.0f : 0.5f * glm::distance(bounds.min, bounds.max);

  float illuminance = 0.0f;
  for (const int node : nodes) {
    const scene::Light& light = LightOf(scene, node);
    const float brightness = std::max({light.color.r, light.color.g, light.color.b}) * light.intensity;
    if (light.type == scene::LightType::kDirectional) {
      illuminance += brightness;
      continue;
    }
    // A lamp amid the scene lights surfaces about half the scene's radius away.
    const float away = glm::distance(center, glm::vec3(rest.world_from_node[static_cast<std::size_t>(node)][3]));
    const float distance = std::max({away, 0.5f * radius, 1e-4f});
    illuminance += brightness / (distance * distance);
  }
  constexpr float kWhite = glm::pi<float>();
  return illuminance > kWhite ? kWhite / illuminance : 1.0f;
}

}  // namespace burin::gbuffer
