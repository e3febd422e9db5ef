// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/geometry/edges.h"
#include "core/overdraw/edge_kind.h"

namespace burin::overdraw {

/// Chains of sharp edges, one after the other; path p is edges[begins[p]] .. edges[begins[p + 1] - 1], from its
/// beginning to its end.
struct SharpPaths {
  std::vector<std::uint32_t> edges;   ///< every sharp edge once
  std::vector<std::uint32_t> begins;  ///< one more than paths; empty when there are none
};

/// Joins sharp edges into paths and turns them, in `edges`, so that all edges of a path run the same way and the same
/// side of each is its left (Sander et al. 2001, section 3.3). `welded`: one index a vertex, as WeldPositions gives
/// them. Deterministic; turns don't depend on the order of triangles where positions tell all edges apart.
[[nodiscard]] SharpPaths OrientSharpPaths(std::span<const EdgeKind> kinds, std::span<const glm::vec3> positions,
                                          std::span<const std::uint32_t> welded, std::span<geometry::Edge> edges);

}  // namespace burin::overdraw
