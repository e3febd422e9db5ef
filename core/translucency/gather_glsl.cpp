// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/gather_glsl.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "core/translucency/body_block.h"
#include "core/translucency/dipole_table.h"

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

// A texel of the lowest level that is read, of 1 or 2 x 2 texels of sums.
constexpr std::string_view kBaseBody = R"(
layout(binding = 0) uniform sampler2D light_sums;
layout(binding = 1) uniform sampler2D place_sums;
layout(location = 0) out uvec4 packed_source;
void main() {
  ivec2 from = (ivec2(gl_FragCoord.xy) - ivec2(0, LevelTop(LEVEL))) << LEVEL;
  vec4 light = vec4(0.0), place = vec4(0.0);
  for (int i = 0; i < 1 << (2 * LEVEL); ++i) {
    ivec2 at = from + ivec2(i & 1, i >> 1);
    light += texelFetch(light_sums, at, 0);
    place += texelFetch(place_sums, at, 0);
  }
  const float share = 1.0 / float(1 << (2 * LEVEL));
  packed_source = place.w > 0.0 ? Pack(Source(share * light.rgb, share * light.a, place.xyz / place.w)) : uvec4(0u);
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
// R_d (a square's second moments). Both come from a table (dipole_table.h): on a software rasterizer a fetch costs a
// sixth of two poles' roots and exponentials.
constexpr std::string_view kGather = R"(
layout(binding = DIPOLE_UNIT) uniform usampler2D dipole_table;
const float MOST_SPREAD = 0.6;   // of area / s^2, up to which the series holds

float inverse_least2 = 1.0;      // of the shortest mean free path

vec3 Dipole(float d2, float area) {
  float relative = clamp(d2 * inverse_least2, FIRST_SQUARE, LAST_SQUARE);
  int i = int((floatBitsToUint(relative) - floatBitsToUint(FIRST_SQUARE)) >> STEP_SHIFT);
  ivec2 at = ivec2(i & (PER_OCTAVE - 1), i >> OCTAVE_SHIFT);
  uvec3 both = texelFetch(dipole_table, at, 0).rgb;
  vec3 flat_part = uintBitsToFloat((both & 0xffff0000u) >> 1);
  vec3 bent_part = uintBitsToFloat(both << 16);
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

std::string Begin() { return "#version 450 core\n" + BodyDeclarations() + PyramidFunctions(); }

}  // namespace

std::string PyramidFunctions() {
  return fmt::format("layout(binding = {}) uniform usampler2D sources;\nconst int WHOLE_ABOVE_TOP = {};\n",
                     static_cast<unsigned>(kSourceUnit), kWholeAboveTop) +
         std::string(kPacking);
}

std::string GatherFunctions(const Quality& quality) {
  constexpr int kOctaveShift = 8;
  static_assert(DipoleTable::kPerOctave == 1 << kOctaveShift);
  constexpr int kMantissa = 23;
  const std::string constants = fmt::format(
      "#define DIPOLE_UNIT {}\nconst int WINDOW = {};\nconst float NEARNESS = {:.3f};\n"
      "const float FIRST_SQUARE = {};\nconst float LAST_SQUARE = {};\nconst int PER_OCTAVE = {};\n"
      "const int OCTAVE_SHIFT = {};\nconst int STEP_SHIFT = {};\n",
      static_cast<unsigned>(kDipoleUnit), quality.window, quality.nearness,
      std::ldexp(1.0, DipoleTable::kFirstExponent),
      std::ldexp(1.999, DipoleTable::kFirstExponent + DipoleTable::kOctaves - 1), DipoleTable::kPerOctave, kOctaveShift,
      kMantissa - kOctaveShift);
  return constants + std::string(kGather);
}

std::string PyramidBaseFragmentText(int level) {
  return Begin() + fmt::format("const int LEVEL = {};\n", level) + std::string(kBaseBody);
}

std::string PyramidLevelFragmentText() { return Begin() + std::string(kLevelBody); }

std::string CoveringVertexText() {
  return "#version 450 core\n"
         "void main() { gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0); }\n";
}

}  // namespace burin::translucency
