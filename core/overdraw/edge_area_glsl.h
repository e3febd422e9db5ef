// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace burin::overdraw {

/// GLSL for pixels near an edge, given as EdgeRecord's `segment` and `depth`; it reads float depth_here, the picture's
/// depth at the pixel, and calls float DepthBeside(ivec2 to) for that at the four beside it.
///   bool CutToPixel(segment, out p, out q, out t)   the part of the edge in this pixel's square about its centre, and
///   the
///                                                   share of the segment at its middle; false when there is none
///   struct Beyond { float area; bool is_inside; ivec2 to; float z; float t; }
///   bool EdgeArea(segment, depth, out Beyond beyond)   the part of this pixel beyond the edge, seen from the centre:
///   its
///                                                      area, whether it is on the side of (-d.y, d.x), the neighbour
///                                                      there, the edge's depth and place; false when nothing is seen
[[nodiscard]] std::string_view EdgeAreaFunctions();

}  // namespace burin::overdraw
