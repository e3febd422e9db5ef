// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/screen_projection.h"

#include <cmath>
#include <limits>

namespace burin::overdraw {

float Projection::Slope(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c) const {
  constexpr float kNone = std::numeric_limits<float>::infinity();
  if (!(a.w > 0.0f) || !(b.w > 0.0f) || !(c.w > 0.0f)) return kNone;
  const ScreenPoint p = Screen(a);
  const ScreenPoint q = Screen(b);
  const ScreenPoint r = Screen(c);
  const float ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z;
  const float vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
  const float area = ux * vy - uy * vx;
  const float slope = (std::abs(uz * vy - uy * vz) + std::abs(ux * vz - uz * vx)) / std::abs(area);
  return std::isfinite(slope) ? slope : kNone;
}

}  // namespace burin::overdraw
