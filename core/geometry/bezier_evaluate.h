// SPDX-License-Identifier: Apache-2.0
#pragma once
// One point of a Bézier patch as exactly as double precision allows: de Casteljau's algorithm (G. Farin, "Curves and
// Surfaces for CAGD", chapters 4, 11 and 17).

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/ext/vector_double4.hpp>
#include <span>

#include "core/geometry/bezier_patches.h"

namespace burin::geometry {

struct BezierPoint {
  glm::dvec3 position{0.0};
  glm::dvec3 du{0.0}, dv{0.0};  ///< derivatives; of rational patches those of the quotient
  /// Unit length: of the normal net where the patch has one, else of du x dv. Where that vanishes (poles, coinciding
  /// control points), its limit on the way from the middle of the patch. (0, 0, 1) where the patch has no area at all.
  glm::dvec3 normal{0.0, 0.0, 1.0};
};

/// The patch at (u, v) of its domain. The patch must have passed CheckPatches.
[[nodiscard]] BezierPoint EvaluateBezier(const BezierPatches& patches, const BezierPatch& patch, double u, double v);

/// Value and derivatives of one net.
struct NetPoint {
  glm::dvec4 value{0.0}, du{0.0}, dv{0.0};
};
[[nodiscard]] NetPoint EvaluateNet(PatchDomain domain, const ControlNet& net, std::span<const glm::vec4> values,
                                   double u, double v);
[[nodiscard]] NetPoint EvaluateNet(PatchDomain domain, const ControlNet& net, std::span<const glm::vec3> values,
                                   double u, double v);
[[nodiscard]] NetPoint EvaluateNet(PatchDomain domain, const ControlNet& net, std::span<const glm::vec2> values,
                                   double u, double v);

}  // namespace burin::geometry
