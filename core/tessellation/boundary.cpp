// SPDX-License-Identifier: Apache-2.0
#include "core/tessellation/boundary.h"

#include <algorithm>
#include <glm/ext/vector_double3.hpp>
#include <glm/geometric.hpp>

namespace burin::tessellation {
namespace {

using geometry::BezierPatch;
using geometry::BezierPatches;
using geometry::PatchDomain;

/// Rounded as a vertex there would be.
glm::vec3 PointOf(const glm::vec4& point, bool is_rational) {
  return is_rational ? glm::vec3(glm::dvec3(point) / static_cast<double>(point.w)) : glm::vec3(point);
}

/// Of a patch's extent. The loops at the poles of Newell's teapot have .002 of theirs.
constexpr float kNearlyPoint = 0.01f;

SideShape ShapeOf(const BezierPatches& patches, const BezierPatch& patch, std::uint32_t side) {
  const std::uint32_t last = SideOrder(patch, side) - 1;
  const auto point = [&](std::uint32_t k) {
    return PointOf(patches.positions[SidePoint(patch, side, k)], patch.is_rational);
  };
  const glm::vec3 corner = point(0);
  if (point(last) != corner) return SideShape::kOpen;
  for (std::uint32_t k = 1; k < last; ++k) {
    if (point(k) != corner) return SideShape::kLoop;
  }
  return SideShape::kPoint;
}

}  // namespace

std::uint32_t SideOrder(const BezierPatch& patch, std::uint32_t side) {
  return patch.domain == PatchDomain::kQuad && side >= 2 ? patch.position.v_order : patch.position.u_order;
}

std::uint32_t SidePoint(const BezierPatch& patch, std::uint32_t side, std::uint32_t k) {
  const std::uint32_t n = patch.position.u_order, m = patch.position.v_order, rest = n - 1 - k;
  const auto index = [&](std::uint32_t i, std::uint32_t j) {
    return patch.position.first + ValueIndex(patch.domain, patch.position, i, j);
  };
  if (patch.domain == PatchDomain::kQuad) {
    return side < 2 ? index(k, side == 0 ? 0 : m - 1) : index(side == 2 ? 0 : n - 1, k);
  }
  return side == 0 ? index(k, 0) : side == 1 ? index(rest, k) : index(0, rest);
}

std::array<SideShape, 4> SideShapes(const BezierPatches& patches, const BezierPatch& patch) {
  std::array<SideShape, 4> shapes{};
  for (std::uint32_t s = 0; s < SideCount(patch.domain); ++s) shapes[s] = ShapeOf(patches, patch, s);
  return shapes;
}

bool IsNearlyPoint(const BezierPatches& patches, const BezierPatch& patch, std::uint32_t side) {
  const auto at = [&](std::uint32_t index) { return PointOf(patches.positions[index], patch.is_rational); };
  const glm::vec3 corner = at(SidePoint(patch, side, 0));
  float reach = 0.0f, extent = 0.0f;
  for (std::uint32_t k = 1; k < SideOrder(patch, side); ++k)
    reach = std::max(reach, glm::distance(corner, at(SidePoint(patch, side, k))));
  for (std::uint32_t k = 0; k < ValueCount(patch.domain, patch.position); ++k)
    extent = std::max(extent, glm::distance(corner, at(patch.position.first + k)));
  return reach <= kNearlyPoint * extent;
}

}  // namespace burin::tessellation
