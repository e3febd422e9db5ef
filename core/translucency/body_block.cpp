// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/body_block.h"

#include <fmt/format.h>

namespace burin::translucency {

static_assert(sizeof(BodyBlock) == 9 * 16 + kShTerms * 16);
static_assert(sizeof(ShadowBlock) == kMaxShadowMaps * 80 + kMaxShadowedLights * 16);

std::string BodyDeclarations() {
  return fmt::format(R"(
layout(std140, binding = {}) uniform Body {{
  vec4 box_min;
  vec4 box_mm;
  ivec4 box_texels;
  ivec4 box_levels;
  vec4 real_mm;
  vec4 virtual_mm;
  vec4 sigma_tr;
  vec4 dipole_strength;
  vec4 body_reflectance;
  vec4 body_environment[{}];
}};
layout(std140, binding = {}) uniform Shadows {{
  mat4 shadow_from_world[{}];
  vec4 shadow_texel[{}];
  ivec4 shadow_of_light[{}];
}};
vec3 UnitOf(vec3 world) {{ return (world - box_min.xyz) * (box_min.w / box_mm.xyz); }}
// u, v and the axis towards the face.
vec3 FaceAxes(vec3 v, int axis) {{ return axis == 0 ? v.yzx : axis == 1 ? v.zxy : v; }}
ivec3 FaceAxes(ivec3 v, int axis) {{ return axis == 0 ? v.yzx : axis == 1 ? v.zxy : v; }}
vec3 FromFaceAxes(vec3 v, int axis) {{ return axis == 0 ? v.zxy : axis == 1 ? v.yzx : v; }}
)",
                     static_cast<unsigned>(kBodyBinding), kShTerms, static_cast<unsigned>(kShadowBinding),
                     kMaxShadowMaps, kMaxShadowMaps, kMaxShadowedLights);
}

}  // namespace burin::translucency
