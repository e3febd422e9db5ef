// SPDX-License-Identifier: Apache-2.0
#include "core/scene/morph_to_sphere.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <utility>

#include "core/scene/item_geometry.h"

namespace burin::scene {
namespace {

/// In the space of an item's vertices.
class SphereMap {
 public:
  SphereMap(float amount, const glm::vec3& center, float radius) : amount_(amount), center_(center), radius_(radius) {}

  [[nodiscard]] glm::vec3 Point(const glm::vec3& p) const {
    const glm::vec3 d = p - center_;
    const float length = glm::length(d);
    return length > 0.0f ? glm::mix(p, center_ + d * (radius_ / length), amount_) : p;
  }

  /// The derivative stretches by 1 - amount in the direction from the centre and by Across() about it. It takes
  /// tangents; its inverse, symmetric too, takes normals.
  [[nodiscard]] glm::vec3 Tangent(const glm::vec3& p, const glm::vec3& t) const {
    return Stretch(p, t, [&](float across) { return std::pair(1.0f - amount_, across); });
  }
  [[nodiscard]] glm::vec3 Normal(const glm::vec3& p, const glm::vec3& n) const {
    return Stretch(p, n, [&](float across) { return std::pair(1.0f, (1.0f - amount_) / across); });
  }

 private:
  [[nodiscard]] float Across(float length) const { return 1.0f - amount_ + amount_ * radius_ / length; }

  /// `factors`: along the direction from the centre and across it. The result is of unit length.
  template <class Factors>
  [[nodiscard]] glm::vec3 Stretch(const glm::vec3& p, const glm::vec3& v, const Factors& factors) const {
    const glm::vec3 d = p - center_;
    const float length = glm::length(d);
    if (!(length > 0.0f)) return v;
    const glm::vec3 outwards = d / length;
    const glm::vec3 part = glm::dot(v, outwards) * outwards;
    const auto [along, across] = factors(std::max(Across(length), 1e-12f));
    const glm::vec3 stretched = part * along + (v - part) * across;
    return glm::dot(stretched, stretched) > 1e-20f ? glm::normalize(stretched) : outwards;
  }

  float amount_;
  glm::vec3 center_;
  float radius_;
};

/// Normals and tangents first: they ask where their vertex was.
void Move(const SphereMap& map, std::vector<glm::vec3>& positions, std::vector<glm::vec3>& normals,
          std::vector<glm::vec4>& tangents) {
  for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = map.Normal(positions[i], normals[i]);
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    tangents[i] = glm::vec4(map.Tangent(positions[i], glm::vec3(tangents[i])), tangents[i].w);
  }
  for (glm::vec3& p : positions) p = map.Point(p);
}

void MoveItem(const SphereMap& map, const Primitive& primitive, DrawItem& item) {
  DeformedVertices& v = item.deformed;
  if (!item.is_deformed) {
    v.positions = v.previous_positions = primitive.positions;
    v.normals = primitive.normals;
    v.tangents = primitive.tangents;
    item.is_deformed = true;
  }
  Move(map, v.positions, v.normals, v.tangents);
  for (glm::vec3& p : v.previous_positions) p = map.Point(p);
}

const std::vector<glm::vec3>& PositionsOf(const Scene& scene, const DrawItem& item) {
  return item.is_deformed ? item.deformed.positions : PrimitiveOf(scene, item).positions;
}

}  // namespace

void SphereMorph::MoveVertices(const Scene& scene, std::vector<DrawItem>& items) {
  if (!(amount_ > 0.0f)) return;
  std::map<int, Bounds> bounds;
  for (const DrawItem& item : items) {
    Bounds& of_node = bounds[item.node];
    for (const glm::vec3& p : PositionsOf(scene, item)) of_node.Extend({p, p});
  }
  of_node_.clear();
  for (const auto& [node, box] : bounds) of_node_[node] = {0.5f * (box.min + box.max), 0.0f};
  for (const DrawItem& item : items) {
    Sphere& sphere = of_node_[item.node];
    for (const glm::vec3& p : PositionsOf(scene, item)) {
      sphere.radius = std::max(sphere.radius, glm::distance(p, sphere.center));
    }
  }
  for (DrawItem& item : items) {
    const Primitive& primitive = PrimitiveOf(scene, item);
    const Sphere& sphere = of_node_[item.node];
    if (primitive.mode != PrimitiveMode::kTriangles) continue;
    MoveItem(SphereMap(amount_, sphere.center, sphere.radius), primitive, item);
  }
}

void SphereMorph::MoveSurfaces(const Scene& scene, std::vector<DrawItem>& items) {
  if (!(amount_ > 0.0f)) return;
  for (DrawItem& item : items) {
    if (!item.surface || !PrimitiveOf(scene, item).patches) continue;
    Moved& moved = surfaces_[{item.node, item.primitive}];
    if (moved.from != item.surface) {
      const Sphere& sphere = of_node_[item.node];
      const auto surface = std::make_shared<ItemSurface>(*item.surface);
      Move(SphereMap(amount_, sphere.center, sphere.radius), surface->triangles.positions, surface->triangles.normals,
           surface->triangles.tangents);
      surface->previous_positions.clear();
      moved = {item.surface, surface};
    }
    item.surface = moved.to;
  }
}

void MorphToSphere(const Scene& scene, float amount, std::vector<DrawItem>& items) {
  SphereMorph(amount).MoveVertices(scene, items);
}

}  // namespace burin::scene
