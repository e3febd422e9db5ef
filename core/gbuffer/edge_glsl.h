// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace burin::gbuffer {

/// GLSL for fragments of a quadrilateral round an edge, with its depth texture at `unit`. It reads
///   vec4 v_segment   both ends in pixels; of an outline the surface is on the side of (-d.y, d.x), d from end to end
///   vec4 v_depth     reversed window depth at the ends; slack; below 0 for an outline
/// and declares
///   bool CutToPixel(out vec2 p, out vec2 q, out float z)   the part of the edge in this pixel's square about its
///                                                          centre, and its depth; false when there is none
///   float SurfaceDepth(ivec2 p)                                 the depth of the picture there
///   bool IsHidden(ivec2 p, ivec2 q, float z)               nearer surfaces at both pixels
///   struct Beyond { float area; bool is_inside; ivec2 to; float z; }
///   bool EdgeArea(out Beyond beyond)   the part of this pixel beyond the edge, seen from the centre: its area, whether
///   it
///                                      is on the side of (-d.y, d.x), the neighbour there, the edge's depth; false
///                                      when there is nothing to be seen
[[nodiscard]] std::string EdgeAreaFunctions(unsigned unit);

}  // namespace burin::gbuffer
