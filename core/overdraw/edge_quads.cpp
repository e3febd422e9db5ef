// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_quads.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/overdraw/edge_shape.h"
#include "core/overdraw/screen_projection.h"
#include "core/overdraw/screen_segment.h"

namespace burin::overdraw {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr float kMargin = 2.0f;  // pixels round the picture

/// Writes four vertices, or false.
bool BuildQuad(const EdgeSegment& edge, const QuadOptions& options, const Projection& projection, EdgeVertex* out) {
  const EdgeShape shape = ShapeOf(edge, projection);
  glm::vec4 clip_a = shape.a;
  glm::vec4 clip_b = shape.b;
  float kind = static_cast<float>(edge.edge_class);
  if (shape.is_outline) {
    kind = -1.0f - kind;
    if (!shape.OutlineIsPositive(edge)) std::swap(clip_a, clip_b);
  }
  const std::optional<ScreenSegment> cut =
      CutToPicture(clip_a, clip_b, projection, options.width, options.height, kMargin);
  if (!cut) return false;

  const glm::vec2 a(cut->a.x, cut->a.y);
  const glm::vec2 b(cut->b.x, cut->b.y);
  const float length = glm::length(b - a);
  const glm::vec2 along = length > 1e-6f ? (b - a) / length : glm::vec2(1.0f, 0.0f);
  const glm::vec2 across(-along.y, along.x);
  // Half the extent of a pixel's square in any of the two directions is (|x| + |y|) / 2.
  const float grow = 0.5f * (std::abs(along.x) + std::abs(along.y)) + 0.01f;
  const glm::vec4 segment(a.x, a.y, b.x, b.y);
  const glm::vec4 depths(cut->a.z, cut->b.z, shape.slack, kind);
  for (int corner = 0; corner < 4; ++corner) {
    const glm::vec2 end = (corner & 1) != 0 ? b + along * grow : a - along * grow;
    const glm::vec2 p = end + across * ((corner & 2) != 0 ? grow : -grow);
    out[corner] = {projection.ClipOfPixel(p.x, p.y), segment, depths};
  }
  return true;
}

}  // namespace

void BuildEdgeQuads(std::span<const EdgeSegment> segments, const QuadOptions& options,
                    std::vector<EdgeVertex>& vertices) {
  const Projection projection(options.clip_from_world, options.width, options.height);
  vertices.resize(4 * segments.size());
  std::vector<std::uint8_t> is_seen(segments.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, segments.size(), kGrain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        is_seen[i] = BuildQuad(segments[i], options, projection, &vertices[4 * i]) ? 1 : 0;
                      }
                    });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (is_seen[i] == 0) continue;
    if (kept != i) std::copy_n(&vertices[4 * i], 4, &vertices[4 * kept]);
    ++kept;
  }
  vertices.resize(4 * kept);
}

}  // namespace burin::overdraw
