// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_node.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

namespace burin::scene {
namespace {

std::unexpected<Error> Bad(std::string message) { return Fail(ErrorKind::kInput, std::move(message)); }

float F(double value) { return static_cast<float>(value); }

Transform ReadTransform(const tinygltf::Node& source) {
  Transform transform;
  if (source.translation.size() == 3) {
    transform.translation = {F(source.translation[0]), F(source.translation[1]), F(source.translation[2])};
  }
  if (source.rotation.size() == 4) {
    const glm::dquat q(source.rotation[3], source.rotation[0], source.rotation[1], source.rotation[2]);
    const double length = glm::length(q);
    if (length > 0.0) transform.rotation = glm::quat(q / length);
  }
  if (source.scale.size() == 3) transform.scale = {F(source.scale[0]), F(source.scale[1]), F(source.scale[2])};
  return transform;
}

Result<Node> ReadNode(const tinygltf::Node& source, std::size_t index) {
  Node node;
  node.name = source.name;
  node.children = source.children;
  if (source.matrix.size() == 16) {
    glm::mat4 matrix;
    for (int i = 0; i < 16; ++i) glm::value_ptr(matrix)[i] = F(source.matrix[static_cast<std::size_t>(i)]);
    for (int column = 0; column < 4; ++column) {
      if (std::abs(matrix[column][3] - (column == 3 ? 1.0f : 0.0f)) > 1e-5f) {
        return Bad(fmt::format("nodes[{}].matrix: its last row is not 0 0 0 1", index));
      }
      matrix[column][3] = column == 3 ? 1.0f : 0.0f;
    }
    node.matrix = matrix;
  } else {
    node.transform = ReadTransform(source);
  }
  node.mesh = source.mesh;
  node.skin = source.skin;
  node.camera = source.camera;
  if (const auto it = source.extensions.find("KHR_lights_punctual"); it != source.extensions.end()) {
    const tinygltf::Value& light = it->second.Get(std::string("light"));
    if (light.IsInt()) node.light = light.GetNumberAsInt();
  }
  node.weights.assign(source.weights.begin(), source.weights.end());
  return node;
}

Result<void> LinkParents(std::vector<Node>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const int child : nodes[i].children) {
      int& parent = nodes[static_cast<std::size_t>(child)].parent;
      if (parent != kNone) {
        return Bad(fmt::format("nodes[{}]: is a child of both nodes[{}] and nodes[{}]; a node has one parent", child,
                               parent, i));
      }
      parent = static_cast<int>(i);
    }
  }
  // With one parent each, whatever cannot be reached from a parentless node is on or below a cycle.
  std::vector<bool> reached(nodes.size(), false);
  std::vector<int> queue;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent == kNone) queue.push_back(static_cast<int>(i));
  }
  for (std::size_t at = 0; at < queue.size(); ++at) {
    reached[static_cast<std::size_t>(queue[at])] = true;
    const std::vector<int>& children = nodes[static_cast<std::size_t>(queue[at])].children;
    queue.insert(queue.end(), children.begin(), children.end());
  }
  const auto lost = std::find(reached.begin(), reached.end(), false);
  if (lost == reached.end()) return {};
  return Bad(fmt::format("nodes[{}]: is among its own ancestors", lost - reached.begin()));
}

Result<void> ReadRoots(GltfDocument& document, Scene& scene) {
  const tinygltf::Model& model = document.model();
  if (model.scenes.empty()) {
    if (scene.nodes.empty()) return Bad("has no scene and no nodes: nothing to draw");
    document.Warn("has no scene: every node is shown");
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
      if (scene.nodes[i].parent == kNone) scene.roots.push_back(static_cast<int>(i));
    }
    return {};
  }
  const int shown = std::max(model.defaultScene, 0);
  const tinygltf::Scene& source = model.scenes[static_cast<std::size_t>(shown)];
  if (source.nodes.empty()) return Bad(fmt::format("scenes[{}]: has no nodes: nothing to draw", shown));
  if (!source.name.empty()) scene.name = source.name;
  std::vector<bool> listed(scene.nodes.size(), false);
  for (const int node : source.nodes) {
    if (scene.nodes[static_cast<std::size_t>(node)].parent != kNone) {
      document.Warn(fmt::format("scenes[{}]: nodes[{}] is not a root node", shown, node));
    }
    if (!listed[static_cast<std::size_t>(node)]) scene.roots.push_back(node);
    listed[static_cast<std::size_t>(node)] = true;
  }
  return {};
}

Result<Camera> ReadCamera(const tinygltf::Camera& source, std::size_t index) {
  Camera camera;
  camera.name = source.name;
  camera.orthographic = source.type == "orthographic";
  if (camera.orthographic) {
    const tinygltf::OrthographicCamera& o = source.orthographic;
    camera.xmag = std::abs(F(o.xmag));
    camera.ymag = std::abs(F(o.ymag));
    camera.znear = F(o.znear);
    camera.zfar = F(o.zfar);
    if (camera.xmag == 0.0f || camera.ymag == 0.0f) {
      return Bad(fmt::format("cameras[{}].orthographic: xmag and ymag must not be 0", index));
    }
  } else {
    const tinygltf::PerspectiveCamera& p = source.perspective;
    camera.yfov_rad = F(p.yfov);
    camera.znear = F(p.znear);
    if (p.aspectRatio > 0.0) camera.aspect_ratio = F(p.aspectRatio);
    if (p.zfar > 0.0) camera.zfar = F(p.zfar);
  }
  if (camera.zfar && !(*camera.zfar > camera.znear)) {
    return Bad(fmt::format("cameras[{}]: zfar {} is not beyond znear {}", index, *camera.zfar, camera.znear));
  }
  return camera;
}

Result<Light> ReadLight(const tinygltf::Light& source, std::size_t index) {
  Light light;
  light.name = source.name;
  light.type = source.type == "point"  ? LightType::kPoint
               : source.type == "spot" ? LightType::kSpot
                                       : LightType::kDirectional;
  if (source.color.size() == 3) light.color = {F(source.color[0]), F(source.color[1]), F(source.color[2])};
  light.intensity = F(source.intensity);
  if (source.range > 0.0) light.range = F(source.range);
  light.inner_cone_rad = F(source.spot.innerConeAngle);
  light.outer_cone_rad = F(source.spot.outerConeAngle);
  if (light.type == LightType::kSpot && !(light.inner_cone_rad < light.outer_cone_rad)) {
    return Bad(
        fmt::format("extensions.KHR_lights_punctual.lights[{}].spot: innerConeAngle {} is not below outerConeAngle {}",
                    index, light.inner_cone_rad, light.outer_cone_rad));
  }
  return light;
}

}  // namespace

Result<void> ReadNodes(GltfDocument& document, Scene& scene) {
  const tinygltf::Model& model = document.model();
  for (std::size_t i = 0; i < model.cameras.size(); ++i) {
    auto camera = ReadCamera(model.cameras[i], i);
    if (!camera) return std::unexpected(camera.error());
    scene.cameras.push_back(std::move(*camera));
  }
  for (std::size_t i = 0; i < model.lights.size(); ++i) {
    auto light = ReadLight(model.lights[i], i);
    if (!light) return std::unexpected(light.error());
    scene.lights.push_back(std::move(*light));
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    auto node = ReadNode(model.nodes[i], i);
    if (!node) return std::unexpected(node.error());
    if (node->light >= static_cast<int>(scene.lights.size())) node->light = kNone;
    scene.nodes.push_back(std::move(*node));
  }
  if (auto ok = LinkParents(scene.nodes); !ok) return ok;
  return ReadRoots(document, scene);
}

}  // namespace burin::scene
