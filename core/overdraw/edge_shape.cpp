// SPDX-License-Identifier: Apache-2.0
// Slack: how far behind the picture's surface an edge may lie and still be part of it. At a pixel beside the edge the
// surface's depth is that of one of the edge's own faces, which falls off by the face's slope: each edge gets the slope
// of its own faces instead of one offset for all.
#include "core/overdraw/edge_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace burin::overdraw {
namespace {

constexpr float kSlopeReach = 1.5f;      // pixels from the edge to the centres that it is compared with
constexpr float kRelativeSlack = 4e-6f;  // of the rasterizer's interpolation
constexpr float kMostFold = 0.02f;       // of the depth
constexpr float kLargestSlope = 0.25f;   // of what the slope may add, as a share of the depth

/// True when `corner` lies on the side of (-d.y, d.x) of a to b in the picture, whatever is behind the eye.
bool IsOnPositiveSide(const glm::vec4& a, const glm::vec4& b, const glm::vec4& corner) {
  const auto row = [](const glm::vec4& v) { return glm::dvec3(v.x, -v.y, v.w); };
  return glm::dot(glm::cross(row(a), row(b)), row(corner)) > 0.0;
}

/// How far the depths of the edge's faces are apart.
float DepthExtent(const EdgeSegment& edge, const glm::vec4& a, const glm::vec4& b, const Projection& projection) {
  float low = std::min(a.z / a.w, b.z / b.w);
  float high = std::max(a.z / a.w, b.z / b.w);
  for (const glm::vec3& corner : {edge.left_corner, edge.right_corner}) {
    const glm::vec4 c = projection.Clip(corner);
    if (!(c.w > 0.0f)) continue;
    low = std::min(low, c.z / c.w);
    high = std::max(high, c.z / c.w);
  }
  return std::isfinite(high - low) ? high - low : 0.0f;
}

/// Off an outline's surface everything lies farther off whatever the slope.
float Slack(const EdgeSegment& edge, const glm::vec4& a, const glm::vec4& b, bool is_outline, float depth,
            const Projection& projection) {
  if (is_outline) return depth * kRelativeSlack;
  const float slope = std::min(projection.Slope(a, b, projection.Clip(edge.left_corner)),
                               projection.Slope(a, b, projection.Clip(edge.right_corner)));
  return depth * kRelativeSlack + std::min(kSlopeReach * slope, kLargestSlope * depth);
}

}  // namespace

EdgeShape ShapeOf(const EdgeSegment& edge, const Projection& projection) {
  EdgeShape shape;
  shape.a = projection.Clip(edge.ends[0]);
  shape.b = projection.Clip(edge.ends[1]);
  shape.is_left_positive = IsOnPositiveSide(shape.a, shape.b, projection.Clip(edge.left_corner));
  shape.is_right_positive = IsOnPositiveSide(shape.a, shape.b, projection.Clip(edge.right_corner));
  shape.is_outline = !edge.shows_left || !edge.shows_right || shape.is_left_positive == shape.is_right_positive;
  const float a = shape.a.z / shape.a.w;
  const float b = shape.b.z / shape.b.w;
  const float depth = shape.a.w > 0.0f && shape.b.w > 0.0f && std::isfinite(a + b) ? std::max(a, b) : 1.0f;
  shape.slack = Slack(edge, shape.a, shape.b, shape.is_outline, depth, projection);
  shape.fold_slack = shape.slack;
  if (shape.is_outline) {
    shape.fold_slack += std::min(DepthExtent(edge, shape.a, shape.b, projection), kMostFold * depth);
  }
  return shape;
}

}  // namespace burin::overdraw
