// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/gather_glsl.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "core/gbuffer/gpu_blocks.h"
#include "core/translucency/body_block.h"
#include "core/translucency/dipole_table.h"
#include "core/translucency/face_glsl.h"
#include "core/translucency/paper_glsl.h"

namespace burin::translucency {
namespace {

constexpr std::string_view kPacking = R"(
struct Source { vec3 light; float area; vec3 place; };

Source Unpack(uvec4 t) {
  Source s;
  vec2 low = unpackHalf2x16(t.z);
  s.light = vec3(low, unpackHalf2x16(t.w).x);
  s.place = vec3(float(t.x & 0xffffu), float(t.x >> 16), float(t.y & 0xffffu)) * (1.0 / 65535.0);
  s.area = unpackHalf2x16(t.y).y;
  return s;
}

uvec4 Pack(Source s) {
  uvec3 place = uvec3(clamp(s.place, 0.0, 1.0) * 65535.0 + 0.5);
  s.light = min(s.light, vec3(65504.0));
  return uvec4(place.x | (place.y << 16), place.z | (packHalf2x16(vec2(0.0, s.area)) & 0xffff0000u),
               packHalf2x16(s.light.rg), packHalf2x16(vec2(s.light.b, 0.0)));
}

// Where level k begins, downwards: two rows of faces a level.
int LevelTop(int k) { return 4 * box_texels.w - ((4 * box_texels.w) >> k); }
)";

constexpr std::string_view kBaseBody = R"(
layout(binding = 0) uniform sampler2D light_sums;
layout(binding = 1) uniform sampler2D place_sums;
layout(location = 0) out uvec4 packed_source;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 light = texelFetch(light_sums, at, 0);
  vec4 place = texelFetch(place_sums, at, 0);
  packed_source = place.w > 0.0 ? Pack(Source(light.rgb, light.a, place.xyz / place.w)) : uvec4(0u);
}
)";

constexpr std::string_view kLevelBody = R"(
layout(location = 0) out uvec4 packed_source;
layout(location = 0) uniform int level;   // that is written
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy) - ivec2(0, LevelTop(level));
  ivec2 from = 2 * at + ivec2(0, LevelTop(level - 1));
  vec3 light = vec3(0.0), place = vec3(0.0);
  float area = 0.0, weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    Source s = Unpack(texelFetch(sources, from + ivec2(i & 1, i >> 1), 0));
    float weight = s.light.r + s.light.g + s.light.b + 1e-6 * s.area;
    light += s.light;
    area += s.area;
    place += weight * s.place;
    weights += weight;
  }
  packed_source = weights > 0.0 ? Pack(Source(0.25 * light, 0.25 * area, place / weights)) : uvec4(0u);
}
)";

// Dipole::Reflectance over a piece of surface of that area instead of a point: plus area / 24 times the Laplacian of
// R_d (a square's second moments). Both come from a table (dipole_table.h): on a software rasterizer two fetches cost a
// third of two poles' roots and exponentials.
constexpr std::string_view kGather = R"(
layout(binding = DIPOLE_UNIT) uniform sampler2D dipole_table;
const float MOST_SPREAD = 0.6;   // of area / s^2, up to which the series holds

float inverse_least2 = 1.0;      // of the shortest mean free path

vec3 Dipole(float d2, float area) {
  float relative = clamp(d2 * inverse_least2, FIRST_SQUARE, LAST_SQUARE);
  int i = int((floatBitsToUint(relative) - floatBitsToUint(FIRST_SQUARE)) >> STEP_SHIFT);
  ivec2 at = ivec2(i & (PER_OCTAVE - 1), i >> OCTAVE_SHIFT);
  vec3 flat_part = texelFetch(dipole_table, at, 0).rgb;
  vec3 bent_part = texelFetch(dipole_table, at + ivec2(0, OCTAVES), 0).rgb;
  vec3 spread = min(vec3(area), MOST_SPREAD * (d2 + real_mm.rgb * real_mm.rgb));
  return max(flat_part + spread * bent_part, vec3(0.0));
}

struct Sum { vec3 all; vec3 near; };

// `cell`: a texel's area, mm^2.
void AddTap(inout Sum sum, Source s, vec3 unit, float cell) {
  vec3 d = (s.place - unit) * box_mm.xyz;
  float d2 = dot(d, d);
  float area = s.area * cell;
  vec3 b = s.light * cell * Dipole(d2, area);
  sum.all += b;
#if PARTS
  sum.near += b * exp2(-1.442695 * d2 / (real_mm.rgb * real_mm.rgb));
#endif
}

bool IsInside(ivec2 p, ivec2 begin, ivec2 end) {
  return all(greaterThanEqual(p, begin)) && all(lessThan(p, end));
}

// The first texel from p on, row after row of a window, that is not among its inner ones.
ivec2 SkipInner(ivec2 p, ivec2 first, ivec2 last, ivec2 inner, ivec2 inner_end) {
  if (inner.x == first.x && inner_end.x == last.x && p.y == inner.y) p.y = inner_end.y;   // whole rows
  if (IsInside(p, inner, inner_end)) p.x = inner_end.x;
  if (p.x >= last.x) p = ivec2(first.x, p.y + 1);
  return IsInside(p, inner, inner_end) ? ivec2(inner_end.x, p.y) : p;
}

ivec2 Next(ivec2 p, ivec2 first, ivec2 last) { return p.x + 1 < last.x ? ivec2(p.x + 1, p.y) : ivec2(first.x, p.y + 1); }

bool IsEmpty(ivec2 origin, int whole) {
  uvec4 t = texelFetch(sources, (origin >> whole) + ivec2(0, LevelTop(whole)), 0);
  return (t.z | t.w) == 0u;
}

// `is_asked`: false takes next to no time. Loops' counts are all that a software rasterizer, which runs both sides of
// every branch, can save.
Sum Gather(vec3 unit, int own_face, bool is_asked) {
  Sum sum = Sum(vec3(0.0), vec3(0.0));
  float shortest = min(real_mm.r, min(real_mm.g, real_mm.b));
  inverse_least2 = 1.0 / (shortest * shortest);
  int base = box_levels.x, top = box_levels.y;
  int tiles = 6;
  for (int face = 0; face < 6; ++face) tiles = IsEmpty(ivec2(face, 1) * box_texels.w, top + WHOLE_ABOVE_TOP) ? tiles : 12;
  for (int tile = is_asked ? 0 : tiles; tile < tiles; ++tile) {
    int face = tile >= 6 ? tile - 6 : tile;
    int axis = face >> 1;
    vec2 counts = vec2(FaceAxes(box_texels.xyz, axis).xy);
    vec2 texel_mm = FaceAxes(box_mm.xyz, axis).xy / counts;
    float cell_mm2 = texel_mm.x * texel_mm.y;
    float side_mm = max(texel_mm.x, texel_mm.y);
    vec2 at_base = FaceAxes(unit, axis).xy * counts;
    ivec2 origin = ivec2(face, tile >= 6 ? 1 : 0) * box_texels.w;

    ivec2 first = ivec2(0);
    ivec2 last = (ivec2(counts) + (1 << top) - 1) >> top;
    int k = IsEmpty(origin, top + WHOLE_ABOVE_TOP) ? base - 1 : top;
    while (k >= base) {
      ivec2 level = (origin >> k) + ivec2(0, LevelTop(k));
      ivec2 middle = ivec2(round(at_base / float(1 << k) - 0.5 * float(WINDOW)));
      ivec2 inner = clamp(middle, first, max(first, last - WINDOW));
      ivec2 inner_end = k == base ? inner : min(inner + WINDOW, last);
      float reach = NEARNESS * side_mm * float(1 << k);
      bool is_near = false;
      int inner_count = (inner_end.x - inner.x) * (inner_end.y - inner.y);
      ivec2 p = inner;
      for (int i = 0; i < inner_count; ++i) {
        uvec4 t = texelFetch(sources, level + p, 0);
        vec3 d = (Unpack(t).place - unit) * box_mm.xyz;
        is_near = is_near || ((t.z | t.w) != 0u && dot(d, d) < reach * reach);
        p = Next(p, inner, inner_end);
      }
      if (!is_near) inner_end = inner;
      int count = (last.x - first.x) * (last.y - first.y) - (inner_end.x - inner.x) * (inner_end.y - inner.y);
      p = first;
      for (int i = 0; i < count; ++i) {
        p = SkipInner(p, first, last, inner, inner_end);
        AddTap(sum, Unpack(texelFetch(sources, level + p, 0)), unit, cell_mm2 * float(1 << (2 * k)));
        p = Next(p, first, last);
      }
      first = 2 * inner;
      last = 2 * inner_end;
      k = is_near ? k - 1 : base - 1;
    }
  }
  sum.all *= virtual_mm.w;
  sum.near *= virtual_mm.w;
  return sum;
}
)";

// A receiver stands for a block of texels. In the first row it lies amid those that are near the nearest of them, in
// the second, of what they hide, amid the sources there.
constexpr std::string_view kReceiverBody = R"(
layout(location = 0) out vec4 out_all;     // a: depth, above 1 where there is no surface
#if PARTS
layout(location = 1) out vec4 out_near;
#endif

vec4 FirstRow(ivec2 block, int face, vec2 texels, int shift) {
  ivec2 first = (block << shift) + ivec2(face * box_texels.w, 0);
  int side = 1 << shift;
  float nearest = 1.0;
  for (int i = 0; i < side * side; ++i) {
    nearest = min(nearest, texelFetch(face_depth, first + ivec2(i & (side - 1), i >> shift), 0).r);
  }
  float slack = 3.0 * float(side) / min(texels.x, texels.y);
  vec3 sum = vec3(0.0);
  float count = 0.0;
  for (int i = 0; i < side * side; ++i) {
    ivec2 o = ivec2(i & (side - 1), i >> shift);
    float depth = texelFetch(face_depth, first + o, 0).r;
    bool counts = depth < 1.0 && depth <= nearest + slack;
    sum += counts ? vec3((vec2((block << shift) + o) + 0.5) / texels, depth) : vec3(0.0);
    count += counts ? 1.0 : 0.0;
  }
  return vec4(sum / max(count, 1.0), count);
}

void main() {
  int shift = box_levels.z;
  int side = box_texels.w >> shift;
  ivec2 at = ivec2(gl_FragCoord.xy);
  int face = at.x / side;
  bool is_hidden = at.y >= side;
  ivec2 block = at - ivec2(face * side, is_hidden ? side : 0);
  int axis = face >> 1;
  vec4 place = FirstRow(block, face, FaceAxes(vec3(box_texels.xyz), axis).xy, shift);
  if ((face & 1) == 0) place.z = 1.0 - place.z;
  if (is_hidden) {
    Source s = Unpack(texelFetch(sources, at + ivec2(0, LevelTop(shift)), 0));
    place = vec4(FaceAxes(s.place, axis), s.area);
  }
  bool is_surface = place.w > 0.0;
  Sum sum = Gather(FromFaceAxes(place.xyz, axis), face, is_surface);
  out_all = vec4(sum.all, is_surface ? ((face & 1) == 0 ? 1.0 - place.z : place.z) : 2.0);
#if PARTS
  out_near = vec4(sum.near, 0.0);
#endif
}
)";

// Four receivers on each of the three faces that the surface looks towards, first of what the faces see, then, where
// none of those fits, of what that hides. One counts if it lies on the surface's tangent plane; a face counts the more,
// the more squarely it is looked at, and not at all where triangles are no longer drawn on it. What lies off the plane
// counts next to nothing, so that it matters only where nothing else is. Where there is nothing at all (hairs thinner
// than a texel) the light that enters thereabouts comes out as from a plane.
constexpr std::string_view kLookUp = R"(
layout(binding = ALL_UNIT) uniform sampler2D receivers_all;
#if PARTS
layout(binding = NEAR_UNIT) uniform sampler2D receivers_near;
#endif
const float TOLERANCE = 1.5;   // receivers' sizes
const float ENOUGH = 0.1;      // of the weights' possible sum
const float ROUGH = 1e-3;      // weight of what is off the plane

void AddFace(vec3 unit, vec3 g, float most, int axis, int row, inout vec3 all, inout vec3 near, inout float weights) {
  vec3 n = FaceAxes(g, axis);
  float squareness = max(abs(n.z) - REACH * most, 0.0);
  squareness *= squareness;
  bool is_positive = n.z > 0.0;
  int face = 2 * axis + (is_positive ? 0 : 1);
  int side = box_texels.w >> box_levels.z;
  vec3 r = FaceAxes(unit, axis);
  vec3 size_mm = FaceAxes(box_mm.xyz, axis);
  ivec2 counts = FaceAxes(box_texels.xyz, axis).xy >> box_levels.z;
  vec2 side_mm = size_mm.xy / vec2(counts);
  vec2 at = r.xy * vec2(counts) - 0.5;
  ivec2 corner = ivec2(floor(at));
  vec2 f = at - vec2(corner);
  float depth_mm = (is_positive ? 1.0 - r.z : r.z) * size_mm.z;
  vec2 slope = n.xy / max(abs(n.z), 0.1) * side_mm;
  float inverse_tolerance = 1.0 / (TOLERANCE * max(side_mm.x, side_mm.y));
  for (int i = 0; i < 4; ++i) {
    ivec2 o = ivec2(i & 1, i >> 1);
    ivec2 c = corner + o;
    bool is_on_face = c.x >= 0 && c.y >= 0 && c.x < counts.x && c.y < counts.y;
    c = clamp(c, ivec2(0), counts - 1) + ivec2(face, row) * side;
    vec4 receiver = texelFetch(receivers_all, c, 0);
    float miss = (receiver.a * size_mm.z - depth_mm - dot(slope, vec2(o) - f)) * inverse_tolerance;
    float w = (o.x == 1 ? f.x : 1.0 - f.x) * (o.y == 1 ? f.y : 1.0 - f.y);
    float far = 1.0 + miss * miss;
    w = w * squareness * max(1.0 - miss * miss, 0.0) + ROUGH * (w + 0.01) * (squareness + 0.01 * most * most) / (far * far);
    if (!is_on_face || receiver.a > 1.0) w = 0.0;
    weights += w;
    all += w * receiver.rgb;
#if PARTS
    near += w * texelFetch(receivers_near, c, 0).rgb;
#endif
  }
}

// Irradiance on the surfaces about a point of the face that it looks towards, from the finest level that has any.
vec3 LightAbout(vec3 unit, vec3 g, bool is_asked) {
  vec3 m = abs(g);
  int axis = m.x >= max(m.y, m.z) ? 0 : m.y >= m.z ? 1 : 2;
  vec3 n = FaceAxes(g, axis);
  int face = 2 * axis + (n.z > 0.0 ? 0 : 1);
  ivec2 texel = clamp(ivec2(FaceAxes(unit, axis).xy * vec2(FaceAxes(box_texels.xyz, axis).xy)), ivec2(0), ivec2(box_texels.w - 1));
  vec3 light = vec3(0.0);
  int end = is_asked ? box_levels.y + WHOLE_ABOVE_TOP : 0;
  for (int k = 1; k <= end; ++k) {
    Source s = Unpack(texelFetch(sources, ((texel + ivec2(face * box_texels.w, 0)) >> k) + ivec2(0, LevelTop(k)), 0));
    light = s.light * (virtual_mm.w / max(s.area, 1e-6));
    if (s.area > 0.0) break;
  }
  return light;
}

void Radiosity(vec3 world, vec3 g, out vec3 all, out vec3 near) {
  vec3 unit = UnitOf(world);
  vec3 m = abs(g);
  float most = max(m.x, max(m.y, m.z));
  float possible = (1.0 - REACH) * most * (1.0 - REACH) * most;
  float weights = 0.0;
  all = near = vec3(0.0);
  int rows = 2;
  for (int row = 0; row < rows; ++row) {
    for (int axis = 0; axis < 3; ++axis) AddFace(unit, g, most, axis, row, all, near, weights);
    if (weights > ENOUGH * possible || gl_HelperInvocation) rows = 1;
  }
  bool is_alone = !(weights > 0.0) && !gl_HelperInvocation;
  vec3 about = LightAbout(unit, g, is_alone) * body_reflectance.rgb;
  all = is_alone ? about : all / max(weights, 1e-30);
  near = is_alone ? about : near / max(weights, 1e-30);
}
)";

std::string Replaced(std::string_view text, std::string_view what, std::string_view with) {
  std::string result(text);
  for (std::size_t at = result.find(what); at != std::string::npos; at = result.find(what, at + with.size())) {
    result.replace(at, what.size(), with);
  }
  return result;
}

std::string SourcesDeclaration() {
  return fmt::format("layout(binding = {}) uniform usampler2D sources;\n", static_cast<unsigned>(kSourceUnit));
}

std::string Begin() {
  return "#version 450 core\n" + BodyDeclarations() + SourcesDeclaration() + std::string(kPacking);
}

std::string GatherFunctions(const Quality& quality) {
  constexpr int kOctaveShift = 8;
  static_assert(DipoleTable::kPerOctave == 1 << kOctaveShift);
  constexpr int kMantissa = 23;
  std::string text = fmt::format(
      "const int WINDOW = {};\nconst float NEARNESS = {:.3f};\nconst int WHOLE_ABOVE_TOP = {};\n"
      "const float FIRST_SQUARE = {};\nconst float LAST_SQUARE = {};\nconst int PER_OCTAVE = {};\n"
      "const int OCTAVE_SHIFT = {};\nconst int STEP_SHIFT = {};\nconst int OCTAVES = {};\n",
      quality.window, quality.nearness, kWholeAboveTop, std::ldexp(1.0, DipoleTable::kFirstExponent),
      std::ldexp(1.999, DipoleTable::kFirstExponent + DipoleTable::kOctaves - 1), DipoleTable::kPerOctave, kOctaveShift,
      kMantissa - kOctaveShift, DipoleTable::kOctaves);
  return text + Replaced(kGather, "DIPOLE_UNIT", fmt::format("{}", static_cast<unsigned>(kDipoleUnit)));
}

}  // namespace

std::string PyramidBaseFragmentText() { return Begin() + std::string(kBaseBody); }
std::string PyramidLevelFragmentText() { return Begin() + std::string(kLevelBody); }

std::string ReceiverFragmentText(const Quality& quality, bool has_parts) {
  return Begin() +
         fmt::format("#define PARTS {}\nlayout(binding = {}) uniform sampler2D face_depth;\n", has_parts ? 1 : 0,
                     static_cast<unsigned>(kFaceDepthUnit)) +
         (quality.kernel > 0 ? PaperGatherFunctions(quality.kernel) : GatherFunctions(quality)) +
         std::string(kReceiverBody);
}

std::string LookUpFunctions() {
  std::string look_up = Replaced(kLookUp, "ALL_UNIT", fmt::format("{}", static_cast<unsigned>(kReceiverUnit)));
  look_up = Replaced(look_up, "NEAR_UNIT", fmt::format("{}", static_cast<unsigned>(kLocalUnit)));
  return SourcesDeclaration() + std::string(kPacking) +
         fmt::format("const int WHOLE_ABOVE_TOP = {};\nconst float REACH = {:.4f};\n", kWholeAboveTop, kFaceReach) +
         look_up;
}

std::string CoveringVertexText() {
  return "#version 450 core\n"
         "void main() { gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0); }\n";
}

}  // namespace burin::translucency
