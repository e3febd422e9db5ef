// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/concavity.h"

#include <glm/geometric.hpp>

namespace burin::overdraw {

bool IsConcave(const EdgeMesh& mesh, const geometry::Edge& edge) {
  if (edge.right == geometry::kNoFace) return false;
  const glm::dvec3 a(mesh.positions[edge.corners_left[0]]);
  const glm::dvec3 along = glm::dvec3(mesh.positions[edge.corners_left[1]]) - a;
  const glm::dvec3 left = glm::dvec3(mesh.positions[mesh.ThirdCorner(edge.left, edge.corners_left)]) - a;
  const glm::dvec3 right = glm::dvec3(mesh.positions[mesh.ThirdCorner(edge.right, edge.corners_right)]) - a;
  const glm::dvec3 left_normal = glm::cross(along, left);
  const double height = glm::dot(left_normal, right);
  if (height != 0.0) return height > 0.0;
  return glm::dot(left_normal, glm::cross(right, along)) >= 0.0;
}

}  // namespace burin::overdraw
