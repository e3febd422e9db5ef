// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "core/scene/pose.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// Moves each object's triangles towards the sphere about its bounding box's centre that holds its vertices: a point p
/// goes to (1 - amount) p + amount (c + r (p - c) / |p - c|). Normals and tangents follow exactly, by the map's
/// derivative.
class SphereMorph {
 public:
  /// `amount`: 0 (nothing changes) to 1 (the sphere).
  explicit SphereMorph(float amount) : amount_(amount) {}

  /// After UpdateDrawItems, before tessellation.
  void MoveVertices(const Scene& scene, std::vector<DrawItem>& items);
  /// After tessellation, in the same frame: surfaces of patches, which have no vertices before. Those of meshes follow
  /// their vertices.
  void MoveSurfaces(const Scene& scene, std::vector<DrawItem>& items);

 private:
  struct Sphere {
    glm::vec3 center{0.0f};
    float radius = 0.0f;
  };
  /// A surface that does not change is moved once.
  struct Moved {
    std::shared_ptr<const ItemSurface> from, to;
  };

  float amount_;
  std::map<int, Sphere> of_node_;
  std::map<std::pair<int, int>, Moved> surfaces_;  ///< by node and primitive
};

/// MoveVertices, once.
void MorphToSphere(const Scene& scene, float amount, std::vector<DrawItem>& items);

}  // namespace burin::scene
