// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace burin::overdraw {

/// Two cones of eyes about one axis: from `front` along the axis every face of a cluster looks towards the eye, from
/// `back` against the axis every face looks away.
struct SilhouetteCone {
  /// The least dot(normal, axis) of a cluster that gets cones; below, they would be too narrow to be of use.
  static constexpr float kLeastSine = 0.125f;
  /// Anchors stay within this many radii of the origin, or there is no cone.
  static constexpr float kFarthestAnchor = 2.0f;
  /// A cosine that no eye reaches: the cluster is always opened.
  static constexpr float kNever = 4.0f;

  glm::vec3 axis{0.0f, 0.0f, 1.0f};
  float cosine = kNever;  ///< of half the opening angle
  glm::vec3 front{0.0f}, back{0.0f};

  /// How far, at least, an eye is in front of (behind) every plane for each unit of
  /// dot(axis, eye - anchor) - cosine * |eye - anchor|: sine / (1 + cosine).
  [[nodiscard]] float Depth() const {
    return cosine < 1.0f ? std::sqrt(1.0f - cosine * cosine) / (1.0f + cosine) : 1.0f;
  }
};

}  // namespace burin::overdraw
