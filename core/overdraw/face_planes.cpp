// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/face_planes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace burin::overdraw {
namespace {

constexpr std::size_t kGrain = 8192;

struct Bounds {
  glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
  void Join(const glm::vec3& l, const glm::vec3& h) {
    low = glm::min(low, l);
    high = glm::max(high, h);
  }
};

Bounds BoundsOf(std::span<const glm::vec3> positions) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, positions.size(), kGrain), Bounds(),
      [&](const tbb::blocked_range<std::size_t>& range, Bounds bounds) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) bounds.Join(positions[i], positions[i]);
        return bounds;
      },
      [](Bounds a, const Bounds& b) {
        a.Join(b.low, b.high);
        return a;
      });
}

void PlaceOrigin(std::span<const glm::vec3> positions, FacePlanes& planes) {
  planes.origin = glm::vec3(0);
  planes.radius = 0.0f;
  if (positions.empty()) return;
  const Bounds bounds = BoundsOf(positions);
  const glm::dvec3 low(bounds.low), high(bounds.high);
  planes.origin = glm::vec3(0.5 * (low + high));
  // Half the diagonal, and what rounding the origin may have moved it.
  planes.radius = static_cast<float>(glm::length(0.5 * (high - low)) + glm::length(0.5 * (low + high)) * 1e-6);
}

glm::vec4 PlaneOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  if (!(length > 0.0) || !std::isfinite(length)) return glm::vec4(0);
  // The offset belongs to the rounded normal, so that the plane passes as close by the corners as floats allow.
  const glm::vec3 rounded(normal / length);
  return {rounded, static_cast<float>(-glm::dot(glm::dvec3(rounded), (a + b + c) / 3.0))};
}

}  // namespace

void ComputeFacePlanes(std::span<const std::uint32_t> triangles, std::span<const glm::vec3> positions,
                       std::span<const std::uint8_t> degenerate, FacePlanes& planes) {
  PlaceOrigin(positions, planes);
  planes.count = triangles.size() / 3;
  const std::size_t padded = (planes.count + 7) / 8 * 8;
  for (std::vector<float>* array : {&planes.x, &planes.y, &planes.z, &planes.w}) array->resize(padded, 0.0f);
  const glm::dvec3 origin(planes.origin);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, planes.count, kGrain), [&](const auto& range) {
    for (std::size_t f = range.begin(); f < range.end(); ++f) {
      glm::vec4 plane(0);
      if (degenerate.empty() || degenerate[f] == 0)
        plane = PlaneOf(glm::dvec3(positions[triangles[3 * f]]) - origin,
                        glm::dvec3(positions[triangles[3 * f + 1]]) - origin,
                        glm::dvec3(positions[triangles[3 * f + 2]]) - origin);
      planes.x[f] = plane.x;
      planes.y[f] = plane.y;
      planes.z[f] = plane.z;
      planes.w[f] = plane.w;
    }
  });
}

}  // namespace burin::overdraw
