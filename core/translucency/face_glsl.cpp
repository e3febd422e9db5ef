// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/face_glsl.h"

#include <fmt/format.h>

#include <string_view>

#include "core/gbuffer/geometry_shader.h"
#include "core/gbuffer/gpu_blocks.h"
#include "core/translucency/body_block.h"
#include "core/translucency/irradiance_glsl.h"

namespace burin::translucency {
namespace {

constexpr std::string_view kDepthVertex = R"(
layout(location = 0) in vec3 in_position;
layout(location = 0) out vec3 v_unit;
void main() {
  v_unit = UnitOf((world_from_object * vec4(in_position, 1.0)).xyz);
}
)";

// Counter-clockwise from outside, in millimetres; mirrored objects turned back.
constexpr std::string_view kTriangle = R"(
layout(triangles) in;
invariant gl_Position;
const float SNAP = 1.0 / 64.0;   // texels: what the rasterizer may move a corner by, and more
vec3 NormalOf(vec3 a, vec3 b, vec3 c) { return cross((b - a) * box_mm.xyz, (c - a) * box_mm.xyz) * normal_columns[0].w; }
vec4 FaceClip(vec3 unit, int axis, bool is_positive) {
  vec3 r = FaceAxes(unit, axis);
  return vec4(2.0 * r.x - 1.0, 1.0 - 2.0 * r.y, is_positive ? 1.0 - r.z : r.z, 1.0);
}
// Texels: least and most of the triangle's corners on an axis' faces.
vec4 Extent(vec3 a, vec3 b, vec3 c, int axis) {
  vec2 texels = vec2(FaceAxes(box_texels.xyz, axis).xy);
  vec2 p = FaceAxes(a, axis).xy, q = FaceAxes(b, axis).xy, r = FaceAxes(c, axis).xy;
  return vec4(min(p, min(q, r)) * texels, max(p, max(q, r)) * texels);
}
// Whether a texel's centre lies within: a dense mesh has more triangles than its faces have texels.
bool MayShow(vec4 extent) { return all(lessThanEqual(ceil(extent.xy - (0.5 + SNAP)), floor(extent.zw - (0.5 - SNAP)))); }
)";

constexpr std::string_view kDepthBody = R"(
layout(triangle_strip, max_vertices = 9) out;
layout(location = 0) in vec3 v_unit[];
void main() {
  vec3 n = NormalOf(v_unit[0], v_unit[1], v_unit[2]);
  vec3 m = abs(n);
  float least = REACH * max(m.x, max(m.y, m.z));
  if (!(least > 0.0)) return;
  for (int axis = 0; axis < 3; ++axis) {
    if (m[axis] < least || !MayShow(Extent(v_unit[0], v_unit[1], v_unit[2], axis))) continue;
    bool is_positive = n[axis] > 0.0;
    for (int i = 0; i < 3; ++i) {
      gl_ViewportIndex = 2 * axis + (is_positive ? 0 : 1);
      gl_Position = FaceClip(v_unit[i], axis, is_positive);
      EmitVertex();
    }
    EndPrimitive();
  }
}
)";

constexpr std::string_view kSourceVertex = R"(
layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 4) in vec4 in_color;
layout(location = 8) in vec2 in_texcoord0;
layout(location = 9) in vec2 in_texcoord1;
layout(location = 0) out vec3 g_position;
layout(location = 1) out vec3 g_normal;
layout(location = 2) out vec4 g_tangent;
layout(location = 3) out vec4 g_color;
layout(location = 4) out vec2 g_texcoord0;
layout(location = 5) out vec2 g_texcoord1;
layout(location = 6) out vec3 g_unit;
void main() {
  g_position = (world_from_object * vec4(in_position, 1.0)).xyz;
  g_unit = UnitOf(g_position);
  g_normal = mat3(normal_columns[0].xyz, normal_columns[1].xyz, normal_columns[2].xyz) * in_normal;
  g_tangent = vec4(mat3(world_from_object) * in_tangent.xyz, in_tangent.w * normal_columns[0].w);
  g_color = in_color;
  g_texcoord0 = in_texcoord0;
  g_texcoord1 = in_texcoord1;
}
)";

// How squarely a point with this normal looks towards each axis' face on its triangle's side, of those that the
// triangle is drawn on; and which share of its light is on each. Normals that turn from triangle to triangle make
// shares that do so too, or else what the samples of two faces miss and count twice along each edge would flicker.
// `plane`: the triangle's normal over its largest component.
constexpr std::string_view kShares = R"(
int Squarest(vec3 plane) {
  vec3 m = abs(plane);
  return m.x >= max(m.y, m.z) ? 0 : m.y >= m.z ? 1 : 2;
}
vec3 Squareness(vec3 normal, vec3 plane) {
  return max(normal * sign(plane), vec3(0.0)) * vec3(greaterThanEqual(abs(plane), vec3(REACH)));
}
float Share(vec3 normal, vec3 plane, int axis) {
  vec3 s = Squareness(normal, plane);
  float top = max(s.x, max(s.y, s.z));
  s = max(s - SHARING * top, vec3(0.0));
  s *= s;
  return top > 0.0 ? s[axis] / (s.x + s.y + s.z) : float(axis == Squarest(plane));
}
)";

// A triangle goes to the second row too where one of its corners lies behind what its face shows, or where it is so
// large that something may hide its middle alone; each fragment then keeps to one row.
constexpr std::string_view kSourceBody = R"(
layout(triangle_strip, max_vertices = 18) out;
layout(location = 0) in vec3 g_position[];
layout(location = 1) in vec3 g_normal[];
layout(location = 2) in vec4 g_tangent[];
layout(location = 3) in vec4 g_color[];
layout(location = 4) in vec2 g_texcoord0[];
layout(location = 5) in vec2 g_texcoord1[];
layout(location = 6) in vec3 g_unit[];
layout(location = 0) out vec3 v_position;
layout(location = 1) out vec3 v_normal;
layout(location = 2) out vec4 v_tangent;
layout(location = 3) out vec4 v_color;
layout(location = 4) out vec2 v_texcoord0;
layout(location = 5) out vec2 v_texcoord1;
layout(location = 8) flat out vec4 v_face;   // face, row, area of a texel's piece of surface in texel's areas, axis
layout(location = 9) flat out vec3 v_plane;
const float LARGE = 6.0;                     // texels

void EmitTriangle(int axis, int face, int row, float area, vec3 plane) {
  for (int i = 0; i < 3; ++i) {
    v_position = g_position[i];
    v_normal = g_normal[i];
    v_tangent = g_tangent[i];
    v_color = g_color[i];
    v_texcoord0 = g_texcoord0[i];
    v_texcoord1 = g_texcoord1[i];
    v_face = vec4(float(face), float(row), area, float(axis));
    v_plane = plane;
    gl_ViewportIndex = face + 6 * row;
    gl_Position = FaceClip(g_unit[i], axis, (face & 1) == 0);
    EmitVertex();
  }
  EndPrimitive();
}

// Share() is 0 at all of a triangle if another axis has it all at every corner, and then in between.
bool HasShare(int axis, vec3 plane) {
  if (abs(plane[axis]) < REACH) return false;
  if (IS_WHOLE == 1 || axis == Squarest(plane)) return true;
  vec3 first = Squareness(g_normal[0], plane), second = Squareness(g_normal[1], plane), third = Squareness(g_normal[2], plane);
  bvec3 all_others = lessThanEqual(vec3(first[axis]), SHARING * first);
  all_others = bvec3(uvec3(all_others) & uvec3(lessThanEqual(vec3(second[axis]), SHARING * second)));
  all_others = bvec3(uvec3(all_others) & uvec3(lessThanEqual(vec3(third[axis]), SHARING * third)));
  return !any(all_others);
}

bool MayHide(int axis, int face, vec4 extent) {
  vec3 texels = FaceAxes(vec3(box_texels.xyz), axis);
  float depth_slack = 1.0 / min(texels.x, texels.y);
  bool is_behind = false;
  for (int i = 0; i < 3; ++i) {
    vec3 r = FaceAxes(g_unit[i], axis);
    vec2 at = r.xy * texels.xy;
    float depth = (face & 1) == 0 ? 1.0 - r.z : r.z;
    ivec2 texel = clamp(ivec2(at), ivec2(0), ivec2(texels.xy) - 1) + ivec2(face * box_texels.w, 0);
    is_behind = is_behind || depth > texelFetch(face_depth, texel, 0).r + depth_slack;
  }
  return is_behind || max(extent.z - extent.x, extent.w - extent.y) > LARGE;
}

void main() {
  vec3 n = NormalOf(g_unit[0], g_unit[1], g_unit[2]);
  vec3 m = abs(n);
  float most = max(m.x, max(m.y, m.z));
  if (!(most > 0.0)) return;
  vec3 plane = n / most;
  for (int axis = 0; axis < 3; ++axis) {
    vec4 extent = Extent(g_unit[0], g_unit[1], g_unit[2], axis);
    if (!MayShow(extent) || !HasShare(axis, plane)) continue;
    int face = 2 * axis + (n[axis] > 0.0 ? 0 : 1);
    float area = length(n) / m[axis];
    EmitTriangle(axis, face, 0, area, plane);
    if (IS_WHOLE == 0 && MayHide(axis, face, extent)) EmitTriangle(axis, face, 1, area, plane);
  }
}
)";

constexpr std::string_view kSourceFragment = R"(
layout(location = 8) flat in vec4 v_face;
layout(location = 9) flat in vec3 v_plane;
layout(location = 0) out vec4 out_light;
layout(location = 1) out vec4 out_place;
const float SAME = 2e-5;   // of the box: the two passes rasterize in different viewports
const float DARK = 1e-6;   // weight of unlit surface, so that it has a place

void main() {
#if !IS_WHOLE
  ivec2 texel = ivec2(gl_FragCoord.xy) - ivec2(0, int(v_face.y) * box_texels.w);
  bool is_hidden = gl_FragCoord.z > texelFetch(face_depth, texel, 0).r + SAME;
  if (is_hidden != (v_face.y > 0.5)) discard;
#endif
  Surface s = GetSurface();
  vec3 entering = EnteringLight(s.position, s.normal, Unit(v_normal)) * ScatterTint(s);
  float area = v_face.z * (IS_WHOLE == 1 ? 1.0 : Share(Unit(v_normal), v_plane, int(v_face.w)));
  vec3 light = entering * (area / virtual_mm.w);
  float weight = DARK * area + light.r + light.g + light.b;
  out_light = vec4(light, area);
  out_place = vec4(UnitOf(v_position) * weight, weight);
}
)";

std::string Begin() {
  std::string text = "#version 450 core\n";
  text += gbuffer::BlockDeclarations();
  text += BodyDeclarations();
  return text;
}

std::string FaceDepthDeclaration() {
  return fmt::format("layout(binding = {}) uniform sampler2D face_depth;\n", static_cast<unsigned>(kFaceDepthUnit));
}

std::string Shares(bool is_paper) {
  return fmt::format("const float REACH = {:.4f};\nconst float SHARING = {:.4f};\n#define IS_WHOLE {}\n",
                     is_paper ? kPaperReach : kFaceReach, kSharing, is_paper ? 1 : 0) +
         std::string(kShares);
}

}  // namespace

std::string FaceDepthVertexText() { return Begin() + std::string(kDepthVertex); }

std::string FaceDepthGeometryText() {
  return Begin() + fmt::format("const float REACH = {:.4f};\n", kFaceReach) + std::string(kTriangle) +
         std::string(kDepthBody);
}

std::string SourceVertexText() { return Begin() + std::string(kSourceVertex); }

std::string SourceGeometryText(bool is_paper) {
  return Begin() + Shares(is_paper) + FaceDepthDeclaration() + std::string(kTriangle) + std::string(kSourceBody);
}

std::string SourceFragmentText(const Quality& quality, std::uint32_t features, int fixed_lights) {
  std::string text = gbuffer::SurfaceText(features | gbuffer::kIsFaceMap);
  text += BodyDeclarations();
  text += IrradianceFunctions(quality, fixed_lights);
  text += Shares(quality.is_paper());
  text += FaceDepthDeclaration();
  text += kSourceFragment;
  return text;
}

}  // namespace burin::translucency
