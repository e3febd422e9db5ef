// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin::overdraw {

/// The edges that are drawn only where they are silhouettes, as the searches need them: arrays of one length.
struct SilhouetteEdges {
  std::vector<std::uint32_t> left, right;  ///< faces
  std::vector<std::uint32_t> edge;         ///< index in EdgeMesh::edges

  [[nodiscard]] std::size_t size() const { return edge.size(); }
};

}  // namespace burin::overdraw
