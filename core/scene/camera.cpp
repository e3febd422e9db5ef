// SPDX-License-Identifier: Apache-2.0
#include "core/scene/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/scene/shown_nodes.h"

namespace burin::scene {
namespace {

constexpr float kDegree = 0.017453292519943295f;
constexpr float kAutoYaw = 30.0f * kDegree;
constexpr float kAutoPitch = 20.0f * kDegree;
constexpr float kAutoFov = 35.0f * kDegree;
constexpr float kAutoMargin = 1.06f;  // of the picture around what it shows

/// The camera nodes below the shown scene's roots, in node order.
std::vector<int> CameraNodes(const Scene& scene) {
  const std::vector<bool> shown = ShownNodes(scene);
  std::vector<int> nodes;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (shown[i] && scene.nodes[i].camera != kNone) nodes.push_back(static_cast<int>(i));
  }
  return nodes;
}

const std::string& CameraName(const Scene& scene, int node) {
  return scene.cameras[static_cast<std::size_t>(scene.nodes[static_cast<std::size_t>(node)].camera)].name;
}

const std::string& NodeName(const Scene& scene, int node) { return scene.nodes[static_cast<std::size_t>(node)].name; }

std::string ListCameras(const Scene& scene, const std::vector<int>& nodes) {
  std::string list;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::string& camera = CameraName(scene, nodes[i]);
    const std::string& name = camera.empty() ? NodeName(scene, nodes[i]) : camera;
    list += fmt::format("{}{} \"{}\"", i == 0 ? "" : ", ", i, name);
  }
  return list;
}

/// A node's place and axes without its scale (and never mirrored).
glm::mat4 WithoutScale(const glm::mat4& m) {
  const auto unit = [](const glm::vec3& v, const glm::vec3& otherwise) {
    const float length = glm::length(v);
    return length > 0.0f ? v / length : otherwise;
  };
  const glm::vec3 z = unit(glm::vec3(m[2]), {0.0f, 0.0f, 1.0f});
  const glm::vec3 x = unit(glm::cross(glm::vec3(m[1]), z), {1.0f, 0.0f, 0.0f});
  return {glm::vec4(x, 0.0f), glm::vec4(glm::cross(z, x), 0.0f), glm::vec4(z, 0.0f), m[3]};
}

glm::mat4 RigidInverse(const glm::mat4& m) {
  const glm::mat3 rotation = glm::transpose(glm::mat3(m));
  glm::mat4 inverse(rotation);
  inverse[3] = glm::vec4(-(rotation * glm::vec3(m[3])), 1.0f);
  return inverse;
}

/// Turns about the vertical axis through `centre`.
glm::mat4 Orbit(const glm::vec3& centre, double angle_deg) {
  const double angle_rad = angle_deg * 0.017453292519943295;
  const auto c = static_cast<float>(std::cos(angle_rad));
  const auto s = static_cast<float>(std::sin(angle_rad));
  glm::mat4 turn(1.0f);
  turn[0] = {c, 0.0f, -s, 0.0f};
  turn[2] = {s, 0.0f, c, 0.0f};
  turn[3] = glm::vec4(centre - glm::vec3(turn * glm::vec4(centre, 0.0f)), 1.0f);
  return turn;
}

glm::mat4 Perspective(float yfov_rad, float aspect, float znear, float zfar) {
  const float f = 1.0f / std::tan(yfov_rad * 0.5f);
  glm::mat4 clip(0.0f);
  clip[0][0] = f / aspect;
  clip[1][1] = f;
  clip[2][3] = -1.0f;
  if (std::isinf(zfar)) {
    clip[2][2] = -1.0f;
    clip[3][2] = -znear;
  } else {
    clip[2][2] = zfar / (znear - zfar);
    clip[3][2] = znear * zfar / (znear - zfar);
  }
  return clip;
}

glm::mat4 Orthographic(float half_width, float half_height, float znear, float zfar) {
  glm::mat4 clip(1.0f);
  clip[0][0] = 1.0f / half_width;
  clip[1][1] = 1.0f / half_height;
  clip[2][2] = 1.0f / (znear - zfar);
  clip[3][2] = znear / (znear - zfar);
  return clip;
}

/// The distance from the axis' middle at which an upright cylinder fills the picture, seen `pitch` from above.
float CylinderDistance(float radius, float half_height, float pitch, float tan_x, float tan_y) {
  constexpr int kSteps = 64;
  const float cosine = std::cos(pitch);
  const float sine = std::sin(pitch);
  float distance = 0.0f;
  for (int i = 0; i < kSteps; ++i) {
    const float angle = static_cast<float>(i) * 360.0f / static_cast<float>(kSteps) * kDegree;
    const float x = radius * std::cos(angle);
    const float away = radius * std::sin(angle);
    for (const float height : {-half_height, half_height}) {
      const float y = height * cosine - away * sine;
      const float towards = height * sine + away * cosine;  // to the eye
      distance = std::max({distance, towards + std::abs(x) / tan_x, towards + std::abs(y) / tan_y});
    }
  }
  return distance;
}

/// The automatic camera's axes in its columns: right, up, and back to the eye.
glm::mat3 AutoAxes(double orbit_deg) {
  const glm::vec3 back(std::sin(kAutoYaw) * std::cos(kAutoPitch), std::sin(kAutoPitch),
                       std::cos(kAutoYaw) * std::cos(kAutoPitch));
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), back));
  return glm::mat3(Orbit(glm::vec3(0.0f), orbit_deg)) * glm::mat3(right, glm::cross(back, right), back);
}

float Aspect(int width, int height) {
  return static_cast<float>(std::max(width, 1)) / static_cast<float>(std::max(height, 1));
}

/// Tangents of the half angles of what the scene may fill: the picture without its margin.
glm::vec2 FilledTangents(int width, int height) {
  const float tan_y = std::tan(kAutoFov * 0.5f) / kAutoMargin;
  return {tan_y * Aspect(width, height), tan_y};
}

/// Where the eye stands, along the axes. A point p is left of the picture's right side when p.z + p.x / tangent is
/// below the same of the eye; so for the other sides. `nearest`: the least distance to the scene, for what points at
/// the eye.
glm::vec3 EyeOfReach(const std::array<Bounds, 2>& reach, const glm::vec2& tangents, float nearest) {
  const float right = reach[0].max.x, left = reach[0].max.y, top = reach[0].max.z, bottom = reach[1].max.x;
  return {0.5f * tangents.x * (right - left), 0.5f * tangents.y * (top - bottom),
          std::max({0.5f * (right + left), 0.5f * (top + bottom), reach[1].max.y + nearest})};
}

View FrameScene(const CameraChoice& choice, int width, int height, double orbit_deg) {
  const Bounds& bounds = choice.bounds;
  const glm::vec3 centre = bounds.empty() ? glm::vec3(0.0f) : (bounds.min + bounds.max) * 0.5f;
  glm::vec3 half = bounds.empty() ? glm::vec3(1.0f) : (bounds.max - bounds.min) * 0.5f;
  const float sphere = std::max(glm::length(half), 1e-6f);
  half = glm::max(half, glm::vec3(sphere * 1e-3f));  // a single point still has a picture
  const float tan_y = std::tan(kAutoFov * 0.5f);
  const float tan_x = tan_y * Aspect(width, height);
  const glm::mat3 axes = AutoAxes(orbit_deg);

  const glm::vec3 middle = glm::transpose(axes) * centre;
  glm::vec3 eye = middle;
  if (choice.reach && !bounds.empty()) eye = EyeOfReach(*choice.reach, FilledTangents(width, height), 0.05f * sphere);
  float distance = eye.z - middle.z;
  if (!choice.reach || distance < 1e-5f) {  // or a point
    distance = kAutoMargin * CylinderDistance(std::hypot(half.x, half.z), half.y, kAutoPitch, tan_x, tan_y);
    eye = middle + glm::vec3(0.0f, 0.0f, distance);
  }
  glm::mat4 world_from_view(axes);
  world_from_view[3] = glm::vec4(axes * eye, 1.0f);
  View view;
  view.view_from_world = RigidInverse(world_from_view);
  view.znear = std::max((distance - sphere) * 0.9f, distance * 1e-3f);
  view.zfar = (distance + sphere) * 1.1f;
  view.clip_from_view = Perspective(kAutoFov, Aspect(width, height), view.znear, view.zfar);
  return view;
}

}  // namespace

Result<int> SelectCamera(const Scene& scene, const std::string& choice) {
  if (choice == "auto") return kNone;
  const std::vector<int> nodes = CameraNodes(scene);
  if (choice.empty()) return nodes.empty() ? kNone : nodes.front();
  for (const int node : nodes) {
    if (CameraName(scene, node) == choice || NodeName(scene, node) == choice) return node;
  }
  int index = -1;
  const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), index);
  const bool is_index = error == std::errc() && end == choice.data() + choice.size();
  if (is_index && index >= 0 && index < static_cast<int>(nodes.size())) return nodes[static_cast<std::size_t>(index)];
  return Fail(ErrorKind::kUsage, nodes.empty()
                                     ? fmt::format("no camera \"{}\": the scene has none; \"auto\" frames it", choice)
                                     : fmt::format("no camera \"{}\": the scene has {}; \"auto\" frames it", choice,
                                                   ListCameras(scene, nodes)));
}

View MakeView(const Scene& scene, const CameraChoice& choice, const Pose& pose, int width, int height,
              double orbit_deg) {
  if (choice.camera_node == kNone) return FrameScene(choice, width, height, orbit_deg);

  const float aspect = Aspect(width, height);
  const auto node = static_cast<std::size_t>(choice.camera_node);
  const Camera& camera = scene.cameras[static_cast<std::size_t>(scene.nodes[node].camera)];
  const glm::vec3 centre = choice.bounds.empty() ? glm::vec3(0.0f) : (choice.bounds.min + choice.bounds.max) * 0.5f;
  glm::mat4 world_from_view = WithoutScale(pose.world_from_node[node]);
  if (orbit_deg != 0.0) world_from_view = Orbit(centre, orbit_deg) * world_from_view;
  View view;
  view.view_from_world = RigidInverse(world_from_view);
  view.orthographic = camera.orthographic;
  view.znear = camera.znear;
  view.zfar = camera.zfar.value_or(std::numeric_limits<float>::infinity());
  view.clip_from_view = camera.orthographic ? Orthographic(camera.ymag * aspect, camera.ymag, view.znear, view.zfar)
                                            : Perspective(camera.yfov_rad, aspect, view.znear, view.zfar);
  return view;
}

std::array<glm::mat4, 2> AutoReach(int width, int height, double orbit_deg) {
  const glm::mat3 axes = AutoAxes(orbit_deg);
  const glm::vec2 tangents = FilledTangents(width, height);
  const glm::vec3 x = axes[0] / tangents.x;
  const glm::vec3 y = axes[1] / tangents.y;
  const glm::vec3 z = axes[2];
  return {glm::mat4(glm::transpose(glm::mat3(z + x, z - x, z + y))), glm::mat4(glm::transpose(glm::mat3(z - y, z, z)))};
}

}  // namespace burin::scene
