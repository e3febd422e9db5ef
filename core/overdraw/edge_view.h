// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

namespace burin::overdraw {

/// From where one object is seen.
struct EdgeView {
  /// Object space: the eye's position with w = 1, or for an orthographic camera the direction towards it with w = 0.
  /// Facing is decided here, so mirrored transforms need no care.
  glm::vec4 eye{0.0f, 0.0f, 0.0f, 1.0f};
  /// Inverse transpose of object to world: blend factors and distances are those of world space. One that can't be
  /// inverted counts as the identity.
  glm::mat3 normal_matrix{1.0f};
  /// Orthographic only: world distance of the object's origin from the plane that distances are measured from, against
  /// the viewing direction counted positive, so that edges of several objects sort among each other.
  float eye_distance = 0.0f;
  float tau = 0.9f;    ///< of the asymmetric map, 0..1 (Sander et al. 2001, section 3.3)
  bool sorted = true;  ///< back to front, but edges that can't hide others first (section 3.4)
};

}  // namespace burin::overdraw
