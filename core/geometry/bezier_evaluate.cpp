// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/bezier_evaluate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/geometry/bezier_check.h"

namespace burin::geometry {
namespace {

// Cross products below this share of the patch's squared extent are mostly rounding.
constexpr double kVanishingNormal = 1e-11;
// A limit's samples must stay this far above rounding for their direction to be good to 1e-6.
constexpr double kUsableNormal = 1e-9;

glm::dvec4 Widened(const glm::vec4& value) { return value; }
glm::dvec4 Widened(const glm::vec3& value) { return {value, 0.0}; }
glm::dvec4 Widened(const glm::vec2& value) { return {value, 0.0, 0.0}; }

struct CurvePoint {
  glm::dvec4 value{0.0}, derivative{0.0};
};

/// Overwrites `points`.
CurvePoint EvaluateCurve(std::span<glm::dvec4> points, double t) {
  const std::size_t degree = points.size() - 1;
  if (degree == 0) return {points[0], glm::dvec4(0.0)};
  for (std::size_t level = degree; level > 1; --level) {
    for (std::size_t i = 0; i < level; ++i) points[i] = (1.0 - t) * points[i] + t * points[i + 1];
  }
  return {(1.0 - t) * points[0] + t * points[1], static_cast<double>(degree) * (points[1] - points[0])};
}

using Row = std::array<glm::dvec4, kMaxBezierOrder>;

template <class Value>
NetPoint EvaluateQuad(const ControlNet& net, std::span<const Value> values, double u, double v) {
  Row row, along_v, du_along_v;
  for (std::size_t j = 0; j < net.v_order; ++j) {
    for (std::size_t i = 0; i < net.u_order; ++i) row[i] = Widened(values[net.first + j * net.u_order + i]);
    const CurvePoint at = EvaluateCurve(std::span(row).first(net.u_order), u);
    along_v[j] = at.value;
    du_along_v[j] = at.derivative;
  }
  const CurvePoint at = EvaluateCurve(std::span(along_v).first(net.v_order), v);
  return {at.value, EvaluateCurve(std::span(du_along_v).first(net.v_order), v).value, at.derivative};
}

template <class Value>
NetPoint EvaluateTriangle(const ControlNet& net, std::span<const Value> values, double u, double v) {
  const std::size_t order = net.u_order;
  const double w = 1.0 - u - v;
  std::array<Row, kMaxBezierOrder> points;
  for (std::size_t j = 0, at = net.first; j < order; ++j) {
    for (std::size_t i = 0; i + j < order; ++i) points[j][i] = Widened(values[at++]);
  }
  if (order == 1) return {points[0][0], glm::dvec4(0.0), glm::dvec4(0.0)};
  for (std::size_t level = order - 1; level > 1; --level) {
    for (std::size_t j = 0; j < level; ++j) {
      for (std::size_t i = 0; i + j < level; ++i)
        points[j][i] = w * points[j][i] + u * points[j][i + 1] + v * points[j + 1][i];
    }
  }
  const double degree = static_cast<double>(order - 1);
  return {w * points[0][0] + u * points[0][1] + v * points[1][0], degree * (points[0][1] - points[0][0]),
          degree * (points[1][0] - points[0][0])};
}

template <class Value>
NetPoint Evaluate(PatchDomain domain, const ControlNet& net, std::span<const Value> values, double u, double v) {
  return domain == PatchDomain::kQuad ? EvaluateQuad(net, values, u, v) : EvaluateTriangle(net, values, u, v);
}

/// Position and derivatives; of rational patches by the quotient rule.
BezierPoint Tangents(const BezierPatches& patches, const BezierPatch& patch, double u, double v) {
  const NetPoint at = EvaluateNet(patch.domain, patch.position, std::span(patches.positions), u, v);
  BezierPoint point{.position = at.value, .du = at.du, .dv = at.dv};
  if (!patch.is_rational) return point;
  const double inverse = 1.0 / at.value.w;
  point.position *= inverse;
  point.du = (point.du - at.du.w * point.position) * inverse;
  point.dv = (point.dv - at.dv.w * point.position) * inverse;
  return point;
}

/// Of the control points' box.
double SquaredExtent(const BezierPatches& patches, const BezierPatch& patch) {
  glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
  for (std::uint32_t i = 0; i < ValueCount(patch.domain, patch.position); ++i) {
    const glm::dvec4 value = patches.positions[patch.position.first + i];
    const glm::dvec3 point = patch.is_rational ? glm::dvec3(value) / value.w : glm::dvec3(value);
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return glm::dot(high - low, high - low);
}

glm::dvec3 CrossAt(const BezierPatches& patches, const BezierPatch& patch, glm::dvec2 at) {
  const BezierPoint point = Tangents(patches, patch, at.x, at.y);
  return glm::cross(point.du, point.dv);
}

/// The direction of du x dv on the way from the middle to `at`, extrapolated linearly from two places near it.
glm::dvec3 LimitNormal(const BezierPatches& patches, const BezierPatch& patch, glm::dvec2 at, double squared_extent) {
  // Not quite the middle, where patches that are folded symmetrically may vanish as well.
  const glm::dvec2 inside =
      patch.domain == PatchDomain::kQuad ? glm::dvec2(0.5078125, 0.5) : glm::dvec2(0.3359375, 0.328125);
  for (const double distance : {1e-4, 1e-3, 1e-2, 1e-1}) {
    const glm::dvec3 near = CrossAt(patches, patch, at + distance * (inside - at));
    const glm::dvec3 far = CrossAt(patches, patch, at + 2.0 * distance * (inside - at));
    const double near_length = glm::length(near), far_length = glm::length(far);
    if (!(std::min(near_length, far_length) > kUsableNormal * squared_extent)) continue;
    const glm::dvec3 limit = 2.0 * near / near_length - far / far_length;
    if (const double length = glm::length(limit); length > 0.5) return limit / length;
  }
  return {0.0, 0.0, 1.0};
}

glm::dvec3 UnitNormal(const BezierPatches& patches, const BezierPatch& patch, double u, double v,
                      const BezierPoint& point) {
  if (patch.normal) {
    const glm::dvec3 given = EvaluateNet(patch.domain, patch.normal, std::span(patches.normals), u, v).value;
    double largest = 0.0;
    for (std::uint32_t i = 0; i < ValueCount(patch.domain, patch.normal); ++i)
      largest = std::max(largest, glm::length(glm::dvec3(patches.normals[patch.normal.first + i])));
    if (const double length = glm::length(given); length > kVanishingNormal * largest) return given / length;
  }
  const double squared_extent = SquaredExtent(patches, patch);
  if (!(squared_extent > 0.0)) return {0.0, 0.0, 1.0};
  const glm::dvec3 cross = glm::cross(point.du, point.dv);
  if (const double length = glm::length(cross); length > kVanishingNormal * squared_extent) return cross / length;
  return LimitNormal(patches, patch, {u, v}, squared_extent);
}

}  // namespace

NetPoint EvaluateNet(PatchDomain domain, const ControlNet& net, std::span<const glm::vec4> values, double u, double v) {
  return Evaluate(domain, net, values, u, v);
}
NetPoint EvaluateNet(PatchDomain domain, const ControlNet& net, std::span<const glm::vec3> values, double u, double v) {
  return Evaluate(domain, net, values, u, v);
}
NetPoint EvaluateNet(PatchDomain domain, const ControlNet& net, std::span<const glm::vec2> values, double u, double v) {
  return Evaluate(domain, net, values, u, v);
}

BezierPoint EvaluateBezier(const BezierPatches& patches, const BezierPatch& patch, double u, double v) {
  BezierPoint point = Tangents(patches, patch, u, v);
  point.normal = UnitNormal(patches, patch, u, v, point);
  return point;
}

}  // namespace burin::geometry
