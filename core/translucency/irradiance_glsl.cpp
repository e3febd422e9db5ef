// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/irradiance_glsl.h"

#include <fmt/format.h>

#include "core/translucency/body_block.h"

namespace burin::translucency {
namespace {

constexpr std::string_view kFresnel = R"(
float FresnelTransmittance(float cosine) {
  float c = clamp(cosine, 0.0, 1.0);
  float g = sqrt(max(real_mm.w * real_mm.w - 1.0 + c * c, 0.0));
  float s = (g - c) / max(g + c, 1e-6);
  float p = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
  return 1.0 - 0.5 * s * s * (1.0 + p * p);
}

// The terms of sh_light.h; nine of them in the paper's way, as was usual.
vec3 EnvironmentEntering(vec3 n) {
  float x2 = n.x * n.x, y2 = n.y * n.y, z2 = n.z * n.z;
  vec3 e = 0.28209479 * body_environment[0].rgb
    + 0.48860251 * (n.y * body_environment[1].rgb + n.z * body_environment[2].rgb + n.x * body_environment[3].rgb)
    + 1.09254843 * (n.x * n.y * body_environment[4].rgb + n.y * n.z * body_environment[5].rgb
                    + n.x * n.z * body_environment[7].rgb)
    + 0.31539157 * (3.0 * z2 - 1.0) * body_environment[6].rgb + 0.54627422 * (x2 - y2) * body_environment[8].rgb;
#if ALL_BANDS
  e += 0.59004359 * (n.y * (3.0 * x2 - y2) * body_environment[9].rgb + n.x * (x2 - 3.0 * y2) * body_environment[15].rgb)
    + 2.89061144 * n.x * n.y * n.z * body_environment[10].rgb + 1.44530572 * n.z * (x2 - y2) * body_environment[14].rgb
    + 0.45704580 * (5.0 * z2 - 1.0) * (n.y * body_environment[11].rgb + n.x * body_environment[13].rgb)
    + 0.37317633 * n.z * (5.0 * z2 - 3.0) * body_environment[12].rgb
    + 2.50334294 * n.x * n.y * (x2 - y2) * body_environment[16].rgb
    + 1.77013077 * n.z * (n.y * (3.0 * x2 - y2) * body_environment[17].rgb
                          + n.x * (x2 - 3.0 * y2) * body_environment[23].rgb)
    + 0.94617470 * n.x * n.y * (7.0 * z2 - 1.0) * body_environment[18].rgb
    + 0.66904654 * n.z * (7.0 * z2 - 3.0) * (n.y * body_environment[19].rgb + n.x * body_environment[21].rgb)
    + 0.10578555 * (35.0 * z2 * z2 - 30.0 * z2 + 3.0) * body_environment[20].rgb
    + 0.47308735 * (x2 - y2) * (7.0 * z2 - 1.0) * body_environment[22].rgb
    + 0.62583574 * (x2 * (x2 - 3.0 * y2) - y2 * (3.0 * x2 - y2)) * body_environment[24].rgb;
#endif
  return max(e, vec3(0.0));
}
)";

// Reversed depth: nearer is larger, and a point is lit when it is no farther than the map. The point is moved off the
// surface and towards the light by texels' sizes, against shadows on itself.
constexpr std::string_view kShadow = R"(
layout(binding = {}) uniform sampler2DArrayShadow shadow_maps;
const float AWAY = 1.5;
const float FORWARD = 0.5;

int ShadowMapOf(ivec2 maps, vec3 from_light) {{
  if (maps.y < 6) return maps.x;
  vec3 m = abs(from_light);
  int axis = m.x >= max(m.y, m.z) ? 0 : m.y >= m.z ? 1 : 2;
  float along = axis == 0 ? from_light.x : axis == 1 ? from_light.y : from_light.z;
  return maps.x + 2 * axis + (along > 0.0 ? 0 : 1);
}}

float Lit(int light, vec3 world, vec3 g, vec3 l, vec3 from_light) {{
#if FIXED_LIGHTS
  int map = light;
#else
  if (light >= {}) return 1.0;
  ivec2 maps = shadow_of_light[light].xy;
  if (maps.y == 0) return 1.0;
  int map = ShadowMapOf(maps, from_light);
#endif
  float depth = (shadow_from_world[map] * vec4(world, 1.0)).w;
  float texel = shadow_texel[map].x + shadow_texel[map].y * depth;
  vec4 clip = shadow_from_world[map] * vec4(world + (AWAY * g + FORWARD * l) * texel, 1.0);
  vec2 at = vec2(0.5, -0.5) * clip.xy / clip.w + 0.5;
  return texture(shadow_maps, vec4(at, float(map), clip.z / clip.w));
}}
)";

constexpr std::string_view kEntering = R"(
#if LIGHTS
vec3 LightEntering(int i, vec3 world, vec3 n, vec3 g) {
  vec3 l;
  vec3 light = LightArriving(i, world, l);
  float cosine = dot(n, l);
  // What the surface itself turns away from is dark, whatever normals say that were smoothed or mapped.
  if (cosine <= 0.0 || dot(g, l) <= 0.0) return vec3(0.0);
  return light * (cosine * FresnelTransmittance(cosine) * Lit(i, world, g, l, world - lights[i].position.xyz));
}
#endif
vec3 EnteringLight(vec3 world, vec3 n, vec3 g) {
  vec3 sum = EnvironmentEntering(n);
#if LIGHTS
  FOR_LIGHTS
#endif
  return sum;
}
)";

// A number that the compiler knows is looked up once for all lanes of a vector.
std::string ForLights(int fixed_lights) {
  if (fixed_lights == 0) return "for (int i = 0; i < box_levels.w; ++i) sum += LightEntering(i, world, n, g);";
  std::string calls;
  for (int i = 0; i < fixed_lights; ++i) calls += fmt::format("sum += LightEntering({}, world, n, g); ", i);
  return calls;
}

}  // namespace

int FixedLights(const ShadowBlock& shadows, int lights) {
  constexpr int kMost = 8;
  if (lights > kMost) return 0;
  for (int i = 0; i < lights; ++i) {
    const glm::ivec4& maps = shadows.of_light[static_cast<std::size_t>(i)];
    if (maps.x != i || maps.y != 1) return 0;
  }
  return lights;
}

std::string IrradianceFunctions(const Quality& quality, int fixed_lights) {
  std::string text = fmt::format("#define ALL_BANDS {}\n#define FIXED_LIGHTS {}\n#define FOR_LIGHTS {}\n",
                                 quality.is_paper() ? 0 : 1, fixed_lights, ForLights(fixed_lights));
  text += kFresnel;
  text += fmt::format(kShadow, static_cast<unsigned>(kShadowUnit), kMaxShadowedLights);
  text += kEntering;
  return text;
}

}  // namespace burin::translucency
