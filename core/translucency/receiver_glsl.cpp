// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/receiver_glsl.h"

#include <fmt/format.h>

#include <string_view>

#include "core/translucency/body_block.h"
#include "core/translucency/face_glsl.h"
#include "core/translucency/gather_glsl.h"
#include "core/translucency/paper_glsl.h"

namespace burin::translucency {
namespace {

constexpr std::string_view kLayout = R"(
ivec2 ReceiverTexel(ivec2 block, int face, int row) { return block + (box_texels.w >> box_levels.z) * ivec2(face, row); }
)";

// Groups that are to be dispatched, and what they gather: a block's place and its face and row, as one number.
constexpr std::string_view kOutputs = R"(
layout(local_size_x = GROUP) in;
layout(rgba32f, binding = 0) writeonly uniform image2D out_all;   // a: depth, above 1 where there is no surface
#if PARTS
layout(rgba32f, binding = 1) writeonly uniform image2D out_near;
#endif
layout(std430, binding = WANTED_BINDING) buffer Wanted {
  uint groups_x, groups_y, groups_z;
  uint wanted_count;
  uint wanted[];
};

void Write(ivec2 block, int face, int row, vec3 all, vec3 near, float depth) {
  ivec2 texel = ReceiverTexel(block, face, row);
  imageStore(out_all, texel, vec4(all, depth));
#if PARTS
  imageStore(out_near, texel, vec4(near, 0.0));
#endif
}
)";

// A receiver stands for a block of texels, amid those that are near the nearest of them; in the second row amid those
// that are near the deepest of them, where that is hidden. What lies between them has none.
constexpr std::string_view kPlace = R"(
// w: 0 where there is no surface. z: depth, in the second row from behind.
vec4 Amid(ivec2 block, int face, int row) {
  int shift = box_levels.z;
  vec2 texels = FaceAxes(vec3(box_texels.xyz), face >> 1).xy;
  ivec2 first = (block << shift) + ivec2(face * box_texels.w, 0);
  int side = 1 << shift;
  float least = 1.0;
  for (int i = 0; i < side * side; ++i) least = min(least, Depth(first + ivec2(i & (side - 1), i >> shift), row));
  float slack = 3.0 * float(side) / min(texels.x, texels.y);
  vec3 sum = vec3(0.0);
  float count = 0.0;
  for (int i = 0; i < side * side; ++i) {
    ivec2 o = ivec2(i & (side - 1), i >> shift);
    float depth = Depth(first + o, row);
    bool counts = depth < 1.0 && depth <= least + slack;
    sum += counts ? vec3((vec2((block << shift) + o) + 0.5) / texels, depth) : vec3(0.0);
    count += counts ? 1.0 : 0.0;
  }
  return vec4(sum / max(count, 1.0), count);
}

// In the face's axes, as a share of the box; z: depth from the face.
vec4 Place(ivec2 block, int face, int row) {
  vec4 place = Amid(block, face, row);
  if (row == 1) place.z = 1.0 - place.z;
  return place;
}
)";

// What is visible and what is deepest are one surface, or two.
constexpr std::string_view kDepth = R"(
layout(binding = FACE_DEPTH_UNIT) uniform sampler2D face_depth;
#if IS_PAPER
float Depth(ivec2 texel, int row) { return row == 0 ? texelFetch(face_depth, texel, 0).r : 1.0; }
#else
layout(binding = FACE_DEEPEST_UNIT) uniform sampler2D face_deepest;
const float APART = 1e-3;   // of the box
float Depth(ivec2 texel, int row) {
  float nearest = texelFetch(face_depth, texel, 0).r;
  float deepest = texelFetch(face_deepest, texel, 0).r;
  return row == 0 ? nearest : deepest > nearest + APART ? 1.0 - deepest : 1.0;
}
#endif
)";

// A receiver amid others takes their light where that changes evenly: along two lines across it, of two receivers on
// each side, a cubic goes through the four; where it leaves the straight line by little, what the cubic misses is less
// still. A line that ends nearby is continued as it bends on the other side; one line does where the other has none.
constexpr std::string_view kGuess = R"(
layout(binding = ALL_UNIT) uniform sampler2D receivers_all;
#if PARTS
layout(binding = NEAR_UNIT) uniform sampler2D receivers_near;
#endif
const float EVEN = 0.03;      // of the light: most that a line's middle may lie beside its chord
const float DARK = 0.1;       // channels darker than this share of the brightest are judged by that
const float FLAT = 0.25;      // receivers' sizes: most that the surface may lie beside the guess
const float CENTRED = 0.125;  // receivers' sizes

struct Line { vec4 chord; vec4 bend; vec3 near; bool is_good; };

Line LineThrough(ivec2 block, ivec2 step, int face, int row, ivec2 counts) {
  vec4 f[4];
  vec3 near[4];
  bool is_there[4];
  for (int i = 0; i < 4; ++i) {
    ivec2 c = block + (2 * i - 3) * step;
    ivec2 inside = clamp(c, ivec2(0), counts - 1);
    ivec2 texel = ReceiverTexel(inside, face, row);
    f[i] = texelFetch(receivers_all, texel, 0);
    is_there[i] = c == inside && f[i].a <= 1.0;
#if PARTS
    near[i] = texelFetch(receivers_near, texel, 0).rgb;
#else
    near[i] = vec3(0.0);
#endif
  }
  vec4 before = f[0] - 2.0 * f[1] + f[2];
  vec4 after = f[1] - 2.0 * f[2] + f[3];
  vec3 near_before = near[0] - 2.0 * near[1] + near[2];
  vec3 near_after = near[1] - 2.0 * near[2] + near[3];
  float w = is_there[0] ? (is_there[3] ? 0.5 : 1.0) : 0.0;
  Line line;
  line.chord = 0.5 * (f[1] + f[2]);
  line.bend = 0.125 * mix(after, before, w);
  line.near = 0.5 * (near[1] + near[2]) - 0.125 * mix(near_after, near_before, w);
  line.is_good = is_there[1] && is_there[2] && (is_there[0] || is_there[3]);
  return line;
}

bool Guess(ivec2 block, int face, int row, vec3 place, int step, bool is_cross, out vec3 light, out vec3 near) {
  int axis = face >> 1;
  ivec2 counts = FaceAxes(box_texels.xyz, axis).xy >> box_levels.z;
  Line u = LineThrough(block, step * (is_cross ? ivec2(1, 1) : ivec2(1, 0)), face, row, counts);
  Line v = LineThrough(block, step * (is_cross ? ivec2(1, -1) : ivec2(0, 1)), face, row, counts);
  if (!u.is_good) u = v;
  if (!v.is_good) v = u;
  vec4 guess_u = u.chord - u.bend;
  vec4 guess_v = v.chord - v.bend;
  vec4 guess = 0.5 * (guess_u + guess_v);
  light = max(guess.rgb, vec3(0.0));
  near = max(0.5 * (u.near + v.near), vec3(0.0));
  vec3 most = EVEN * max(guess.rgb, vec3(DARK * max(guess.r, max(guess.g, guess.b))));
  vec3 uneven = max(max(abs(u.bend.rgb), abs(v.bend.rgb)), abs(guess_u.rgb - guess_v.rgb));
  vec3 size_mm = FaceAxes(box_mm.xyz, axis);
  float side_mm = max(size_mm.x / float(counts.x), size_mm.y / float(counts.y));
  vec2 off_centre = abs(place.xy * vec2(counts) - (vec2(block) + 0.5));
  return u.is_good && all(lessThanEqual(uneven, most)) &&
         abs(guess.a - place.z) * size_mm.z <= FLAT * side_mm && max(off_centre.x, off_centre.y) <= CENTRED;
}
)";

// Of one lattice on every face: writes what is empty or can be guessed, and asks for the rest. Eight neighbours in a
// vector are a block of 4 x 2.
constexpr std::string_view kChoiceBody = R"(
layout(location = 0) uniform ivec4 lattice;   // offset, spacing, distance to the receivers around; 0: there are none

void main() {
  int i = int(gl_LocalInvocationID.x);
  ivec2 at = ivec2((i & 3) | ((i >> 1) & 4), ((i >> 2) & 1) | ((i >> 3) & 6));
  int groups_across = (box_texels.w >> box_levels.z) / (8 * lattice.z);
  int group = int(gl_WorkGroupID.x);
  at += 8 * ivec2(group % groups_across, group / groups_across);
  ivec2 block = lattice.xy + lattice.z * at;
  int tile = int(gl_WorkGroupID.y);
  int face = tile % 6;
  int row = tile / 6;
  vec4 place = Place(block, face, row);
  if (!(place.w > 0.0)) {
    Write(block, face, row, vec3(0.0), vec3(0.0), 2.0);
    return;
  }
#if GUESSES
  vec3 all, near;
  if (lattice.w > 0 && Guess(block, face, row, place.xyz, lattice.w, lattice.x == lattice.y, all, near)) {
    Write(block, face, row, all, near, place.z);
    return;
  }
#endif
  uint slot = atomicAdd(wanted_count, 1u);
  atomicMax(groups_x, slot / GROUP + 1u);
  wanted[slot] = uint(block.x) | uint(block.y) << 12 | uint(tile) << 24;
}
)";

constexpr std::string_view kReceiverBody = R"(
void main() {
  uint i = gl_GlobalInvocationID.x;
  bool is_asked = i < wanted_count;
  uint word = wanted[is_asked ? i : 0u];
  ivec2 block = ivec2(word & 0xfffu, (word >> 12) & 0xfffu);
  int tile = int(word >> 24);
  int face = tile % 6;
  int row = tile / 6;
  vec4 place = Place(block, face, row);
  vec3 unit = vec3(place.xy, (face & 1) == 0 ? 1.0 - place.z : place.z);
  Sum sum = Gather(FromFaceAxes(unit, face >> 1), face, is_asked);
  if (is_asked) Write(block, face, row, sum.all, sum.near, place.z);
}
)";

// Four receivers on each of the faces that the surface looks towards nearly as squarely as towards any; where none of
// those fits, on all three that it looks towards, first of what they see, then of what that hides. One counts if it
// lies on the surface's tangent plane; a face counts the more, the more squarely it is looked at, and not at all where
// triangles are no longer drawn on it. What lies off the plane counts next to nothing, so that it matters only where
// nothing else is. Where there is nothing at all (hairs thinner than a texel) the light that enters thereabouts comes
// out as from a plane.
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
    c = ReceiverTexel(clamp(c, ivec2(0), counts - 1), face, row);
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

// The three axes, from the one that the surface looks along most squarely on.
ivec3 AxesInOrder(vec3 m) {
  ivec3 axes = m.x >= m.y ? ivec3(0, 1, 2) : ivec3(1, 0, 2);
  if (m.z > max(m.x, m.y)) return ivec3(2, axes.xy);
  return m.z > min(m.x, m.y) ? axes.xzy : axes;
}

void Radiosity(vec3 world, vec3 g, out vec3 all, out vec3 near) {
  vec3 unit = UnitOf(world);
  vec3 m = abs(g);
  ivec3 axes = AxesInOrder(m);
  float most = m[axes.x];
  float possible = (1.0 - REACH) * most * (1.0 - REACH) * most;
  int squares = 1 + int(m[axes.y] > REACH * most) + int(m[axes.z] > REACH * most);
  float weights = 0.0;
  all = near = vec3(0.0);
  int steps = 6;
  for (int step = 0; step < steps; ++step) {
    AddFace(unit, g, most, axes[step % 3], step / 3, all, near, weights);
    bool is_whole = step + 1 == squares || step == 2 || step + 1 == 3 + squares;
    bool is_enough = is_whole && (weights > ENOUGH * possible || gl_HelperInvocation);
    steps = is_enough ? 0 : steps;
  }
  bool is_alone = !(weights > 0.0) && !gl_HelperInvocation;
  vec3 about = LightAbout(unit, g, is_alone) * body_reflectance.rgb;
  all = is_alone ? about : all / max(weights, 1e-30);
  near = is_alone ? about : near / max(weights, 1e-30);
}
)";

std::string Units() {
  return fmt::format("#define ALL_UNIT {}\n#define NEAR_UNIT {}\n", static_cast<unsigned>(kReceiverUnit),
                     static_cast<unsigned>(kLocalUnit));
}

std::string Begin(const Quality& quality, bool has_parts) {
  return "#version 450 core\n" + BodyDeclarations() + PyramidFunctions() +
         fmt::format(
             "#define PARTS {}\n#define GROUP {}u\n#define WANTED_BINDING {}\n#define IS_PAPER {}\n"
             "#define FACE_DEPTH_UNIT {}\n#define FACE_DEEPEST_UNIT {}\n",
             has_parts ? 1 : 0, kReceiverGroup, static_cast<unsigned>(kWantedBinding), quality.is_paper() ? 1 : 0,
             static_cast<unsigned>(kFaceDepthUnit), static_cast<unsigned>(kFaceDeepestUnit)) +
         std::string(kLayout) + std::string(kOutputs) + std::string(kDepth) + std::string(kPlace);
}

}  // namespace

std::string ReceiverChoiceText(const Quality& quality, bool has_parts) {
  const bool guesses = quality.lattice > 1;
  return Begin(quality, has_parts) + fmt::format("#define GUESSES {}\n", guesses ? 1 : 0) + Units() +
         std::string(guesses ? kGuess : std::string_view()) + std::string(kChoiceBody);
}

std::string ReceiverText(const Quality& quality, bool has_parts) {
  return Begin(quality, has_parts) +
         (quality.is_paper() ? PaperGatherFunctions(quality.kernel) : GatherFunctions(quality)) +
         std::string(kReceiverBody);
}

std::string LookUpFunctions() {
  return PyramidFunctions() + fmt::format("const float REACH = {:.4f};\n", kFaceReach) + std::string(kLayout) +
         Units() + std::string(kLookUp);
}

}  // namespace burin::translucency
