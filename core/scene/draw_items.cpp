// SPDX-License-Identifier: Apache-2.0
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <glm/common.hpp>
#include <span>

#include "core/scene/deform.h"
#include "core/scene/item_geometry.h"
#include "core/scene/pose.h"
#include "core/scene/shown_nodes.h"

namespace burin::scene {
namespace {

/// World from bind space, one a joint.
std::vector<glm::mat4> JointMatrices(const Skin& skin, const Pose& pose) {
  std::vector<glm::mat4> matrices(skin.joints.size());
  for (std::size_t j = 0; j < matrices.size(); ++j) {
    matrices[j] = pose.world_from_node[static_cast<std::size_t>(skin.joints[j])] * skin.inverse_bind_matrices[j];
  }
  return matrices;
}

/// Deforms one node's primitive and says in which space it left the vertices.
void Deform(const Primitive& primitive, const Deformation& now, const Deformation& previous,
            bool wants_previous_normals, DrawItem& item) {
  const bool skinned = !now.joint_matrices.empty() && !primitive.joints[0].empty();
  item.is_deformed = skinned || !primitive.targets.empty();
  if (!item.is_deformed) {
    item.deformed = {};
    return;
  }
  DeformPrimitive(primitive, now, previous, item.deformed, wants_previous_normals);
  if (skinned) item.world_from_object = item.previous_world_from_object = glm::mat4(1.0f);
}

Bounds Merge(Bounds a, const Bounds& b) {
  a.Extend(b);
  return a;
}

Bounds BoundsOf(std::span<const glm::vec3> positions, const glm::mat4& world_from_object) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, positions.size(), 8192), Bounds(),
      [&](const tbb::blocked_range<std::size_t>& range, Bounds bounds) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          const glm::vec3 p(world_from_object * glm::vec4(positions[i], 1.0f));
          bounds.min = glm::min(bounds.min, p);
          bounds.max = glm::max(bounds.max, p);
        }
        return bounds;
      },
      Merge);
}

}  // namespace

std::vector<DrawItem> BuildDrawItems(const Scene& scene, const Pose& pose, const Pose& previous) {
  std::vector<DrawItem> items;
  UpdateDrawItems(scene, pose, previous, items);
  return items;
}

void UpdateDrawItems(const Scene& scene, const Pose& pose, const Pose& previous, std::vector<DrawItem>& items,
                     bool wants_previous_normals) {
  const std::vector<bool> shown = ShownNodes(scene);
  std::size_t count = 0;
  std::uint32_t object_id = 0;
  std::uint32_t next_primitive_id = 1;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (node.mesh == kNone) continue;
    ++object_id;
    if (!shown[n]) continue;
    const bool has_skin = node.skin != kNone;
    std::vector<glm::mat4> joints_now;
    std::vector<glm::mat4> joints_before;
    if (has_skin) {
      joints_now = JointMatrices(scene.skins[static_cast<std::size_t>(node.skin)], pose);
      joints_before = JointMatrices(scene.skins[static_cast<std::size_t>(node.skin)], previous);
    }
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(node.mesh)];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const Primitive& primitive = mesh.primitives[p];
      if (count == items.size()) items.emplace_back();
      DrawItem& item = items[count++];
      item.node = static_cast<int>(n);
      item.mesh = node.mesh;
      item.primitive = static_cast<int>(p);
      item.object_id = object_id;
      item.material_id = static_cast<std::uint32_t>(primitive.material + 1);
      item.first_primitive_id = next_primitive_id;
      item.surface.reset();
      item.first_patch_id = 0;
      item.world_from_object = pose.world_from_node[n];
      item.previous_world_from_object = previous.world_from_node[n];
      Deform(primitive, {pose.weights[n], joints_now}, {previous.weights[n], joints_before}, wants_previous_normals,
             item);
      next_primitive_id += ElementCount(primitive.mode, primitive.indices.size());
    }
  }
  items.resize(count);
}

Bounds ComputeBounds(const Scene& scene, const std::vector<DrawItem>& items, const glm::mat4& from_world) {
  Bounds bounds;
  for (const DrawItem& item : items) {
    bounds.Extend(BoundsOf(GeometryOf(scene, item).positions, from_world * item.world_from_object));
  }
  return bounds;
}

}  // namespace burin::scene
