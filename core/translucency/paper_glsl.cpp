// SPDX-License-Identifier: Apache-2.0
// The paper's scattering: locally a kernel of radius 1 / sigma_t', shortened by the cosine between surface and face,
// over the one face that the surface looks towards; globally one term for the light that came through the object.
//
// What it leaves open or gets wrong is settled here as follows.
//   - A sample's area: the kernel's share of the surface, (2 / (kernel sigma_t'))^2.
//   - Equation 10 multiplies R_g, per area, by no area, and takes the irradiance of the lit point itself, which leaves
//   the
//     far side black. Here the light is that of the points where the axes of the box through x enter it; the area is
//     2 pi S^2 / (1 + sigma S), the disc over which such a source spreads, and S is taken with the source's depth, so
//     that R_g stays finite. Of several such points the brighter count more. So an environment has a global term too.
//   - It drops the virtual source from R_g, so that local and global light together may be more than what entered.
#include "core/translucency/paper_glsl.h"

#include <fmt/format.h>

#include <string_view>

namespace burin::translucency {
namespace {

constexpr std::string_view kText = R"(
struct Sum { vec3 all; vec3 near; };

Source SourceAt(vec3 unit, int face) {
  int axis = face >> 1;
  ivec2 counts = FaceAxes(box_texels.xyz, axis).xy;
  ivec2 texel = ivec2(floor(FaceAxes(unit, axis).xy * vec2(counts)));
  bool is_on_face = texel.x >= 0 && texel.y >= 0 && texel.x < counts.x && texel.y < counts.y;
  texel = clamp(texel, ivec2(0), counts - 1) + ivec2(face * box_texels.w, 0);
  Source s = Unpack(texelFetch(sources, texel, 0));
  s.light = is_on_face && s.area > 0.0 ? s.light * (virtual_mm.w / s.area) : vec3(0.0);   // irradiance
  return s;
}

vec3 Pole(vec3 z, vec3 s2) {
  vec3 s = sqrt(s2);
  return z * (1.0 + sigma_tr.rgb * s) * exp(-sigma_tr.rgb * s) / (s2 * s);
}

vec3 Local(vec3 unit, int face) {
  int axis = face >> 1;
  float path_mm = max(real_mm.r, max(real_mm.g, real_mm.b));
  Source own = SourceAt(unit, face);
  float cosine = own.area > 0.0 ? min(1.0 / own.area, 1.0) : 1.0;   // a texel's surface is its area over the cosine
  vec3 sum = vec3(0.0);
  for (int i = 0; i < KERNEL * KERNEL; ++i) {
    vec2 step = vec2(float(i % KERNEL), float(i / KERNEL)) - 0.5 * float(KERNEL - 1);
    vec2 away = step * (2.0 * cosine * path_mm / float(KERNEL));
    Source s = SourceAt(unit + FromFaceAxes(vec3(away, 0.0), axis) / box_mm.xyz, face);
    vec3 d = (s.place - unit) * box_mm.xyz;
    float d2 = dot(d, d);
    // Each channel's kernel ends at its own mean free path, its samples' area is a share of its own kernel.
    vec3 inside = vec3(lessThanEqual(vec3(d2), 2.0 * real_mm.rgb * real_mm.rgb));
    sum += inside * s.light * (Pole(real_mm.rgb, d2 + real_mm.rgb * real_mm.rgb) +
                               Pole(virtual_mm.rgb, d2 + virtual_mm.rgb * virtual_mm.rgb));
  }
  float side_mm = 2.0 * path_mm / float(KERNEL);
  return sum * (side_mm * side_mm);
}

vec3 Global(vec3 unit) {
  vec3 sum = vec3(0.0), lights = vec3(1e-12);
  for (int face = 0; face < 6; ++face) {
    Source s = SourceAt(unit, face);
    vec3 d = (s.place - unit) * box_mm.xyz;
    vec3 s2 = vec3(dot(d, d));
    vec3 area = 6.2831853 * s2 / (1.0 + sigma_tr.rgb * sqrt(s2));
    vec3 through = vec3(greaterThan(s2, real_mm.rgb * real_mm.rgb));   // nearer points are the kernel's
    sum += through * s.light * s.light * area * Pole(real_mm.rgb, s2 + real_mm.rgb * real_mm.rgb);
    lights += s.light;
  }
  return sum / lights;
}

Sum Gather(vec3 unit, int face, bool is_asked) {
  vec3 near = Local(unit, face) * dipole_strength.rgb;
  return Sum(near + Global(unit) * dipole_strength.rgb, near);
}
)";

}  // namespace

std::string PaperGatherFunctions(int kernel) {
  return fmt::format("const int KERNEL = {};\n", kernel) + std::string(kText);
}

}  // namespace burin::translucency
