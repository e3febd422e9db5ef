// SPDX-License-Identifier: Apache-2.0
#include "core/scene/pose.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "core/scene/animation_sampler.h"

namespace burin::scene {
namespace {

using MovedThing = std::pair<int, AnimationPath>;

AnimationSelection SelectCompatible(const Scene& scene) {
  AnimationSelection selection;
  std::set<MovedThing> moved;
  for (std::size_t i = 0; i < scene.animations.size(); ++i) {
    const std::vector<AnimationChannel>& channels = scene.animations[i].channels;
    const bool clashes = std::any_of(channels.begin(), channels.end(), [&](const AnimationChannel& channel) {
      return moved.contains({channel.node, channel.path});
    });
    if (clashes || channels.empty()) continue;
    for (const AnimationChannel& channel : channels) moved.insert({channel.node, channel.path});
    selection.push_back(static_cast<int>(i));
  }
  return selection;
}

std::string ListAnimations(const Scene& scene) {
  std::string list;
  for (std::size_t i = 0; i < scene.animations.size(); ++i) {
    list += fmt::format("{}{} \"{}\"", i == 0 ? "" : ", ", i, scene.animations[i].name);
  }
  return list;
}

/// Where in its loop an animation stands.
float LoopTime(double time_s, float duration_s) {
  if (!(duration_s > 0.0f) || !(time_s > 0.0)) return 0.0f;
  return static_cast<float>(std::fmod(time_s, static_cast<double>(duration_s)));
}

glm::mat4 LocalMatrix(const Node& node, const Transform& transform) {
  if (node.matrix) return *node.matrix;
  glm::mat4 matrix = glm::mat4_cast(transform.rotation);
  for (int axis = 0; axis < 3; ++axis) matrix[axis] *= transform.scale[axis];
  matrix[3] = glm::vec4(transform.translation, 1.0f);
  return matrix;
}

void ApplyChannel(const AnimationChannel& channel, float time_s, std::vector<Transform>& transforms, Pose& pose) {
  const auto node = static_cast<std::size_t>(channel.node);
  if (channel.path == AnimationPath::kWeights) {
    SampleChannel(channel, time_s, pose.weights[node]);
    return;
  }
  float v[4] = {};
  SampleChannel(channel, time_s, std::span<float>(v, static_cast<std::size_t>(channel.components)));
  Transform& transform = transforms[node];
  switch (channel.path) {
    case AnimationPath::kTranslation:
      transform.translation = {v[0], v[1], v[2]};
      break;
    case AnimationPath::kRotation:
      transform.rotation = glm::quat(v[3], v[0], v[1], v[2]);
      break;
    default:
      transform.scale = {v[0], v[1], v[2]};
      break;
  }
}

/// Parents before children, without recursion: a hierarchy may be a chain of a million nodes.
std::vector<int> TopDownOrder(const std::vector<Node>& nodes) {
  std::vector<int> order;
  order.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent == kNone) order.push_back(static_cast<int>(i));
  }
  for (std::size_t at = 0; at < order.size(); ++at) {
    const std::vector<int>& children = nodes[static_cast<std::size_t>(order[at])].children;
    order.insert(order.end(), children.begin(), children.end());
  }
  return order;
}

}  // namespace

Result<AnimationSelection> SelectAnimations(const Scene& scene, const std::string& choice) {
  if (choice.empty() || choice == "auto") return SelectCompatible(scene);
  if (choice == "none") return AnimationSelection();
  AnimationSelection selection;
  if (choice == "all") {
    for (std::size_t i = 0; i < scene.animations.size(); ++i) selection.push_back(static_cast<int>(i));
    return selection;
  }
  for (std::size_t i = 0; i < scene.animations.size(); ++i) {
    if (scene.animations[i].name == choice) return AnimationSelection{static_cast<int>(i)};
  }
  int index = -1;
  const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), index);
  const bool is_index = error == std::errc() && end == choice.data() + choice.size();
  if (is_index && index >= 0 && index < static_cast<int>(scene.animations.size())) return AnimationSelection{index};
  return Fail(ErrorKind::kUsage,
              scene.animations.empty()
                  ? fmt::format("no animation \"{}\": the scene has none", choice)
                  : fmt::format("no animation \"{}\": the scene has {}", choice, ListAnimations(scene)));
}

float Duration(const Scene& scene, const AnimationSelection& selection) {
  float duration_s = 0.0f;
  for (const int index : selection) {
    duration_s = std::max(duration_s, scene.animations[static_cast<std::size_t>(index)].duration_s);
  }
  return duration_s;
}

Pose EvaluatePose(const Scene& scene, const AnimationSelection& selection, double time_s) {
  Pose pose;
  std::vector<Transform> transforms(scene.nodes.size());
  pose.weights.resize(scene.nodes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    transforms[i] = node.transform;
    if (node.mesh == kNone) continue;
    pose.weights[i] = node.weights.empty() ? scene.meshes[static_cast<std::size_t>(node.mesh)].weights : node.weights;
  }
  for (const int index : selection) {
    const Animation& animation = scene.animations[static_cast<std::size_t>(index)];
    const float at = LoopTime(time_s, animation.duration_s);
    for (const AnimationChannel& channel : animation.channels) ApplyChannel(channel, at, transforms, pose);
  }
  pose.world_from_node.resize(scene.nodes.size());
  for (const int index : TopDownOrder(scene.nodes)) {
    const auto i = static_cast<std::size_t>(index);
    const Node& node = scene.nodes[i];
    const glm::mat4 local = LocalMatrix(node, transforms[i]);
    pose.world_from_node[i] =
        node.parent == kNone ? local : pose.world_from_node[static_cast<std::size_t>(node.parent)] * local;
  }
  return pose;
}

}  // namespace burin::scene
