// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace burin::geometry {

/// Appends the triangles of a simple polygon, as indices of its corners, to `out`: corners - 2 of them, turning as the
/// polygon does. Quads are cut along the diagonal that keeps both halves facing the same way, the shorter one where
/// both do; others by ear clipping, concave ones too; a polygon that crosses itself ends in a fan, and one of more than
/// 256 corners is a fan.
void TriangulatePolygon(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& out);

/// The polygon's normal by Newell's sums, not normalised: twice its area long. Any corners, planar or not.
[[nodiscard]] glm::dvec3 PolygonNormal(std::span<const glm::vec3> corners);

}  // namespace burin::geometry
