// SPDX-License-Identifier: Apache-2.0
// Slack: half of a line lies over the edge's own faces, which may come nearer than the edge there by their slope. The
// paper pushes all triangles back by one polygon offset instead.
#include "core/overdraw/edge_lines.h"

#include <algorithm>
#include <cmath>

#include "core/overdraw/screen_projection.h"

namespace burin::overdraw {
namespace {

constexpr float kReach = 1.5f;           // pixels from the edge to the centres that its line covers
constexpr float kRelativeSlack = 4e-6f;  // of the rasterizer's interpolation
constexpr float kMostSlack = 0.02f;      // of the depth: faces seen edge on have any slope

float Slack(const EdgeSegment& edge, const Projection& projection) {
  const glm::vec4 a = projection.Clip(edge.ends[0]);
  const glm::vec4 b = projection.Clip(edge.ends[1]);
  float slope = 0.0f;
  if (edge.shows_left) slope = std::max(slope, projection.Slope(a, b, projection.Clip(edge.left_corner)));
  if (edge.shows_right) slope = std::max(slope, projection.Slope(a, b, projection.Clip(edge.right_corner)));
  const float depth = std::max(a.z / a.w, b.z / b.w);
  if (!(a.w > 0.0f) || !(b.w > 0.0f) || !std::isfinite(depth)) return 0.0f;
  return depth * kRelativeSlack + std::min(kReach * slope, kMostSlack * depth);
}

}  // namespace

void BuildShadedLines(std::span<const EdgeSegment> segments, const glm::mat4& clip_from_world, int width, int height,
                      std::vector<gbuffer::ShadedLine>& lines) {
  const Projection projection(clip_from_world, width, height);
  lines.clear();
  for (const EdgeSegment& edge : segments) {
    const float slack = Slack(edge, projection);
    const gbuffer::ShadedLine left{edge.left_item, edge.left_vertices, 1.0f - edge.beta, slack, !edge.is_left_front};
    const gbuffer::ShadedLine right{edge.right_item, edge.right_vertices, edge.beta, slack, !edge.is_right_front};
    const bool begins_left = edge.beta < 0.5f;
    gbuffer::ShadedLine first = begins_left ? left : right;
    first.alpha = 1.0f;
    lines.push_back(first);
    const gbuffer::ShadedLine& second = begins_left ? right : left;
    if (second.alpha > 0.0f) lines.push_back(second);
  }
}

}  // namespace burin::overdraw
