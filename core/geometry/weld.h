// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace burin::geometry {

/// For every vertex the lowest index of a vertex at the same position: +0 and -0 are the same, everything else is
/// compared by bits (so a NaN is the same as itself). Expected time O(n).
[[nodiscard]] std::vector<std::uint32_t> WeldPositions(std::span<const glm::vec3> positions);

}  // namespace burin::geometry
