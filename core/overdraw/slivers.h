// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "core/geometry/edges.h"
#include "core/overdraw/face_planes.h"

namespace burin::overdraw {

/// Gives triangles that don't show which way a curved surface looks the plane of a neighbour that does, over the
/// longest edge that leads to one: an outline would run round each. They are those thinner than a thousandth of their
/// longest edge, whose plane is what rounding left of it, and thin ones that are tilted against the surface's normals,
/// as where a strip joins lines of different density. `normals`: one a vertex, or none. The rest of the arguments as
/// BuildEdgeMesh has them.
void TurnSlivers(std::span<const std::uint32_t> triangles, std::span<const glm::vec3> positions,
                 std::span<const glm::vec3> normals, std::span<const geometry::Edge> edges, FacePlanes& planes);

}  // namespace burin::overdraw
