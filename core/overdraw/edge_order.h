// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace burin::overdraw {

/// An order of items in which every aligned run of `leaf`, of 8 * leaf, 64 * leaf ... items is a compact cluster both
/// in place and in normal. Returns the items' indices. O(n log n), in parallel, the same for any number of threads.
/// `positions` within about a unit of 0; `normals` of unit length.
[[nodiscard]] std::vector<std::uint32_t> ClusterOrder(std::span<const glm::vec3> positions,
                                                      std::span<const glm::vec3> normals, std::size_t leaf);

}  // namespace burin::overdraw
