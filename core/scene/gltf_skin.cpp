// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>

#include "core/scene/gltf_accessor.h"
#include "core/scene/gltf_node.h"

namespace burin::scene {
namespace {

std::unexpected<Error> Bad(std::string message) { return Fail(ErrorKind::kInput, std::move(message)); }

Result<Skin> ReadSkin(GltfDocument& document, const tinygltf::Skin& source, std::size_t index) {
  Skin skin;
  skin.name = source.name;
  skin.joints = source.joints;
  if (skin.joints.empty()) return Bad(fmt::format("skins[{}].joints: is empty", index));
  if (source.inverseBindMatrices < 0) {
    skin.inverse_bind_matrices.assign(skin.joints.size(), glm::mat4(1.0f));
    return skin;
  }
  auto matrices = ReadVectors<glm::mat4>(document, source.inverseBindMatrices);
  if (!matrices) return Bad(fmt::format("skins[{}].inverseBindMatrices: {}", index, matrices.error().message));
  if (matrices->size() < skin.joints.size()) {
    return Bad(fmt::format("skins[{}].inverseBindMatrices: accessor {} has {} elements for {} joints", index,
                           source.inverseBindMatrices, matrices->size(), skin.joints.size()));
  }
  matrices->resize(skin.joints.size());
  skin.inverse_bind_matrices = std::move(*matrices);
  return skin;
}

struct HighestJoint {
  int joint = -1;
  std::size_t vertex = 0;
  int set = 0;
};

HighestJoint FindHighestJoint(const Primitive& primitive) {
  HighestJoint highest;
  for (std::size_t set = 0; set < 2; ++set) {
    for (std::size_t i = 0; i < primitive.joints[set].size(); ++i) {
      for (int c = 0; c < 4; ++c) {
        const int joint = primitive.joints[set][i][c];
        if (joint > highest.joint) highest = {joint, i, static_cast<int>(set)};
      }
    }
  }
  return highest;
}

}  // namespace

Result<void> ReadSkins(GltfDocument& document, Scene& scene) {
  for (std::size_t i = 0; i < document.model().skins.size(); ++i) {
    auto skin = ReadSkin(document, document.model().skins[i], i);
    if (!skin) return std::unexpected(skin.error());
    scene.skins.push_back(std::move(*skin));
  }
  std::vector<std::vector<HighestJoint>> highest(scene.meshes.size());
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (node.mesh == kNone || node.skin == kNone) continue;
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(node.mesh)];
    std::vector<HighestJoint>& of_mesh = highest[static_cast<std::size_t>(node.mesh)];
    if (of_mesh.empty()) {
      std::transform(mesh.primitives.begin(), mesh.primitives.end(), std::back_inserter(of_mesh), FindHighestJoint);
    }
    const std::size_t joints = scene.skins[static_cast<std::size_t>(node.skin)].joints.size();
    for (std::size_t p = 0; p < of_mesh.size(); ++p) {
      if (of_mesh[p].joint < 0) {
        document.Warn(
            fmt::format("nodes[{}]: has a skin, but meshes[{}] has primitives without JOINTS_0", n, node.mesh));
      }
      if (of_mesh[p].joint >= static_cast<int>(joints)) {
        return Bad(fmt::format(
            "nodes[{}]: skin {} has {} joints, but meshes[{}].primitives[{}].attributes.JOINTS_{} names joint {}", n,
            node.skin, joints, node.mesh, p, of_mesh[p].set, of_mesh[p].joint));
      }
    }
  }
  return {};
}

}  // namespace burin::scene
