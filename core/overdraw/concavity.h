// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/overdraw/edge_mesh.h"

namespace burin::overdraw {

/// Whether the outer angle between the edge's two faces is at most 180 degrees, in the mesh's current positions: the
/// right face's third corner is not behind the left face. Faces folded flat onto each other are convex; an edge with
/// one face is not concave.
[[nodiscard]] bool IsConcave(const EdgeMesh& mesh, const geometry::Edge& edge);

}  // namespace burin::overdraw
