// SPDX-License-Identifier: Apache-2.0
#include "core/scene/patch_orientation.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "core/tessellation/tessellate.h"

namespace burin::scene {
namespace {

using geometry::BezierPatch;
using geometry::BezierPatches;
using geometry::ControlNet;
using geometry::PatchDomain;

constexpr double kLeastShare = 0.15;  // of the bounds' volume: open sheets have no inside

/// Of the volume that the surface encloses, seen from the middle of its bounds, above 0 where normals look outwards; as
/// a share of the bounds' volume.
double EnclosedShare(const BezierPatches& patches) {
  tessellation::Surface surface;
  const std::vector<tessellation::Factors> factors(patches.patches.size(), {4.0f, 4.0f, 4.0f, 4.0f});
  tessellation::Tessellate(
      patches, factors, {.pattern = tessellation::Pattern::kInteger, .wants_patch_uv = false, .wants_patch_ids = false},
      surface);
  if (surface.positions.empty()) return 0.0;
  glm::dvec3 low(surface.positions.front()), high = low;
  for (const glm::vec3& position : surface.positions) {
    low = glm::min(low, glm::dvec3(position));
    high = glm::max(high, glm::dvec3(position));
  }
  const glm::dvec3 middle = 0.5 * (low + high), size = high - low;
  double volume = 0.0;
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return glm::dvec3(surface.positions[surface.indices[i + k]]) - middle; };
    volume += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6.0;
  }
  const double bounds = size.x * size.y * size.z;
  return bounds > 0.0 ? volume / bounds : 0.0;
}

/// Quads: u becomes 1 - u. Triangles: u and v change places.
template <class Value>
void Mirror(PatchDomain domain, const ControlNet& net, std::vector<Value>& values) {
  const auto at = [&](std::uint32_t i, std::uint32_t j) -> Value& {
    return values[net.first + ValueIndex(domain, net, i, j)];
  };
  for (std::uint32_t j = 0; j < net.v_order; ++j) {
    if (domain == PatchDomain::kQuad) {
      for (std::uint32_t i = 0; i < net.u_order / 2u; ++i) std::swap(at(i, j), at(net.u_order - 1u - i, j));
    } else {
      for (std::uint32_t i = j + 1; i + j < net.u_order; ++i) std::swap(at(i, j), at(j, i));
    }
  }
}

}  // namespace

void TurnOutwards(BezierPatches& patches) {
  if (std::ranges::any_of(patches.patches, [](const BezierPatch& patch) { return static_cast<bool>(patch.normal); }))
    return;
  if (EnclosedShare(patches) > -kLeastShare) return;
  for (const BezierPatch& patch : patches.patches) {
    Mirror(patch.domain, patch.position, patches.positions);
    for (std::size_t t = 0; t < 2; ++t) Mirror(patch.domain, patch.texcoord[t], patches.texcoords[t]);
    Mirror(patch.domain, patch.color, patches.colors);
  }
}

}  // namespace burin::scene
