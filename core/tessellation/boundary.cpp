// SPDX-License-Identifier: Apache-2.0
#include "core/tessellation/boundary.h"

#include <glm/ext/vector_double3.hpp>

namespace burin::tessellation {
namespace {

using geometry::BezierPatch;
using geometry::BezierPatches;
using geometry::PatchDomain;

/// Rounded as a vertex there would be.
glm::vec3 PointOf(const glm::vec4& point, bool is_rational) {
  return is_rational ? glm::vec3(glm::dvec3(point) / static_cast<double>(point.w)) : glm::vec3(point);
}

bool IsCollapsed(const BezierPatches& patches, const BezierPatch& patch, std::uint32_t side) {
  const auto point = [&](std::uint32_t k) {
    return PointOf(patches.positions[SidePoint(patch, side, k)], patch.is_rational);
  };
  const glm::vec3 corner = point(0);
  for (std::uint32_t k = 1; k < SideOrder(patch, side); ++k) {
    if (point(k) != corner) return false;
  }
  return true;
}

}  // namespace

std::uint32_t SideOrder(const BezierPatch& patch, std::uint32_t side) {
  return patch.domain == PatchDomain::kQuad && side >= 2 ? patch.position.v_order : patch.position.u_order;
}

std::uint32_t SidePoint(const BezierPatch& patch, std::uint32_t side, std::uint32_t k) {
  const std::uint32_t first = patch.position.first, n = patch.position.u_order, m = patch.position.v_order;
  if (patch.domain == PatchDomain::kQuad) {
    if (side < 2) return first + (side == 0 ? 0 : (m - 1) * n) + k;
    return first + k * n + (side == 2 ? 0 : n - 1);
  }
  const auto index = [&](std::uint32_t i, std::uint32_t j) { return first + j * n + i - (j * j - j) / 2; };
  const std::uint32_t rest = n - 1 - k;
  return side == 0 ? index(k, 0) : side == 1 ? index(rest, k) : index(0, rest);
}

std::array<bool, 4> CollapsedSides(const BezierPatches& patches, const BezierPatch& patch) {
  std::array<bool, 4> collapsed{};
  for (std::uint32_t s = 0; s < SideCount(patch.domain); ++s) collapsed[s] = IsCollapsed(patches, patch, s);
  return collapsed;
}

}  // namespace burin::tessellation
