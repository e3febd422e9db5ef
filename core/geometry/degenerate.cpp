// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/degenerate.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>

namespace burin::geometry {

std::vector<std::uint8_t> FindDegenerate(std::span<const std::uint32_t> triangles,
                                         std::span<const glm::vec3> positions) {
  std::vector<std::uint8_t> degenerate(triangles.size() / 3);
  for (std::size_t f = 0; f < degenerate.size(); ++f) {
    const glm::dvec3 a(positions[triangles[3 * f]]);
    const glm::dvec3 ab = glm::dvec3(positions[triangles[3 * f + 1]]) - a;
    const glm::dvec3 ac = glm::dvec3(positions[triangles[3 * f + 2]]) - a;
    const double longest2 = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(ac - ab, ac - ab)});
    // Negated, so that a NaN counts as degenerate.
    degenerate[f] = !(glm::length(glm::cross(ab, ac)) > kDegenerateHeight * longest2);
  }
  return degenerate;
}

}  // namespace burin::geometry
