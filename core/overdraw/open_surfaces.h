// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/edges.h"
#include "core/overdraw/edge_kind.h"

namespace burin::overdraw {

/// One byte an edge: whether the surface that it is on, connected across edges, has a boundary, a non-manifold edge or
/// a double-sided face. Of a mesh of several surfaces, an open one doesn't open the others. `double_sided`: empty or
/// one a face.
[[nodiscard]] std::vector<std::uint8_t> FindOpenSurfaces(std::span<const geometry::Edge> edges,
                                                         std::span<const EdgeKind> kinds,
                                                         std::span<const std::uint8_t> double_sided,
                                                         std::size_t face_count);

}  // namespace burin::overdraw
