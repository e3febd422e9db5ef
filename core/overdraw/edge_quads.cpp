// SPDX-License-Identifier: Apache-2.0
// Slack: how far behind the picture's surface an edge may lie and still be part of it. At a pixel beside the edge the
// surface's depth is that of one of the edge's own faces, which falls off by the face's slope: each edge gets the slope
// of its own faces instead of one offset for all.
#include "core/overdraw/edge_quads.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/overdraw/screen_projection.h"

namespace burin::overdraw {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr float kSlopeReach = 1.5f;      // pixels from the edge to the centres that it is compared with
constexpr float kRelativeSlack = 4e-6f;  // of the rasterizer's interpolation
constexpr float kFoldExtents = 1.0f;
constexpr float kMostFold = 0.02f;      // of the depth
constexpr float kLargestSlope = 0.25f;   // of what the slope may add, as a share of the depth

struct ScreenSegment {
  ScreenPoint a, b;
};

/// What is in front of the near plane (reversed depth: z <= w).
std::optional<ScreenSegment> CutAtNear(glm::vec4 a, glm::vec4 b, const Projection& projection) {
  const float da = a.w - a.z;
  const float db = b.w - b.z;
  if (!(da > 0.0f) && !(db > 0.0f)) return std::nullopt;
  if (!(da > 0.0f)) a += (b - a) * (da / (da - db));
  if (!(db > 0.0f)) b += (a - b) * (db / (db - da));
  if (!(a.w > 0.0f) || !(b.w > 0.0f)) return std::nullopt;
  return ScreenSegment{projection.Screen(a), projection.Screen(b)};
}

/// Liang and Barsky 1984: keeps the part in the picture and `margin` pixels around it.
bool CutAtBorder(ScreenSegment& s, float width, float height, float margin) {
  const float dx = s.b.x - s.a.x;
  const float dy = s.b.y - s.a.y;
  float first = 0.0f;
  float last = 1.0f;
  const auto cut = [&](float along, float distance) {
    if (along == 0.0f) return distance >= 0.0f;
    const float t = distance / along;
    if (along < 0.0f) {
      first = std::max(first, t);
    } else {
      last = std::min(last, t);
    }
    return first <= last;
  };
  if (!cut(-dx, s.a.x + margin) || !cut(dx, width + margin - s.a.x) || !cut(-dy, s.a.y + margin) ||
      !cut(dy, height + margin - s.a.y)) {
    return false;
  }
  const ScreenSegment whole = s;
  const auto at = [&](float t) {
    return ScreenPoint{whole.a.x + dx * t, whole.a.y + dy * t, whole.a.z + (whole.b.z - whole.a.z) * t};
  };
  if (first > 0.0f) s.a = at(first);
  if (last < 1.0f) s.b = at(last);
  return std::isfinite(s.a.x + s.a.y + s.a.z + s.b.x + s.b.y + s.b.z);
}

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

/// Off an outline's surface everything lies farther off whatever the slope; but where the outline of a mesh folds back
/// and forth, its own faces cover parts of it, which must count all the same so that the folds cancel out.
float Slack(const EdgeSegment& edge, const glm::vec4& a, const glm::vec4& b, bool is_outline, float depth,
            const Projection& projection) {
  if (is_outline) {
    return depth * kRelativeSlack + std::min(kFoldExtents * DepthExtent(edge, a, b, projection), kMostFold * depth);
  }
  const float slope = std::min(projection.Slope(a, b, projection.Clip(edge.left_corner)),
                               projection.Slope(a, b, projection.Clip(edge.right_corner)));
  return depth * kRelativeSlack + std::min(kSlopeReach * slope, kLargestSlope * depth);
}

/// Writes four vertices, or false.
bool BuildQuad(const EdgeSegment& edge, const QuadOptions& options, const Projection& projection, EdgeVertex* out) {
  if (!options.keeps_seams && edge.edge_class == EdgeClass::kSeam) return false;
  glm::vec4 clip_a = projection.Clip(edge.ends[0]);
  glm::vec4 clip_b = projection.Clip(edge.ends[1]);
  float kind = static_cast<float>(edge.edge_class);
  const bool left = IsOnPositiveSide(clip_a, clip_b, projection.Clip(edge.left_corner));
  const bool right = IsOnPositiveSide(clip_a, clip_b, projection.Clip(edge.right_corner));
  // An outline unless a surface is seen on either side.
  const bool is_outline = !edge.shows_left || !edge.shows_right || left == right;
  if (is_outline) {
    kind = -1.0f - kind;
    if (!(edge.shows_left ? left : right)) std::swap(clip_a, clip_b);
  }
  std::optional<ScreenSegment> cut = CutAtNear(clip_a, clip_b, projection);
  if (!cut) return false;
  const float margin = options.reach + 2.0f;
  if (!CutAtBorder(*cut, static_cast<float>(options.width), static_cast<float>(options.height), margin)) return false;

  const glm::vec2 a(cut->a.x, cut->a.y);
  const glm::vec2 b(cut->b.x, cut->b.y);
  const float length = glm::length(b - a);
  const glm::vec2 along = length > 1e-6f ? (b - a) / length : glm::vec2(1.0f, 0.0f);
  const glm::vec2 across(-along.y, along.x);
  // Half the extent of a pixel's square in any of the two directions is (|x| + |y|) / 2.
  const float grow = options.reach + 0.5f * (std::abs(along.x) + std::abs(along.y)) + 0.01f;
  const float depth = std::max(cut->a.z, cut->b.z);
  const glm::vec4 segment(a.x, a.y, b.x, b.y);
  const glm::vec4 depths(cut->a.z, cut->b.z, Slack(edge, clip_a, clip_b, is_outline, depth, projection), kind);
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
