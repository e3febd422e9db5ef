// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/overdraw/extract_edges.h"

namespace burin::overdraw {

/// One end-to-end edge of one object, as a frame draws it. Positions in world space.
struct EdgeSegment {
  std::array<glm::vec3, 2> ends;
  /// The corners of the left and the right face that lie off the edge; a boundary's right is its left.
  glm::vec3 left_corner{0.0f}, right_corner{0.0f};
  /// Indices in the frame's items; and among the vertices of the item's primitive: both ends and the corner.
  std::uint32_t left_item = 0, right_item = 0;
  std::array<std::uint32_t, 3> left_vertices{}, right_vertices{};
  EdgeClass edge_class = EdgeClass::kSilhouette;
  bool is_smooth = false;     ///< the two faces are shaded alike along it
  float beta = 0.0f;          ///< 0: the left face's shading alone ... 1: the right one's
  bool is_left_front = true;  ///< the face looks towards the eye
  bool is_right_front = true;
  bool shows_left = true;  ///< the face is on the screen, unless something hides it
  bool shows_right = true;
};

/// The edges of one frame in the order in which they are drawn: unsorted ones first, then back to front.
struct FrameEdges {
  std::vector<EdgeSegment> segments;
  EdgeStatistics statistics;
};

}  // namespace burin::overdraw
