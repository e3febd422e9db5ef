// SPDX-License-Identifier: Apache-2.0
// Cotangent frame without tangents: Schueler, "Normal Mapping without Precomputed Tangents" (ShaderX 5, 2006).
#include "core/gbuffer/geometry_shader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/gbuffer/face_samples.h"
#include "core/gbuffer/gpu_blocks.h"
#include "core/gbuffer/shading_glsl.h"

namespace burin::gbuffer {
namespace {

constexpr std::string_view kVertexBody = R"(
layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 4) in vec4 in_color;
layout(location = 8) in vec2 in_texcoord0;
layout(location = 9) in vec2 in_texcoord1;
layout(location = 15) in vec3 in_previous_position;
layout(location = 0) out vec3 v_position;
layout(location = 1) out vec3 v_normal;
layout(location = 2) out vec4 v_tangent;
layout(location = 3) out vec4 v_color;
layout(location = 4) out vec2 v_texcoord0;
layout(location = 5) out vec2 v_texcoord1;
layout(location = 6) out vec3 v_clip;
layout(location = 7) out vec3 v_previous_clip;
#if HAS_PATCHES
layout(location = 13) in vec2 in_patch_uv;
layout(location = 14) in uint in_patch_id;
layout(location = 8) out vec2 v_patch_uv;
layout(location = 9) flat out uint v_patch_id;
#endif
invariant gl_Position;
void main() {
  vec4 world = world_from_object * vec4(in_position, 1.0);
  gl_Position = clip_from_world * world;
  v_position = world.xyz;
  v_clip = (clip_from_world * world).xyw;
  v_previous_clip = (previous_clip_from_world * (previous_world_from_object * vec4(in_previous_position, 1.0))).xyw;
  v_normal = mat3(normal_columns[0].xyz, normal_columns[1].xyz, normal_columns[2].xyz) * in_normal;
  v_tangent = vec4(mat3(world_from_object) * in_tangent.xyz, in_tangent.w * normal_columns[0].w);
  v_color = in_color;
  v_texcoord0 = in_texcoord0;
  v_texcoord1 = in_texcoord1;
#if HAS_PATCHES
  v_patch_uv = in_patch_uv;
  v_patch_id = in_patch_id;
#endif
}
)";

constexpr std::string_view kFragmentInputs = R"(
layout(binding = 0) uniform sampler2D base_color_texture;
layout(binding = 1) uniform sampler2D metallic_roughness_texture;
layout(binding = 2) uniform sampler2D normal_texture;
layout(binding = 3) uniform sampler2D occlusion_texture;
layout(binding = 4) uniform sampler2D emissive_texture;
#if IS_SAMPLE
struct FaceSample {
  vec4 position, normal, tangent, color, texcoords;
  vec4 position_dx, position_dy;
  vec4 texcoords_dx, texcoords_dy;
};
layout(std430, binding = 1) readonly buffer FaceSamples { FaceSample samples[]; };
vec3 v_position, v_normal, v_clip = vec3(0.0), v_previous_clip = vec3(0.0);
vec4 v_tangent, v_color, texcoords_dx, texcoords_dy;
vec2 v_texcoord0, v_texcoord1;
vec3 position_dx, position_dy;
float is_back;
bool is_dropped = false;

void LoadSample(int i) {
  v_position = samples[i].position.xyz;
  is_back = samples[i].position.w;
#if HAS_NORMALS
  v_normal = samples[i].normal.xyz;
#endif
#if HAS_TANGENTS
  v_tangent = samples[i].tangent;
#endif
  v_color = samples[i].color;
#if HAS_TEXTURES
  v_texcoord0 = samples[i].texcoords.xy;
  v_texcoord1 = samples[i].texcoords.zw;
  texcoords_dx = samples[i].texcoords_dx;
  texcoords_dy = samples[i].texcoords_dy;
#endif
#if HAS_TEXCOORDS
  position_dx = samples[i].position_dx.xyz;
  position_dy = samples[i].position_dy.xyz;
#endif
}
bool IsFront() { return is_back < 0.5; }
vec3 PositionDx() { return position_dx; }
vec3 PositionDy() { return position_dy; }
vec2 Texcoord0Dx() { return texcoords_dx.xy; }
vec2 Texcoord0Dy() { return texcoords_dy.xy; }
#define DROP is_dropped = true
#define SAMPLE(name, use) textureGrad(name, Texcoord(use), TexcoordChange(use, texcoords_dx), TexcoordChange(use, texcoords_dy))
#else
layout(location = 0) in vec3 v_position;
layout(location = 1) in vec3 v_normal;
layout(location = 2) in vec4 v_tangent;
layout(location = 3) in vec4 v_color;
layout(location = 4) in vec2 v_texcoord0;
layout(location = 5) in vec2 v_texcoord1;
layout(location = 6) in vec3 v_clip;
layout(location = 7) in vec3 v_previous_clip;
bool IsFront() { return IS_FACE_MAP == 1 || gl_FrontFacing; }
vec3 PositionDx() { return dFdx(v_position); }
vec3 PositionDy() { return dFdy(v_position); }
vec2 Texcoord0Dx() { return dFdx(v_texcoord0); }
vec2 Texcoord0Dy() { return dFdy(v_texcoord0); }
#define DROP discard
#define SAMPLE(name, use) texture(name, Texcoord(use))
#if HAS_PATCHES
layout(location = 8) in vec2 v_patch_uv;
layout(location = 9) flat in uint v_patch_id;
uint PatchId() { return ids.w + v_patch_id; }
vec2 PatchUv() { return v_patch_uv; }
#else
uint PatchId() { return 0u; }
vec2 PatchUv() { return vec2(0.0); }
#endif
#endif

struct Surface {
  vec3 position;
  vec3 view;        // towards the eye, unit
  vec3 normal;      // unit, on the side that is seen
  vec3 tangent;     // unit or 0
  vec4 base;
  vec3 emissive;
  float metallic;
  float roughness;
  float occlusion;
};
)";

constexpr std::string_view kSurfaceFunctions = R"(
vec2 Texcoord(int use) {
  vec3 uv = vec3(uv_rows[2 * use].w > 0.5 ? v_texcoord1 : v_texcoord0, 1.0);
  return vec2(dot(uv_rows[2 * use].xyz, uv), dot(uv_rows[2 * use + 1].xyz, uv));
}

vec2 TexcoordChange(int use, vec4 change) {
  vec2 d = uv_rows[2 * use].w > 0.5 ? change.zw : change.xy;
  return vec2(dot(uv_rows[2 * use].xy, d), dot(uv_rows[2 * use + 1].xy, d));
}

// (0,0,0) stays (0,0,0).
vec3 Unit(vec3 v) {
  float square = dot(v, v);
  return square > 0.0 ? v * inversesqrt(square) : v;
}

// The directions in which u and v grow on the surface, from the derivatives of position and texture coordinates.
mat2x3 CotangentFrame(vec3 n) {
  vec3 p1 = PositionDx(), p2 = PositionDy();
  vec2 uv1 = Texcoord0Dx(), uv2 = Texcoord0Dy();
  vec3 a = cross(p2, n), b = cross(n, p1);
  vec3 t = a * uv1.x + b * uv2.x;
  vec3 bt = a * uv1.y + b * uv2.y;
  // The triangle's own orientation on the screen decides the sign of both.
  float side = dot(cross(p1, p2), n) < 0.0 ? -1.0 : 1.0;
  return mat2x3(side * t, -side * bt);   // glTF's normal maps have y up, against v
}

Surface GetSurface() {
  Surface s;
  s.position = v_position;
  s.view = eye.w > 0.5 ? normalize(eye.xyz - v_position) : eye.xyz;
  s.base = base_color * v_color;
#if HAS_BASE_COLOR_TEXTURE
  s.base *= SAMPLE(base_color_texture, 0);
#endif
#if IS_MASKED
  if (s.base.a < emissive_cutoff.w) DROP;
#elif IS_BLEND
  if (s.base.a < BLEND_CUTOFF) DROP;
#endif
  s.metallic = factors.x;
  s.roughness = factors.y;
#if HAS_METALLIC_ROUGHNESS_TEXTURE
  vec4 mr = SAMPLE(metallic_roughness_texture, 1);
  s.metallic *= mr.b;
  s.roughness *= mr.g;
#endif
  s.metallic = clamp(s.metallic, 0.0, 1.0);
  s.roughness = clamp(s.roughness, 0.0, 1.0);
  s.occlusion = 1.0;
#if HAS_OCCLUSION_TEXTURE
  s.occlusion = 1.0 + factors.w * (SAMPLE(occlusion_texture, 3).r - 1.0);
#endif
  s.emissive = emissive_cutoff.rgb;
#if HAS_EMISSIVE_TEXTURE
  s.emissive *= SAMPLE(emissive_texture, 4).rgb;
#endif
#if HAS_NORMALS
  vec3 n = Unit(v_normal);
#else
  vec3 n = s.view;
#endif
  float side = IsFront() ? 1.0 : -1.0;
#if HAS_TANGENTS
  s.tangent = Unit(v_tangent.xyz);
  vec3 bitangent = cross(n, s.tangent) * v_tangent.w;
#elif HAS_TEXCOORDS
  mat2x3 frame = CotangentFrame(side * n);
  s.tangent = Unit(frame[0]);
  vec3 bitangent = Unit(frame[1]);
#else
  s.tangent = vec3(0.0);
  vec3 bitangent = vec3(0.0);
#endif
#if HAS_NORMAL_TEXTURE
  vec3 m = SAMPLE(normal_texture, 2).xyz * 2.0 - 1.0;
  m.xy *= factors.z;
  n = Unit(m.x * s.tangent + m.y * bitangent + m.z * n);
#endif
  s.normal = side * n;
  return s;
}

// Colour is taken half where light enters and half where it leaves (after d'Eon and Luebke 2007): neither all
// of the texture's detail is blurred nor none.
vec3 ScatterTint(Surface s) { return sqrt(max(s.base.rgb, vec3(0.0)) * (1.0 - s.metallic)); }

vec2 PixelOf(vec3 clip) {
  return (vec2(0.5, -0.5) * clip.xy / max(clip.z, 1e-6) + 0.5) * viewport.xy;
}

float LightDepth() {
  vec3 d = v_position - key_position.xyz;
  return key_direction.w > 0.5 && key_direction.w < 1.5 ? length(d) : dot(d, key_direction.xyz);
}
)";

// Jensen et al. 2001, equation 5: radiance is radiosity / pi times what gets through the boundary towards the eye.
constexpr std::string_view kScatter = R"(
struct Scattered { vec3 all; vec3 near; };
Scattered scattered = Scattered(vec3(0.0), vec3(0.0));
#if IS_TRANSLUCENT
Scattered ScatteredLight(Surface s) {
  vec3 g = IsFront() ? Unit(v_normal) : -Unit(v_normal);
  Scattered result;
  Radiosity(s.position, g, result.all, result.near);
  vec3 leaving = ScatterTint(s) * (0.318309886 * FresnelTransmittance(dot(s.normal, s.view)));
  result.all *= leaving;
  result.near *= leaving;
  return result;
}
vec3 Entering(Surface s) { return EnteringLight(s.position, s.normal, IsFront() ? Unit(v_normal) : -Unit(v_normal)); }
#else
vec3 Entering(Surface s) { return vec3(0.0); }
#endif
)";

constexpr std::string_view kCoverage = R"(
#if IS_BLENDED_COLOR
  float coverage = clamp(s.base.a, 0.0, 1.0);
#else
  float coverage = 1.0;
#endif
)";

// Lines and points without normals are not lit: glTF 2.0, 3.7.2.1 (implementation note on point and line materials).
constexpr std::string_view kColorStatements = R"(
#if IS_UNLIT && HAS_NORMALS
  vec3 shaded = s.base.rgb;
#elif IS_UNLIT
  vec3 shaded = s.base.rgb + s.emissive;
#else
  vec3 shaded = Shade(s);
#endif
  vec4 color = vec4(max(shaded, vec3(0.0)) * coverage, coverage);
#if IS_SAMPLE
  if (is_dropped) color = vec4(0.0);
#endif
)";

struct FeatureName {
  DrawFeature feature;
  std::string_view name;
};
constexpr std::array kFeatureNames = {
    FeatureName{kHasBaseColorTexture, "HAS_BASE_COLOR_TEXTURE"},
    FeatureName{kHasMetallicRoughnessTexture, "HAS_METALLIC_ROUGHNESS_TEXTURE"},
    FeatureName{kHasNormalTexture, "HAS_NORMAL_TEXTURE"},
    FeatureName{kHasOcclusionTexture, "HAS_OCCLUSION_TEXTURE"},
    FeatureName{kHasEmissiveTexture, "HAS_EMISSIVE_TEXTURE"},
    FeatureName{kIsUnlit, "IS_UNLIT"},
    FeatureName{kIsMasked, "IS_MASKED"},
    FeatureName{kHasNormals, "HAS_NORMALS"},
    FeatureName{kHasTangents, "HAS_TANGENTS"},
    FeatureName{kHasTexcoords, "HAS_TEXCOORDS"},
    FeatureName{kHasLights, "LIGHTS"},
    FeatureName{kIsBlend, "IS_BLEND"},
    FeatureName{kIsBlendedColor, "IS_BLENDED_COLOR"},
    FeatureName{kIsSample, "IS_SAMPLE"},
    FeatureName{kHasPatches, "HAS_PATCHES"},
    FeatureName{kIsTranslucent, "IS_TRANSLUCENT"},
    FeatureName{kIsFaceMap, "IS_FACE_MAP"},
};

constexpr std::uint32_t kNormalFeatures = kHasNormals | kHasNormalTexture | kHasTangents | kHasTexcoords;

// The value of an attribute as StoreExpression wants it, and what it depends on.
struct Source {
  Attribute attribute;
  std::string_view expression;
  std::uint32_t features;
};
constexpr std::uint32_t kColorFeatures = kHasBaseColorTexture | kHasMetallicRoughnessTexture | kHasOcclusionTexture |
                                         kHasEmissiveTexture | kIsUnlit | kHasLights | kNormalFeatures | kIsTranslucent;
constexpr std::uint32_t kScatterFeatures =
    kHasBaseColorTexture | kHasMetallicRoughnessTexture | kHasLights | kNormalFeatures | kIsTranslucent;
constexpr std::array kSources = {
    Source{Attribute::kColor, "color", kColorFeatures},
    Source{Attribute::kIntensity, "color", kColorFeatures},
    Source{Attribute::kAlpha, "vec4(0.0, 0.0, 0.0, coverage)", 0},
    Source{Attribute::kAlbedo, "vec4(s.base.rgb, 0.0)", kHasBaseColorTexture},
    Source{Attribute::kDepth, "vec4(-(view_from_world * vec4(v_position, 1.0)).z)", 0},
    Source{Attribute::kZbuffer, "vec4(1.0 - gl_FragCoord.z)", 0},
    Source{Attribute::kNormal, "vec4(s.normal, 0.0)", kNormalFeatures},
    Source{Attribute::kViewNormal, "vec4(mat3(view_from_world) * s.normal, 0.0)", kNormalFeatures},
    Source{Attribute::kTangent, "vec4(s.tangent, 0.0)", kHasNormals | kHasTangents | kHasTexcoords},
    Source{Attribute::kPosition, "vec4(v_position, 0.0)", 0},
    Source{Attribute::kViewPosition, "view_from_world * vec4(v_position, 1.0)", 0},
    Source{Attribute::kScreenPosition, "vec4(gl_FragCoord.xy, 0.0, 0.0)", 0},
    Source{Attribute::kTexcoord, "vec4(v_texcoord0, 0.0, 0.0)", 0},
    Source{Attribute::kTexcoord1, "vec4(v_texcoord1, 0.0, 0.0)", 0},
    Source{Attribute::kVertexColor, "v_color", 0},
    Source{Attribute::kObjectId, "ids.x", 0},
    Source{Attribute::kMaterialId, "ids.y", 0},
    Source{Attribute::kPrimitiveId, "(ids.z + uint(gl_PrimitiveID))", 0},
    Source{Attribute::kPatchUv, "vec4(PatchUv(), 0.0, 0.0)", kHasPatches},
    Source{Attribute::kPatchId, "PatchId()", kHasPatches},
    Source{Attribute::kFacing, "vec4(gl_FrontFacing ? 1.0 : -1.0)", 0},
    Source{Attribute::kVelocity, "vec4(PixelOf(v_clip) - PixelOf(v_previous_clip), 0.0, 0.0)", 0},
    Source{Attribute::kEmissive, "vec4(s.emissive, 0.0)", kHasEmissiveTexture},
    Source{Attribute::kRoughness, "vec4(s.roughness)", kHasMetallicRoughnessTexture},
    Source{Attribute::kMetallic, "vec4(s.metallic)", kHasMetallicRoughnessTexture},
    Source{Attribute::kLightDepth, "vec4(LightDepth())", 0},
    Source{Attribute::kIrradiance, "vec4(Entering(s), 0.0)", kScatterFeatures},
    Source{Attribute::kTranslucency, "vec4(scattered.all, 0.0)", kScatterFeatures},
    Source{Attribute::kLocalScattering, "vec4(scattered.near, 0.0)", kScatterFeatures},
    Source{Attribute::kGlobalScattering, "vec4(scattered.all - scattered.near, 0.0)", kScatterFeatures},
};

const Source& SourceOf(Attribute attribute) { return *std::ranges::find(kSources, attribute, &Source::attribute); }

std::string OutputStatement(const Output& output) {
  const std::string target = fmt::format("out{}", output.location);
  if (output.is_blended) return fmt::format("  {} = color;\n", target);
  return fmt::format("  {} = {};\n", target,
                     StoreExpression(output.storage, SourceOf(output.storage.attribute).expression));
}

bool NeedsColor(const std::vector<Output>& outputs) {
  return std::ranges::any_of(outputs, [](const Output& output) {
    return output.is_blended || output.storage.attribute == Attribute::kColor ||
           output.storage.attribute == Attribute::kIntensity;
  });
}

bool WantsParts(const std::vector<Output>& outputs) {
  return std::ranges::any_of(
      outputs, [](const Output& output) { return !output.is_blended && IsScatteringPart(output.storage.attribute); });
}

bool WantsScattering(const std::vector<Output>& outputs) {
  return NeedsColor(outputs) || WantsParts(outputs) || std::ranges::any_of(outputs, [](const Output& output) {
           return output.storage.attribute == Attribute::kTranslucency;
         });
}

}  // namespace

std::uint32_t RelevantFeatures(const std::vector<Output>& outputs, std::uint32_t features) {
  constexpr std::uint32_t kDiscards = kIsMasked | kIsBlend;  // a discarded fragment is missing from every attribute
  std::uint32_t relevant = kDiscards | kIsBlendedColor | kIsSample;
  if ((features & kDiscards) != 0) relevant |= kHasBaseColorTexture;
  for (const Output& output : outputs) {
    const bool is_color = output.is_blended || NeedsColor({output});
    if (is_color && (features & kIsUnlit) != 0) {
      relevant |= kIsUnlit | kHasBaseColorTexture | kHasNormals;
      if ((features & kHasNormals) == 0) relevant |= kHasEmissiveTexture;
    } else {
      relevant |= is_color ? kColorFeatures : SourceOf(output.storage.attribute).features;
    }
  }
  // Without a normal map the tangent frame serves only the tangent itself.
  const bool wants_tangent = std::ranges::any_of(outputs, [](const Output& output) {
    return output.storage.attribute == Attribute::kTangent && !output.is_blended;
  });
  if ((features & relevant & kHasNormalTexture) == 0 && !wants_tangent) relevant &= ~(kHasTangents | kHasTexcoords);
  if ((features & relevant & kHasTangents) != 0) relevant &= ~kHasTexcoords;
  return features & relevant;
}

std::string GeometryVertexText(std::uint32_t features) {
  std::string text = "#version 450 core\n";
  text += fmt::format("#define HAS_PATCHES {}\n", (features & kHasPatches) != 0 ? 1 : 0);
  text += BlockDeclarations();
  text += kVertexBody;
  return text;
}

std::string SurfaceText(std::uint32_t features) {
  std::string text = "#version 450 core\n";
  for (const FeatureName& entry : kFeatureNames) {
    text += fmt::format("#define {} {}\n", entry.name, (features & entry.feature) != 0 ? 1 : 0);
  }
  constexpr std::uint32_t kTextures = kHasBaseColorTexture | kHasMetallicRoughnessTexture | kHasNormalTexture |
                                      kHasOcclusionTexture | kHasEmissiveTexture;
  text += fmt::format("#define HAS_TEXTURES {}\n", (features & kTextures) != 0 ? 1 : 0);
  text += fmt::format("#define BLEND_CUTOFF {:.3f}\n", kBlendCutoff);
  text += BlockDeclarations();
  text += kFragmentInputs;
  text += kSurfaceFunctions;
  text += LightFunctions();
  return text;
}

std::string GeometryFragmentText(const std::vector<Output>& outputs, std::uint32_t features,
                                 std::string_view translucency) {
  std::string text = SurfaceText(features);
  text += StorageFunctions();
  if ((features & kIsTranslucent) != 0) {
    text += fmt::format("#define PARTS {}\n", WantsParts(outputs) ? 1 : 0);
    text += translucency;
  }
  text += kScatter;
  const bool needs_color = NeedsColor(outputs);
  if (needs_color) text += ShadingFunctions();
  for (const Output& output : outputs) {
    text += fmt::format("layout(location = {0}) out vec4 out{0};\n", output.location);
  }
  text += "void main() {\n";
  if ((features & kIsSample) != 0) text += fmt::format("  LoadSample({});\n", FaceSampleIndex());
  text += "  Surface s = GetSurface();\n";
  if (WantsScattering(outputs)) text += "#if IS_TRANSLUCENT\n  scattered = ScatteredLight(s);\n#endif\n";
  text += kCoverage;
  if (needs_color) text += kColorStatements;
  for (const Output& output : outputs) text += OutputStatement(output);
  return text + "}\n";
}

}  // namespace burin::gbuffer
