// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec4.hpp>

#include "core/overdraw/frame_edges.h"
#include "core/overdraw/screen_projection.h"

namespace burin::overdraw {

/// How an edge lies in the picture.
struct EdgeShape {
  glm::vec4 a, b;  ///< its ends in clip space
  /// The face lies on the side of (-d.y, d.x), d from a to b in pixels (x right, y down).
  bool is_left_positive = false, is_right_positive = false;
  bool is_outline = false;  ///< no surface is seen on one of its sides
  float slack = 0.0f;       ///< window depth: how far behind the picture's surface it may lie and still be part of it
  /// The same where folds are summed: where the outline of a mesh folds back and forth, its own faces cover parts of
  /// it, which must count all the same so that the folds cancel out.
  float fold_slack = 0.0f;

  /// The side on which an outline's surface is seen.
  [[nodiscard]] bool OutlineIsPositive(const EdgeSegment& edge) const {
    return edge.shows_left ? is_left_positive : is_right_positive;
  }
};

[[nodiscard]] EdgeShape ShapeOf(const EdgeSegment& edge, const Projection& projection);

}  // namespace burin::overdraw
