// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/overdraw/frame_edges.h"

namespace burin::overdraw {

/// A corner of the quadrilateral round one edge. All but `position` is the same at its four corners.
struct EdgeVertex {
  glm::vec2 position;  ///< clip space, w = 1
  /// Both ends in pixels, x right and y down from the picture's top left corner. The surface of an outline lies on the
  /// side of (-d.y, d.x), d from the first end to the second.
  glm::vec4 segment;
  /// Reversed window depth at the ends; slack (edge_shape.h); EdgeClass, or -1 - EdgeClass where the surface is seen
  /// on one side only: an outline.
  glm::vec4 depth;
};

struct QuadOptions {
  glm::mat4 clip_from_world{1.0f};  ///< depth reversed: 1 at the near plane, 0 at the far one
  int width = 0;                    ///< pixels
  int height = 0;
};

/// Four vertices an edge that is in the picture, in the order of `segments`: to be drawn as two triangles (0 1 2, 2 1
/// 3). Edges are cut at the near plane and at the picture's border. The result does not depend on the number of
/// threads.
void BuildEdgeQuads(std::span<const EdgeSegment> segments, const QuadOptions& options,
                    std::vector<EdgeVertex>& vertices);

}  // namespace burin::overdraw
