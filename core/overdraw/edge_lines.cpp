// SPDX-License-Identifier: Apache-2.0
// Slack: half of a line lies over the edge's own faces, which may come nearer than the edge there by their slope. The
// paper pushes all triangles back by one polygon offset instead.
#include "core/overdraw/edge_lines.h"

#include <algorithm>
#include <cmath>

#include "core/overdraw/edge_shape.h"
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

gbuffer::ShadedLine LeftLine(const EdgeSegment& edge) {
  gbuffer::ShadedLine line;
  line.item = edge.left_item;
  line.vertices = edge.left_vertices;
  line.is_back = !edge.is_left_front;
  return line;
}

gbuffer::ShadedLine RightLine(const EdgeSegment& edge) {
  gbuffer::ShadedLine line;
  line.item = edge.right_item;
  line.vertices = edge.right_vertices;
  line.is_back = !edge.is_right_front;
  return line;
}

}  // namespace

void BuildShadedLines(std::span<const EdgeSegment> segments, const glm::mat4& clip_from_world, int width, int height,
                      std::vector<gbuffer::ShadedLine>& lines) {
  const Projection projection(clip_from_world, width, height);
  lines.clear();
  for (const EdgeSegment& edge : segments) {
    const float slack = Slack(edge, projection);
    gbuffer::ShadedLine left = LeftLine(edge);
    gbuffer::ShadedLine right = RightLine(edge);
    left.alpha = 1.0f - edge.beta;
    right.alpha = edge.beta;
    left.slack = right.slack = slack;
    const bool begins_left = edge.beta < 0.5f;
    gbuffer::ShadedLine first = begins_left ? left : right;
    first.alpha = 1.0f;
    lines.push_back(first);
    const gbuffer::ShadedLine& second = begins_left ? right : left;
    if (second.alpha > 0.0f) lines.push_back(second);
  }
}

void BuildAreaLines(std::span<const EdgeSegment> segments, const glm::mat4& clip_from_world, int width, int height,
                    AreaLines& lines) {
  const Projection projection(clip_from_world, width, height);
  lines.inner.clear();
  lines.outlines.clear();
  const auto add = [](std::vector<gbuffer::ShadedLine>& list, gbuffer::ShadedLine line, const EdgeShape& shape,
                      bool is_positive) {
    line.slack = shape.fold_slack;
    line.is_outline = shape.is_outline;
    line.is_flipped = !is_positive;
    list.push_back(line);
  };
  for (const EdgeSegment& edge : segments) {
    const EdgeShape shape = ShapeOf(edge, projection);
    if (shape.is_outline) {
      // The face that looks towards the eye, where both are on the screen: a double-sided mesh.
      const bool takes_left = edge.shows_left && (edge.is_left_front || !edge.shows_right);
      add(lines.outlines, takes_left ? LeftLine(edge) : RightLine(edge), shape, shape.OutlineIsPositive(edge));
    } else {
      add(lines.inner, LeftLine(edge), shape, shape.is_left_positive);
      add(lines.inner, RightLine(edge), shape, shape.is_right_positive);
    }
  }
}

}  // namespace burin::overdraw
