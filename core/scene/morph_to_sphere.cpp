// SPDX-License-Identifier: Apache-2.0
#include "core/scene/morph_to_sphere.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "core/scene/item_geometry.h"

namespace burin::scene {
namespace {

/// In the space of an item's vertices.
class SphereMap {
 public:
  explicit SphereMap(float amount) : amount_(amount) {}

  void Include(const std::vector<glm::vec3>& positions) {
    for (const glm::vec3& p : positions) {
      low_ = glm::min(low_, p);
      high_ = glm::max(high_, p);
    }
  }
  void Reach(const std::vector<glm::vec3>& positions) {
    for (const glm::vec3& p : positions) radius_ = std::max(radius_, glm::distance(p, center()));
  }

  [[nodiscard]] glm::vec3 Point(const glm::vec3& p) const {
    const glm::vec3 d = p - center();
    const float length = glm::length(d);
    return length > 0.0f ? glm::mix(p, center() + d * (radius_ / length), amount_) : p;
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
  [[nodiscard]] glm::vec3 center() const { return 0.5f * (low_ + high_); }
  [[nodiscard]] float Across(float length) const { return 1.0f - amount_ + amount_ * radius_ / length; }

  /// `factors`: along the direction from the centre and across it. The result is of unit length.
  template <class Factors>
  [[nodiscard]] glm::vec3 Stretch(const glm::vec3& p, const glm::vec3& v, const Factors& factors) const {
    const glm::vec3 d = p - center();
    const float length = glm::length(d);
    if (!(length > 0.0f)) return v;
    const glm::vec3 outwards = d / length;
    const glm::vec3 part = glm::dot(v, outwards) * outwards;
    const auto [along, across] = factors(std::max(Across(length), 1e-12f));
    const glm::vec3 stretched = part * along + (v - part) * across;
    return glm::dot(stretched, stretched) > 1e-20f ? glm::normalize(stretched) : outwards;
  }

  float amount_;
  glm::vec3 low_{1e30f}, high_{-1e30f};
  float radius_ = 0.0f;
};

void Apply(const SphereMap& map, const Primitive& primitive, DrawItem& item) {
  DeformedVertices& v = item.deformed;
  if (!item.is_deformed) {
    v.positions = v.previous_positions = primitive.positions;
    v.normals = primitive.normals;
    v.tangents = primitive.tangents;
    item.is_deformed = true;
  }
  for (std::size_t i = 0; i < v.normals.size(); ++i) v.normals[i] = map.Normal(v.positions[i], v.normals[i]);
  for (std::size_t i = 0; i < v.tangents.size(); ++i) {
    v.tangents[i] = glm::vec4(map.Tangent(v.positions[i], glm::vec3(v.tangents[i])), v.tangents[i].w);
  }
  for (glm::vec3& p : v.positions) p = map.Point(p);
  for (glm::vec3& p : v.previous_positions) p = map.Point(p);
}

}  // namespace

void MorphToSphere(const Scene& scene, float amount, std::vector<DrawItem>& items) {
  if (!(amount > 0.0f)) return;
  const auto positions_of = [&](const DrawItem& item) -> const std::vector<glm::vec3>& {
    return item.is_deformed ? item.deformed.positions : PrimitiveOf(scene, item).positions;
  };
  std::map<int, SphereMap> of_node;
  for (const DrawItem& item : items) of_node.try_emplace(item.node, amount).first->second.Include(positions_of(item));
  for (const DrawItem& item : items) of_node.at(item.node).Reach(positions_of(item));
  for (DrawItem& item : items) {
    const Primitive& primitive = PrimitiveOf(scene, item);
    if (primitive.mode == PrimitiveMode::kTriangles) Apply(of_node.at(item.node), primitive, item);
  }
}

}  // namespace burin::scene
