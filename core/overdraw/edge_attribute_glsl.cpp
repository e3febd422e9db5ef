// SPDX-License-Identifier: Apache-2.0
// An edge is seen where the surfaces beside it are not in front of it. That is asked at points of the edge, never at
// the pixels around it, so that a line is as wide as it should be and an edge behind something does not shine through.
// The vertex shader walks along the edge pixel by pixel, keeps the part from the first to the last point that is seen,
// and says if something hides points between. Where an object ends an edge, that object's own outline is as near as the
// end, so the nearest point of the kept part is all that a pixel has to ask about.
//
// An outline has its surface on one side, curved towards the eye as steeply as may be: only the nearest pixel off that
// surface tells. What stands on a plane has the plane in front of its lower outline there, one pixel nearer to the eye,
// and what lies just under a plane has it behind its upper one; three pixels in a row that lie in one plane are
// therefore followed to the edge.
#include "core/overdraw/edge_attribute_glsl.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "core/overdraw/edge_kind.h"

namespace burin::overdraw {
namespace {

constexpr std::string_view kSeen = R"(
layout(binding = 0) uniform sampler2D depth_texture;

const float SNAP = 1.0 / 128.0;        // pixels: the rasterizer's corners lie on a grid
const float PLANE = 0.1;               // of the step between two pixels: how little a plane may bend
const float FOLLOWED = 0.02;           // of that step: how exactly a plane is followed, the grid's width included
const float ROUNDING = 2e-5;           // of the depth

// Pixels from the picture's border to where edges end: beyond it nothing hides them.
const float BORDER = 1.0;

float Surface(ivec2 p) { return texelFetch(depth_texture, clamp(p, ivec2(0), textureSize(depth_texture, 0) - 1), 0).r; }

// The first pixel centre past x in one direction, by more than the grid's width.
float CentreBelow(float x) { return ceil(x - 0.5 - SNAP) - 0.5; }
float CentreAbove(float x) { return floor(x - 0.5 + SNAP) + 1.5; }

// `segment`, `depth`: as in EdgeVertex; t: 0 at the first end, 1 at the second.
bool IsSeen(vec4 segment, vec4 depth, float t) {
  vec2 d = segment.zw - segment.xy;
  bool is_steep = abs(d.y) >= abs(d.x);
  // The edge's point on a line through pixel centres, so that depths need to be followed in one direction only.
  vec2 c = segment.xy + d * t;
  vec2 to_centre = floor(c) + 0.5 - c;
  float most = is_steep ? d.y : d.x;
  if (abs(most) > 1e-6) t = clamp(t + (is_steep ? to_centre.y : to_centre.x) / most, -1.0, 2.0);
  ivec2 line = ivec2(floor(c));
  c = segment.xy + d * t;
  float z = mix(depth.x, depth.y, t);
  float x = is_steep ? c.x : c.y;
  ivec2 stride = is_steep ? ivec2(1, 0) : ivec2(0, 1);
  line *= 1 - stride;
  float below = CentreBelow(x);
  float above = CentreAbove(x);
  float s0 = Surface(line + stride * int(floor(below)));
  if (depth.w >= 0.0) return min(s0, Surface(line + stride * int(floor(above)))) <= z + depth.z;

  // Off the surface: against (-d.y, d.x).
  float across = is_steep ? -d.y : d.x;
  int away = across > 0.0 ? -1 : 1;
  float first = away < 0 ? below : above;
  ivec2 p = line + stride * int(floor(first));
  if (away > 0) s0 = Surface(p);
  float s1 = Surface(p + stride * away);
  float s2 = Surface(p + stride * (2 * away));
  float change = s0 - s1;
  if (abs(change - (s1 - s2)) > PLANE * abs(change) + ROUNDING * z) return s0 <= z + depth.z;
  return s0 + change * abs(first - x) <= z + depth.z + FOLLOWED * abs(change);
}
)";

constexpr std::string_view kVertexBody = R"(
layout(location = 1) in vec4 segment;
layout(location = 2) in vec4 depth;
uniform float reach;
const float ASIDE = 0.75;   // pixels
flat out vec4 v_segment;    // the part that is seen, from the first to the last point
flat out vec4 v_depth;      // as in EdgeVertex, of that part
flat out vec3 v_ends;       // above 0: it goes on hidden before the first point; after the last one; between them

// Liang and Barsky 1984.
vec2 CutToPicture(vec2 a, vec2 d, vec2 size) {
  vec2 away = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(d, vec2(0.0)));
  vec2 inverse = away / max(abs(d), vec2(1e-12));
  vec2 middle = 0.5 * size - a;
  vec2 half_size = 0.5 * size + BORDER;
  vec2 first = (middle - half_size * away) * inverse;
  vec2 last = (middle + half_size * away) * inverse;
  return vec2(max(max(first.x, first.y), 0.0), min(min(last.x, last.y), 1.0));
}

void main() {
  vec2 size = vec2(textureSize(depth_texture, 0));
  vec2 a = segment.xy;
  vec2 d = segment.zw - a;
  vec2 part = CutToPicture(a, d, size);
  // Halves of a pixel, the middle of each step.
  int steps = int(ceil(2.0 * length(d) * (part.y - part.x)));
  steps = max(steps, 1);
  float width = (part.y - part.x) / float(steps);
  int first = steps;
  int last = -1;
  int seen = 0;
  for (int i = 0; part.x <= part.y && i < steps; ++i) {
    if (!IsSeen(segment, depth, part.x + (float(i) + 0.5) * width)) continue;
    first = min(first, i);
    last = i;
    ++seen;
  }
  float begin = part.x + float(first) * width;
  float end = part.x + float(last + 1) * width;
  float aside = ASIDE / max(length(d), ASIDE);
  v_ends.x = first > 0 || !IsSeen(segment, depth, begin - aside) ? 1.0 : 0.0;
  v_ends.y = last < steps - 1 || !IsSeen(segment, depth, end + aside) ? 1.0 : 0.0;
  v_ends.z = seen < last - first + 1 ? 1.0 : 0.0;
  v_segment = vec4(a + d * begin, a + d * end);
  v_depth = vec4(mix(depth.x, depth.y, begin), mix(depth.x, depth.y, end), depth.zw);
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
  if (seen == 0) return;  // four corners in one point: nothing is drawn

  float far = length(v_segment.zw - v_segment.xy);
  vec2 along = far > 1e-6 ? (v_segment.zw - v_segment.xy) / far : vec2(1.0, 0.0);
  int corner = gl_VertexID & 3;
  float grow = reach + 0.01;
  vec2 p = (corner & 1) != 0 ? v_segment.zw + along * grow : v_segment.xy - along * grow;
  p += vec2(-along.y, along.x) * ((corner & 2) != 0 ? grow : -grow);
  gl_Position = vec4(2.0 * p.x / size.x - 1.0, 1.0 - 2.0 * p.y / size.y, 0.0, 1.0);
}
)";

constexpr std::string_view kFragmentInputs = R"(
flat in vec4 v_segment;
flat in vec4 v_depth;
flat in vec3 v_ends;

// The place seen from the edge: pixels along it from its first end, and across it, above 0 on an outline's surface.
// `length_along`: of the edge.
vec2 Place(out float length_along) {
  vec2 a = gl_FragCoord.xy - v_segment.xy;
  vec2 d = v_segment.zw - v_segment.xy;
  length_along = length(d);
  vec2 along = length_along > 1e-6 ? d / length_along : vec2(1.0, 0.0);
  return vec2(dot(a, along), dot(a, vec2(-along.y, along.x)));
}

// A gap has to be two steps wide: a single point between a surface's facets is no end of the line.
bool IsHiddenAt(float along, float length_along) {
  if (v_ends.z == 0.0) return false;
  float t = length_along > 0.0 ? clamp(along / length_along, 0.0, 1.0) : 0.0;
  float aside = 0.5 / max(length_along, 0.5);
  return !IsSeen(v_segment, v_depth, t) && !IsSeen(v_segment, v_depth, max(t - aside, 0.0)) &&
         !IsSeen(v_segment, v_depth, min(t + aside, 1.0));
}
)";

constexpr std::string_view kCoverageBody = R"(
layout(location = 0) out vec4 result;

void main() {
  float length_along;
  vec2 place = Place(length_along);
  float beyond = max(max(-place.x, place.x - length_along), 0.0);
  float coverage = clamp(1.0 - abs(place.y), 0.0, 1.0) * clamp(1.0 - beyond, 0.0, 1.0);
  if (coverage <= 0.0 || IsHiddenAt(place.x, length_along)) discard;
  float edge_class = v_depth.w < 0.0 ? -1.0 - v_depth.w : v_depth.w;
  result = coverage * vec4(edge_class == SILHOUETTE, edge_class == CREASE, edge_class == BOUNDARY,
                           edge_class == MATERIAL);
}
)";

// Which side counts where several edges are about equally near. Two that share their nearest point tell the sides of a
// corner apart only if the one that faces the pixel more squarely counts. Where an edge goes behind a surface, its end
// lies within a pixel of that surface's outline, on either side: the outline counts, and so it does against creases
// that run along it.
constexpr std::string_view kDistanceBody = R"(
layout(location = 0) out vec4 result;

const float LEAN = 1.0 / 1024.0;     // pixels
const float INNER = 1.0;             // pixels; of hidden ends and of edges both of whose faces show
const float HIDDEN_END = 3.0;        // pixels along the edge
const float SHORTEST = 1.0 / 64.0;   // pixels; of edges with a direction
const float NONE = 4.0 * REACH;

void main() {
  float length_along;
  vec2 place = Place(length_along);
  float beyond = max(max(-place.x, place.x - length_along), 0.0);
  float far = length(vec2(beyond, place.y));
  if (far > REACH || IsHiddenAt(place.x, length_along)) discard;
  bool is_outline = v_depth.w < 0.0;
  float side = far;
  float from_end = min(v_ends.x > 0.0 ? place.x : HIDDEN_END, v_ends.y > 0.0 ? length_along - place.x : HIDDEN_END);
  if (!is_outline || from_end < HIDDEN_END) side += INNER;
  if (beyond > 0.0) {
    float square = length_along >= SHORTEST ? abs(place.y) / far : 0.0;
    side += LEAN * (1.0 - square);
  }
  bool is_on_surface = is_outline && place.y > 0.0;
  result = vec4(is_on_surface ? side : NONE, is_on_surface ? NONE : side, far, 0.0);
}
)";

constexpr std::string_view kVersion = "#version 450 core\n";

}  // namespace

std::string EdgeLineVertexText() { return std::string(kVersion).append(kSeen).append(kVertexBody); }

std::string EdgeCoverageFragmentText() {
  std::string text(kVersion);
  const auto constant = [&](std::string_view name, EdgeClass edge_class) {
    text += fmt::format("const float {} = {}.0;\n", name, static_cast<int>(edge_class));
  };
  constant("SILHOUETTE", EdgeClass::kSilhouette);
  constant("CREASE", EdgeClass::kCrease);
  constant("BOUNDARY", EdgeClass::kBoundary);
  constant("MATERIAL", EdgeClass::kMaterial);
  return text.append(kSeen).append(kFragmentInputs).append(kCoverageBody);
}

std::string EdgeDistanceFragmentText() {
  std::string text(kVersion);
  text += fmt::format("const float REACH = {}.0;\n", kLargestEdgeDistance);
  return text.append(kSeen).append(kFragmentInputs).append(kDistanceBody);
}

std::string EdgeStoreVertexText() {
  return std::string(kVersion) + "layout(location = 0) in vec4 position;\nvoid main() { gl_Position = position; }\n";
}

std::string EdgeStoreFragmentText(const gbuffer::Storage& storage) {
  std::string text(kVersion);
  text += "layout(binding = 0) uniform sampler2D gathered;\nlayout(location = 0) out vec4 result;\n";
  text += gbuffer::StorageFunctions();
  text += "void main() {\n  vec4 value = texelFetch(gathered, ivec2(gl_FragCoord.xy), 0);\n";
  if (storage.attribute == gbuffer::Attribute::kEdgeDist) {
    const std::array<float, 4> empty = gbuffer::StoredBackground(storage, {});
    text += fmt::format(
        "  float nearest = value.z;\n"
        "  value = vec4(value.x < value.y ? -nearest : nearest, 0.0, 0.0, 0.0);\n"
        "  result = nearest <= {}.0 ? {} : vec4({:#g}, {:#g}, {:#g}, {:#g});\n",
        kLargestEdgeDistance, gbuffer::StoreExpression(storage, "value"), empty[0], empty[1], empty[2], empty[3]);
  } else {
    text += fmt::format("  result = {};\n", gbuffer::StoreExpression(storage, "value"));
  }
  return text + "}\n";
}

}  // namespace burin::overdraw
