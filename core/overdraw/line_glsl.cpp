// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/line_glsl.h"

namespace burin::overdraw {

std::string_view LineBody() {
  return R"(
vec4 over = vec4(0.0);
float shows = 1.0;    // of the picture
float drawn = 0.0;

void Edge(int record) {
  vec4 segment = SegmentOf(record);
  vec2 p = gl_FragCoord.xy - segment.xy, d = segment.zw - segment.xy;
  float size = length(d);
  vec2 along = size > 1e-6 ? d / size : vec2(1.0, 0.0);
  float place = dot(p, along);
  float beyond = max(max(-place, place - size), 0.0);
  float weight = clamp(1.0 - abs(dot(p, vec2(-along.y, along.x))), 0.0, 1.0) * clamp(1.0 - beyond, 0.0, 1.0);
  float t = size > 1e-6 ? clamp(place / size, 0.0, 1.0) : 0.5;
  if (weight > 0.0) {

    vec4 depth = DepthOf(record);
    uvec4 shade = ShadeOf(record);
    bool is_seen = mix(depth.x, depth.y, t) + depth.z >= depth_here;
    weight = is_seen ? weight * depth.w : 0.0;
    vec4 color = weight * ColorOf(shade.x, shade.z, t);
    over = color + (1.0 - color.a) * over;
    shows *= 1.0 - color.a;
    drawn += weight;
  }
}

float Touched() { return drawn; }

vec4 End(ivec2 p) { return over + shows * Linear(Stored(p)); }
)";
}

}  // namespace burin::overdraw
