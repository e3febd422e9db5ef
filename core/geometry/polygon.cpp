// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/polygon.h"

#include <cstddef>
#include <glm/geometric.hpp>
#include <numeric>

namespace burin::geometry {
namespace {

constexpr std::size_t kMostEarCorners = 256;

glm::dvec3 Cross(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
}

void CutQuad(std::span<const glm::vec3> q, std::vector<std::uint32_t>& out) {
  const bool first_is_good = glm::dot(Cross(q[0], q[1], q[2]), Cross(q[0], q[2], q[3])) >= 0.0;
  const bool second_is_good = glm::dot(Cross(q[1], q[2], q[3]), Cross(q[1], q[3], q[0])) >= 0.0;
  const bool first_is_shorter = glm::distance(q[0], q[2]) <= glm::distance(q[1], q[3]);
  const bool takes_first = first_is_good == second_is_good ? first_is_shorter : first_is_good;
  if (takes_first) {
    out.insert(out.end(), {0, 1, 2, 0, 2, 3});
  } else {
    out.insert(out.end(), {0, 1, 3, 1, 2, 3});
  }
}

/// The corner at `k` of what is left is an ear: convex, and no other corner lies in its triangle.
bool IsEar(std::span<const glm::vec3> corners, const std::vector<std::uint32_t>& left, std::size_t k,
           const glm::dvec3& normal) {
  const std::size_t before = (k + left.size() - 1) % left.size(), after = (k + 1) % left.size();
  const glm::vec3 &a = corners[left[before]], &b = corners[left[k]], &c = corners[left[after]];
  if (glm::dot(Cross(a, b, c), normal) <= 0.0) return false;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (i == before || i == k || i == after) continue;
    const glm::vec3& p = corners[left[i]];
    const bool is_inside = glm::dot(Cross(a, b, p), normal) >= 0.0 && glm::dot(Cross(b, c, p), normal) >= 0.0 &&
                           glm::dot(Cross(c, a, p), normal) >= 0.0;
    if (is_inside && p != a && p != b && p != c) return false;
  }
  return true;
}

}  // namespace

glm::dvec3 PolygonNormal(std::span<const glm::vec3> corners) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) sum += Cross(corners[0], corners[i], corners[i + 1]);
  return sum;
}

void TriangulatePolygon(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& out) {
  if (corners.size() < 3) return;
  if (corners.size() == 4) return CutQuad(corners, out);
  const glm::dvec3 normal = PolygonNormal(corners);
  std::vector<std::uint32_t> left(corners.size());
  std::iota(left.begin(), left.end(), 0u);
  while (left.size() > 3 && corners.size() <= kMostEarCorners) {
    std::size_t ear = 0;
    while (ear < left.size() && !IsEar(corners, left, ear, normal)) ++ear;
    if (ear == left.size()) break;
    const std::size_t before = (ear + left.size() - 1) % left.size(), after = (ear + 1) % left.size();
    out.insert(out.end(), {left[before], left[ear], left[after]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  for (std::size_t i = 1; i + 1 < left.size(); ++i) out.insert(out.end(), {left[0], left[i], left[i + 1]});
}

}  // namespace burin::geometry
