// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/edges.h"
#include "core/overdraw/edge_kind.h"
#include "core/overdraw/face_planes.h"
#include "core/overdraw/mesh_input.h"

namespace burin::overdraw {

/// The kind of every edge. `planes`: of the input's triangles.
[[nodiscard]] std::vector<EdgeKind> ClassifyEdges(const MeshInput& input, std::span<const geometry::Edge> edges,
                                                  const FacePlanes& planes, float crease_angle_deg);

}  // namespace burin::overdraw
