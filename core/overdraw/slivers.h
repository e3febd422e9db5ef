// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "core/geometry/edges.h"
#include "core/overdraw/face_planes.h"

namespace burin::overdraw {

/// Gives triangles that are thinner than a thousandth of their longest edge the plane of a neighbour that is not, over
/// the longest edge that leads to one: what rounding left of their own turns any way, and an outline would run round
/// each. The rest of the arguments as BuildEdgeMesh has them.
void TurnSlivers(std::span<const std::uint32_t> triangles, std::span<const glm::vec3> positions,
                 std::span<const geometry::Edge> edges, FacePlanes& planes);

}  // namespace burin::overdraw
