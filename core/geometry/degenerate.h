// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace burin::geometry {

/// Triangles thinner than this share of their longest edge have no usable normal.
inline constexpr double kDegenerateHeight = 1e-9;

/// One byte a triangle: 1 where two corners are at one place or all three on a line (height below kDegenerateHeight of
/// the longest edge), else 0. `triangles`: three indices a triangle, all < positions.size().
[[nodiscard]] std::vector<std::uint8_t> FindDegenerate(std::span<const std::uint32_t> triangles,
                                                       std::span<const glm::vec3> positions);

}  // namespace burin::geometry
