// SPDX-License-Identifier: Apache-2.0
// glTF 2.0, appendix B: the metallic-roughness BRDF.
//   D: Walter et al. 2007, GGX. V: Heitz 2014, "Understanding the Masking-Shadowing Function", height-correlated Smith.
//   F: Schlick 1994. Split sum: Karis 2014, "Physically Based Shading on Mobile", an analytic fit instead of a table.
//   Lost energy of rough reflections: Fdez-Aguera 2019, "A Multiple-Scattering Microfacet Model for Real-Time
//   Image-based Lighting", equations 16 to 20; what is not reflected lights the diffuse part, so a white surface in a
//   white room is white.
// Lights: KHR_lights_punctual, its window for ranges and its smooth cone.
#include "core/gbuffer/shading_glsl.h"

namespace burin::gbuffer {

std::string_view LightFunctions() {
  return R"(
#if LIGHTS
struct Light {
  vec4 position;
  vec4 direction;
  vec4 color;
  vec4 cone;
};
layout(std430, binding = 0) readonly buffer Lights { Light lights[]; };

vec3 LightArriving(int i, vec3 position, out vec3 l) {
  Light light = lights[i];
  l = -light.direction.xyz;
  float strength = 1.0;
  if (light.direction.w > 0.5) {
    vec3 to_light = light.position.xyz - position;
    float d2 = max(dot(to_light, to_light), 1e-8);
    l = to_light * inversesqrt(d2);
    float window = d2 * light.position.w;
    strength = clamp(1.0 - window * window, 0.0, 1.0) / d2;
  }
  if (light.direction.w > 1.5) {
    float cone = clamp(dot(light.direction.xyz, -l) * light.cone.x + light.cone.y, 0.0, 1.0);
    strength *= cone * cone;
  }
  return strength * light.color.rgb;
}
#endif
)";
}

std::string_view ShadingFunctions() {
  return R"(
layout(binding = 5) uniform samplerCube reflections;
const float PI = 3.14159265358979;

vec3 DiffuseLight(vec3 n) {
  vec3 e = 0.282095 * irradiance[0].rgb
         + 0.488603 * (n.y * irradiance[1].rgb + n.z * irradiance[2].rgb + n.x * irradiance[3].rgb)
         + 1.092548 * (n.x * n.y * irradiance[4].rgb + n.y * n.z * irradiance[5].rgb + n.x * n.z * irradiance[7].rgb)
         + 0.315392 * (3.0 * n.z * n.z - 1.0) * irradiance[6].rgb
         + 0.546274 * (n.x * n.x - n.y * n.y) * irradiance[8].rgb;
  return max(e, vec3(0.0));   // nine terms ring below zero round a small bright lamp
}

vec2 SplitSum(float roughness, float n_v) {
  const vec4 c0 = vec4(-1.0, -0.0275, -0.572, 0.022);
  const vec4 c1 = vec4(1.0, 0.0425, 1.04, -0.04);
  vec4 r = roughness * c0 + c1;
  float a004 = min(r.x * r.x, exp2(-9.28 * n_v)) * r.x + r.y;
  return clamp(vec2(-1.04, 1.04) * a004 + r.zw, 0.0, 1.0);
}

vec3 EnvironmentLight(Surface s, vec3 diffuse_color, vec3 f0, float n_v) {
  vec2 ab = SplitSum(s.roughness, n_v);
  vec3 single = f0 * ab.x + ab.y;
  float lost = max(0.0, 1.0 - (ab.x + ab.y));
  vec3 average = f0 + (1.0 - f0) / 21.0;
  vec3 multiple = lost * single * average / (1.0 - average * lost);
  vec3 reflected = textureLod(reflections, reflect(-s.view, s.normal), s.roughness * environment.y).rgb;
  vec3 diffuse = DiffuseLight(s.normal);
  vec3 light = single * reflected + (multiple + diffuse_color * (1.0 - min(single + multiple, vec3(1.0)))) * diffuse;
  return environment.x * s.occlusion * light;
}

#if LIGHTS
vec3 Reflect(Surface s, vec3 diffuse_color, vec3 f0, float n_v, vec3 l) {
  vec3 h = normalize(s.view + l);
  float n_l = clamp(dot(s.normal, l), 0.0, 1.0);
  float n_h = clamp(dot(s.normal, h), 0.0, 1.0);
  float v_h = clamp(dot(s.view, h), 0.0, 1.0);
  float a2 = max(s.roughness * s.roughness, 0.002);
  a2 *= a2;
  float d = n_h * n_h * (a2 - 1.0) + 1.0;
  float distribution = a2 / (PI * d * d);
  float visibility = 0.5 / max(n_l * sqrt(n_v * n_v * (1.0 - a2) + a2) + n_v * sqrt(n_l * n_l * (1.0 - a2) + a2), 1e-5);
  vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - v_h, 5.0);
  return ((1.0 - fresnel) * diffuse_color / PI + fresnel * (distribution * visibility)) * n_l;
}

vec3 PunctualLight(Surface s, vec3 diffuse_color, vec3 f0, float n_v) {
  vec3 sum = vec3(0.0);
  int count = int(environment.z);
  for (int i = 0; i < count; ++i) {
    vec3 l;
    vec3 light = LightArriving(i, s.position, l);
    sum += light * Reflect(s, diffuse_color, f0, n_v, l);
  }
  return sum;
}
#endif

vec3 Shade(Surface s) {
  vec3 f0 = mix(reflectance.xxx, s.base.rgb, s.metallic);
#if IS_TRANSLUCENT
  vec3 diffuse_color = vec3(0.0);   // the light that enters comes out elsewhere
#else
  vec3 diffuse_color = s.base.rgb * (1.0 - s.metallic);
#endif
  float n_v = clamp(dot(s.normal, s.view), 1e-4, 1.0);
  vec3 color = s.emissive + EnvironmentLight(s, diffuse_color, f0, n_v);
#if LIGHTS
  color += PunctualLight(s, diffuse_color, f0, n_v);
#endif
#if IS_TRANSLUCENT
  color += scattered.all;
#endif
  return color;
}
)";
}

}  // namespace burin::gbuffer
