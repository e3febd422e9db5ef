// SPDX-License-Identifier: Apache-2.0
// Going out from a pixel's centre, each edge changes the colour from that on its near side to that on its far side, for
// the area beyond it (edge_area_glsl.h). So the pixel's colour is the centre's plus, for each edge, its area times the
// difference: right for strips thinner than a pixel, corners, and any chain of short edges, as all terms add up.
// The colours are the shading of the edge's faces, so that faces that no pixel's centre sees have theirs too; what lies
// behind an outline has the colour of the pixel there, and so has a smooth surface at its outline (edge_records.h), if
// that pixel is on it.
#include "core/overdraw/resolve_glsl.h"

namespace burin::overdraw {

std::string_view ResolveBody() {
  return R"(
// A neighbour this much behind the edge, as a share of the depth, may still be on the outline's surface.
const float NEAR_ENOUGH = 0.02;

// Of outlines, towards the right, left, lower and upper neighbour: areas that a smooth surface covers though the centre
// is off it, where the neighbour is on it; areas that surfaces leave free though the centre is on their side.
vec4 covered = vec4(0.0), exposed = vec4(0.0);
float shaded_area = 0.0;          // areas covered by what has its own shading
float inner_area = 0.0;           // beyond edges that are no outlines
float all_areas = 0.0;
vec4 inner = vec4(0.0);           // what these change
vec4 outline = vec4(0.0);         // shading of outlines' surfaces, by their signed areas
float outline_area = 0.0;

void AddOutline(Beyond beyond, vec4 depth, vec4 color) {
  vec4 areas = beyond.area * max(vec4(beyond.to.x, -beyond.to.x, beyond.to.y, -beyond.to.y), vec4(0.0));
  float nearest = beyond.z - max(depth.z, NEAR_ENOUGH * beyond.z);
  if (!beyond.is_inside) exposed += areas;
  else if (depth.w < -1.5 && DepthBeside(beyond.to) >= nearest) covered += areas;
  else shaded_area += beyond.area;
  float signed_area = beyond.is_inside ? beyond.area : -beyond.area;
  outline += signed_area * color;
  outline_area += signed_area;
}

void Edge(int record) {
  vec4 segment = SegmentOf(record), depth = DepthOf(record);
  Beyond beyond;
  if (!EdgeArea(segment, depth, beyond)) return;
  uvec4 shade = ShadeOf(record);
  vec4 positive = ColorOf(shade.x, shade.z, beyond.t), negative = ColorOf(shade.y, shade.z, beyond.t);
  all_areas += beyond.area;
  if (depth.w < 0.0) {
    AddOutline(beyond, depth, positive);
  } else {
    inner += beyond.area * (beyond.is_inside ? positive - negative : negative - positive);
    inner_area += beyond.area;
  }
}

float Touched() { return all_areas; }

// The mean of the colours to the right, left, below and above, by their areas.
vec4 Mean(vec4 right, vec4 left, vec4 below, vec4 above, vec4 areas) {
  return areas.x * Linear(right) + areas.y * Linear(left) + areas.z * Linear(below) + areas.w * Linear(above);
}

vec4 End(ivec2 p) {
  vec4 here = Stored(p), right = Stored(p + ivec2(1, 0)), left = Stored(p - ivec2(1, 0)),
       below = Stored(p + ivec2(0, 1)), above = Stored(p - ivec2(0, 1));
  vec4 centre = Linear(here);
  float front = dot(covered, vec4(1.0)) + shaded_area;
  float back = dot(exposed, vec4(1.0));
  // Surfaces that cover, less what they leave free again: thin ones cover only the difference.
  float sum = clamp(front - back, -1.0, 1.0);
  // What an outline's surface looks like where the centre may not show it.
  vec4 shade = centre;
  bool needs_shade = shaded_area > 0.0 || inner_area > 0.0;
  if (needs_shade && abs(outline_area) > 1e-5) shade = max(outline / outline_area, vec4(0.0));
  vec4 beside = Mean(right, left, below, above, sum > 0.0 ? covered : exposed);
  vec4 color = centre + inner;
  if (sum > 0.0) color += (sum / front) * (beside + shaded_area * shade) - sum * centre;
  if (sum < 0.0) color += (-sum / back) * beside + sum * (inner_area > 0.0 ? shade : centre);
  if (abs(color.a - 1.0) < 1e-5) color.a = 1.0;   // areas are rounded, and what is opaque stays so
  // Shading at the edge itself may catch a highlight that no pixel has, and differences of highlights leave holes.
  if (inner_area > 0.0) {
    vec4 a = Stored(p + ivec2(-1, -1)), b = Stored(p + ivec2(1, -1)), c = Stored(p + ivec2(-1, 1)),
         d = Stored(p + ivec2(1, 1));
    least = min(min(min(a, b), min(c, d)), min(min(right, left), min(min(below, above), here)));
    most = max(max(max(a, b), max(c, d)), max(max(right, left), max(max(below, above), here)));
  }
  return max(color, vec4(0.0));
}
)";
}

}  // namespace burin::overdraw
