// SPDX-License-Identifier: Apache-2.0
#include "core/effect/light_view.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace burin::effect {
namespace {

// How far away a light without a place is put: in the scene's radii, and in scene units where that is not known.
constexpr float kLightDistance = 4.0f;
constexpr float kFarLight = 1.0e4f;

constexpr float kWidestView_rad = 2.6f;

bool Eat(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

}  // namespace

std::optional<std::size_t> LightOf(std::string_view object) {
  for (const std::string_view kind : {"point", "spot", "directional", "dir", "distant"}) {
    if (Eat(object, kind)) break;
  }
  if (!Eat(object, "light") && !Eat(object, "lamp")) return std::nullopt;
  while (!object.empty() && (object.front() == '_' || object.front() == ' ')) object.remove_prefix(1);
  if (object.empty()) return 0;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(object.data(), object.data() + object.size(), number);
  if (error != std::errc() || end != object.data() + object.size()) return std::nullopt;
  return number;
}

std::optional<LightContext> LightAt(const FrameContext& context, std::size_t index) {
  if (index < context.lights.size() && index > 0) return context.lights[index];
  if (index > 0) return std::nullopt;
  LightContext key;
  if (!context.lights.empty()) key = context.lights.front();
  key.position = context.light_position_world;
  key.direction = context.light_direction_world;
  key.color = context.light_color;
  return key;
}

glm::vec3 PositionOf(const LightContext& light, const FrameContext& context) {
  if (light.position) return *light.position;
  if (context.scene_radius <= 0.0f) return light.direction * -kFarLight;
  return context.scene_center_world - light.direction * (kLightDistance * context.scene_radius);
}

glm::vec3 DirectionOf(const LightContext& light, const FrameContext& context) {
  if (!light.position || context.scene_radius <= 0.0f) return light.direction;
  const glm::vec3 towards = context.scene_center_world - *light.position;
  return glm::dot(towards, towards) > 0.0f ? glm::normalize(towards) : light.direction;
}

LightView LightViewOf(const FrameContext& context, std::size_t index) {
  const LightContext light = LightAt(context, index).value_or(*LightAt(context, 0));
  LightView view;
  view.eye_world = PositionOf(light, context);
  const glm::vec3 direction = DirectionOf(light, context);
  const float radius = context.scene_radius > 0.0f ? context.scene_radius : 1.0f;
  const float distance = std::max(glm::length(context.scene_center_world - view.eye_world), 1.0e-3f * radius);
  const glm::vec3 up = std::abs(direction.y) < 0.99f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(0.0f, 0.0f, 1.0f);
  view.view_from_world = glm::lookAtRH(view.eye_world, view.eye_world + direction, up);
  const float angle = distance > radius ? 2.0f * std::asin(std::min(radius / distance, 1.0f)) : kWidestView_rad;
  const float nearest = std::max(distance - radius, 0.02f * radius);
  view.clip_from_view = glm::perspectiveRH_ZO(std::min(angle, kWidestView_rad), 1.0f, nearest, distance + radius);
  return view;
}

}  // namespace burin::effect
