// SPDX-License-Identifier: Apache-2.0
// The area beyond an edge, seen from the pixel's centre, is the sector of the pixel's square between the edge's ends
// less the triangle of the centre and the edge. The sectors of a chain of edges add up, so however many short edges
// cross a pixel, the sum is the area beyond the chain: no samples, nothing that steps as the picture moves.
// The cut: Liang and Barsky 1984, against the pixel's square.
#include "core/overdraw/edge_area_glsl.h"

namespace burin::overdraw {

std::string_view EdgeAreaFunctions() {
  return R"(
bool CutToPixel(vec4 segment, out vec2 p, out vec2 q, out float t) {
  vec2 a = segment.xy - gl_FragCoord.xy;
  vec2 d = segment.zw - segment.xy;
  vec2 away = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(d, vec2(0.0)));
  vec2 inverse = away / max(abs(d), vec2(1e-12));
  vec2 first = (-0.5 * away - a) * inverse;
  vec2 last = (0.5 * away - a) * inverse;
  float t0 = max(max(first.x, first.y), 0.0);
  float t1 = min(min(last.x, last.y), 1.0);
  p = a + d * t0;
  q = a + d * t1;
  t = 0.5 * (t0 + t1);
  return t0 < t1;
}

// Where a direction from the centre meets the square's border: length along it in pixels, 0 to 4.
float Perimeter(vec2 v) {
  vec2 s = v / max(max(abs(v.x), abs(v.y)), 1e-12);
  if (abs(v.x) >= abs(v.y)) return v.x >= 0.0 ? 0.5 * s.y : 2.0 - 0.5 * s.y;
  return v.y >= 0.0 ? 1.0 - 0.5 * s.x : 3.0 + 0.5 * s.x;
}

struct Beyond { float area; bool is_inside; ivec2 to; float z; float t; };

bool EdgeArea(vec4 segment, vec4 depth, out Beyond beyond) {
  vec2 p, q;
  bool is_cut = CutToPixel(segment, p, q, beyond.t);
  beyond.z = mix(depth.x, depth.y, beyond.t);
  float along = Perimeter(q) - Perimeter(p);
  along = abs(along - 4.0 * round(0.25 * along));
  beyond.area = 0.25 * along - 0.5 * abs(p.x * q.y - p.y * q.x);
  vec2 d = segment.zw - segment.xy;
  vec2 inwards = vec2(-d.y, d.x);
  beyond.is_inside = dot(inwards, p + q) > 0.0;
  // Through the very centre: the centre is on an outline's surface if the picture has it there.
  bool crosses = max(abs(p.x), abs(p.y)) > 0.4999 && max(abs(q.x), abs(q.y)) > 0.4999;
  if (depth.w < 0.0 && crosses && abs(dot(inwards, p + q)) < 0.04 * length(d)) {
    beyond.is_inside = depth_here < beyond.z - depth.z;
  }
  vec2 across = beyond.is_inside ? inwards : -inwards;
  bool is_wide = abs(across.x) >= abs(across.y);
  beyond.to = is_wide ? ivec2(across.x < 0.0 ? -1 : 1, 0) : ivec2(0, across.y < 0.0 ? -1 : 1);
  return is_cut && beyond.area > 0.0 && min(depth_here, DepthBeside(beyond.to)) <= beyond.z + depth.z;
}
)";
}

}  // namespace burin::overdraw
