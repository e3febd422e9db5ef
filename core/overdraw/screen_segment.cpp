// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/screen_segment.h"

#include <algorithm>
#include <cmath>

namespace burin::overdraw {
namespace {

/// What is in front of the near plane (reversed depth: z <= w).
std::optional<ScreenSegment> CutAtNear(glm::vec4 a, glm::vec4 b, const Projection& projection) {
  const float da = a.w - a.z;
  const float db = b.w - b.z;
  if (!(da > 0.0f) && !(db > 0.0f)) return std::nullopt;
  const glm::vec4 d = b - a;
  glm::vec2 range(0.0f, 1.0f);
  if (!(da > 0.0f)) a += d * (range.x = da / (da - db));
  if (!(db > 0.0f)) b -= d * (1.0f - (range.y = da / (da - db)));
  if (!(a.w > 0.0f) || !(b.w > 0.0f)) return std::nullopt;
  return ScreenSegment{projection.Screen(a), projection.Screen(b), range, {a.w, b.w}};
}

/// The share of a segment's range at the share `t` of its length in the picture.
float RangeAt(const ScreenSegment& s, float t) {
  const float share = t * s.w.x / (t * s.w.x + (1.0f - t) * s.w.y);
  return s.range.x + (s.range.y - s.range.x) * share;
}

ScreenSegment Part(const ScreenSegment& s, float first, float last) {
  const auto at = [&](float t) {
    return ScreenPoint{s.a.x + (s.b.x - s.a.x) * t, s.a.y + (s.b.y - s.a.y) * t, s.a.z + (s.b.z - s.a.z) * t};
  };
  const auto w_at = [&](float t) { return 1.0f / ((1.0f - t) / s.w.x + t / s.w.y); };
  return {at(first), at(last), {RangeAt(s, first), RangeAt(s, last)}, {w_at(first), w_at(last)}};
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
  if (first > 0.0f || last < 1.0f) s = Part(s, first, last);
  return std::isfinite(s.a.x + s.a.y + s.a.z + s.b.x + s.b.y + s.b.z + s.w.x + s.w.y);
}

}  // namespace

std::optional<ScreenSegment> CutToPicture(const glm::vec4& a, const glm::vec4& b, const Projection& projection,
                                          int width, int height, float margin) {
  std::optional<ScreenSegment> cut = CutAtNear(a, b, projection);
  if (!cut || !CutAtBorder(*cut, static_cast<float>(width), static_cast<float>(height), margin)) return std::nullopt;
  return cut;
}

}  // namespace burin::overdraw
