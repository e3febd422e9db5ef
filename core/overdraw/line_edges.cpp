// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/line_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <iterator>

namespace burin::overdraw {
namespace {

/// 1 where the faces lie in one plane, -1 where one is folded onto the other; 1 for faces without area.
double FoldCosine(const EdgeSegment& edge) {
  const glm::dvec3 start(edge.ends[0]);
  const glm::dvec3 along = glm::dvec3(edge.ends[1]) - start;
  const glm::dvec3 left = glm::cross(along, glm::dvec3(edge.left_corner) - start);
  const glm::dvec3 right = glm::cross(glm::dvec3(edge.right_corner) - start, along);
  const double lengths = glm::length(left) * glm::length(right);
  return lengths > 0.0 ? glm::dot(left, right) / lengths : 1.0;
}

}  // namespace

void SelectLines(std::span<const EdgeSegment> segments, float crease_angle_deg, std::vector<EdgeSegment>& lines) {
  const double least_fold = std::cos(glm::radians(static_cast<double>(std::min(crease_angle_deg, kLeastFoldDeg))));
  lines.clear();
  std::ranges::copy_if(segments, std::back_inserter(lines), [&](const EdgeSegment& edge) {
    if (edge.edge_class == EdgeClass::kSeam) return false;
    return edge.edge_class != EdgeClass::kCrease || FoldCosine(edge) <= least_fold;
  });
}

}  // namespace burin::overdraw
