// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/slivers.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace burin::overdraw {
namespace {

constexpr double kSliverHeight = 1e-3, kThinHeight = 0.1;  // of the longest edge
constexpr float kTilted = 0.97f;                           // cosine, of 14 degrees

/// Of a triangle's height over its longest edge, as a share of that.
double HeightOf(const std::uint32_t* corner, std::span<const glm::vec3> positions) {
  const glm::dvec3 a(positions[corner[0]]);
  const glm::dvec3 ab = glm::dvec3(positions[corner[1]]) - a, ac = glm::dvec3(positions[corner[2]]) - a;
  const double longest2 = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(ac - ab, ac - ab)});
  return longest2 > 0.0 ? glm::length(glm::cross(ab, ac)) / longest2 : 0.0;
}

/// Against the mean of its corners' normals, whichever way those look.
bool IsTilted(const std::uint32_t* corner, std::span<const glm::vec3> normals, const glm::vec3& plane) {
  if (normals.empty()) return false;
  const glm::vec3 mean = normals[corner[0]] + normals[corner[1]] + normals[corner[2]];
  return std::abs(glm::dot(mean, plane)) < kTilted * glm::length(mean);
}

/// The neighbour whose plane a sliver takes.
struct Lender {
  std::uint32_t face = geometry::kNoFace;
  float length2 = -1.0f;  ///< of the edge between them
};

void Copy(std::uint32_t from, std::uint32_t to, FacePlanes& planes) {
  for (std::vector<float>* array : {&planes.x, &planes.y, &planes.z, &planes.w}) (*array)[to] = (*array)[from];
}

}  // namespace

void TurnSlivers(std::span<const std::uint32_t> triangles, std::span<const glm::vec3> positions,
                 std::span<const glm::vec3> normals, std::span<const geometry::Edge> edges, FacePlanes& planes) {
  constexpr int kRounds = 8;  // slivers beside slivers: few in a row
  std::vector<std::uint8_t> is_sliver(triangles.size() / 3);
  std::size_t left = 0;
  for (std::size_t f = 0; f < is_sliver.size(); ++f) {
    const double height = HeightOf(&triangles[3 * f], positions);
    const bool is_turned =
        height <= kSliverHeight || (height <= kThinHeight && IsTilted(&triangles[3 * f], normals, planes.Normal(f)));
    is_sliver[f] = is_turned ? 1 : 0;
    left += is_sliver[f];
  }
  for (int round = 0; round < kRounds && left > 0; ++round) {
    std::vector<Lender> lenders(is_sliver.size());
    for (const geometry::Edge& edge : edges) {
      if (edge.right == geometry::kNoFace || is_sliver[edge.left] == is_sliver[edge.right]) continue;
      const std::uint32_t sliver = is_sliver[edge.left] != 0 ? edge.left : edge.right;
      const glm::vec3 d = positions[edge.corners_left[1]] - positions[edge.corners_left[0]];
      if (const float length2 = glm::dot(d, d); length2 > lenders[sliver].length2) {
        lenders[sliver] = {sliver == edge.left ? edge.right : edge.left, length2};
      }
    }
    for (std::uint32_t f = 0; f < lenders.size(); ++f) {
      if (lenders[f].face == geometry::kNoFace) continue;
      Copy(lenders[f].face, f, planes);
      is_sliver[f] = 0;
      --left;
    }
  }
}

}  // namespace burin::overdraw
