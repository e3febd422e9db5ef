// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace burin::overdraw {

/// An order of points in which every aligned run of `leaf`, of 8 * leaf, 64 * leaf ... is a compact cluster. Returns
/// the points' indices. O(n log n), in parallel, the same for any number of threads. The points must be finite.
[[nodiscard]] std::vector<std::uint32_t> ClusterOrder(std::span<const glm::vec4> points, std::size_t leaf);

}  // namespace burin::overdraw
