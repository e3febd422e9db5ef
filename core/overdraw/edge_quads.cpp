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

namespace burin::overdraw {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr float kMargin = 2.0f;  // pixels round the picture

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
  std::optional<ScreenSegment> cut = CutAtNear(clip_a, clip_b, projection);
  if (!cut) return false;
  if (!CutAtBorder(*cut, static_cast<float>(options.width), static_cast<float>(options.height), kMargin)) return false;

  const glm::vec2 a(cut->a.x, cut->a.y);
  const glm::vec2 b(cut->b.x, cut->b.y);
  const float length = glm::length(b - a);
  const glm::vec2 along = length > 1e-6f ? (b - a) / length : glm::vec2(1.0f, 0.0f);
  const glm::vec2 across(-along.y, along.x);
  // Half the extent of a pixel's square in any of the two directions is (|x| + |y|) / 2.
  const float grow = 0.5f * (std::abs(along.x) + std::abs(along.y)) + 0.01f;
  const glm::vec4 segment(a.x, a.y, b.x, b.y);
  const glm::vec4 depths(cut->a.z, cut->b.z, (options.sums_folds ? shape.fold_slack : shape.slack), kind);
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
