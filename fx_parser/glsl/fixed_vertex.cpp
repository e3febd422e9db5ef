// SPDX-License-Identifier: Apache-2.0
// Transform and lighting of the fixed pipeline: Direct3D 9 documentation, "Mathematics of Lighting". Everything is in
// world space, where the formulas are the same as in the camera space of the documentation.
#include <algorithm>

#include "fx_parser/effect/fixed_function.h"
#include "fx_parser/glsl/fixed_pipeline.h"
#include "fx_parser/glsl/interface.h"

namespace burin::fx {
namespace {

std::string Slot(int slot) { return std::string(kUniformFixed) + "[" + std::to_string(slot) + "]"; }

void Read(std::vector<Semantic>& inputs, const Semantic& input) {
  if (std::find(inputs.begin(), inputs.end(), input) == inputs.end()) inputs.push_back(input);
}

std::string Source(int source, int slot, std::vector<Semantic>& inputs) {
  if (source == 0) return Slot(slot);
  const Semantic color{"COLOR", source == 1 ? 0 : 1};
  Read(inputs, color);
  return "burin_in_" + color.Key();
}

// D3DTSS_TCI_...
enum Generated { kPassThrough = 0, kNormal = 1, kPosition = 2, kReflection = 3, kSphereMap = 4 };

std::string Coordinates(const FixedStage& stage, int index, std::vector<Semantic>& inputs) {
  const int generated = stage.texcoord >> 16;
  std::string text;
  if (generated == kNormal)
    text = "vec4(burin_view_direction(normal), 1.0)";
  else if (generated == kPosition)
    text = "vec4(burin_view_position(world.xyz), 1.0)";
  else if (generated == kReflection)
    text = "vec4(burin_view_direction(reflect(-to_eye, normal)), 1.0)";
  else if (generated == kSphereMap)
    text = "burin_sphere_map(burin_view_direction(reflect(-to_eye, normal)))";
  else {
    const Semantic input{"TEXCOORD", std::clamp(stage.texcoord & 0xFFFF, 0, 7)};
    Read(inputs, input);
    text = "burin_in_" + input.Key();
    // Two coordinates reach the transform as (u, v, 1, 0).
    if (stage.transform_count > 0) text = "vec4(" + text + ".xy, 1.0, 0.0)";
  }
  if (stage.transform_count == 0) return text;
  return "burin_transform(" + std::to_string(kSlotTextureTransforms + 4 * index) + ", " + text + ")";
}

}  // namespace

std::string FixedVertexFunctions(const FixedPipeline& pipeline) {
  const std::string fixed(kUniformFixed);
  std::string text = "uniform vec4 " + fixed + "[" + std::to_string(kFixedSlots) + "];\n" +
                     "vec4 burin_transform(int slot, vec4 v) {\n  return v.x * " + fixed + "[slot] + v.y * " + fixed +
                     "[slot + 1] + v.z * " + fixed + "[slot + 2] + v.w * " + fixed + "[slot + 3];\n}\n";
  const std::string view = std::to_string(int{kSlotView});
  text += "vec3 burin_view_direction(vec3 d) { return burin_transform(" + view + ", vec4(d, 0.0)).xyz; }\n";
  text += "vec3 burin_view_position(vec3 p) { return burin_transform(" + view + ", vec4(p, 1.0)).xyz; }\n";
  text +=
      "vec4 burin_sphere_map(vec3 r) {\n"
      "  float m = 2.0 * sqrt(r.x * r.x + r.y * r.y + (r.z + 1.0) * (r.z + 1.0));\n"
      "  return vec4(r.x / m + 0.5, 0.5 - r.y / m, 0.0, 1.0);\n}\n";
  if (!pipeline.lighting) return text;
  const std::string first = std::to_string(int{kSlotLights});
  const std::string stride = std::to_string(int{kLightSlots});
  // D3DLIGHTTYPE: 1 point, 2 spot, 3 directional.
  text +=
      "void burin_light(int light, vec3 p, vec3 n, vec3 to_eye, float power, inout vec3 ambient, inout vec3 diffuse, "
      "inout vec3 specular) {\n"
      "  int slot = " +
      first + " + light * " + stride +
      ";\n"
      "  vec4 kind = " +
      fixed +
      "[slot];\n"
      "  if (kind.x == 0.0) return;\n"
      "  vec3 to_light = -" +
      fixed +
      "[slot + 5].xyz;\n"
      "  float strength = 1.0;\n"
      "  if (kind.x < 3.0) {\n"
      "    vec3 way = " +
      fixed +
      "[slot + 4].xyz - p;\n"
      "    float d = length(way);\n"
      "    if (d > kind.y) return;\n"
      "    vec3 a = " +
      fixed +
      "[slot + 6].xyz;\n"
      "    strength = 1.0 / max(a.x + a.y * d + a.z * d * d, 1e-6);\n"
      "    vec3 direction = way / max(d, 1e-6);\n"
      "    if (kind.x == 2.0) {\n"
      "      float rho = dot(to_light, direction);\n"
      "      vec4 cone = " +
      fixed +
      "[slot + 7];\n"
      "      float inside = clamp((rho - cone.y) / max(cone.x - cone.y, 1e-6), 0.0, 1.0);\n"
      "      strength *= rho > cone.x ? 1.0 : pow(inside, max(kind.z, 1e-6));\n"
      "    }\n"
      "    to_light = direction;\n"
      "  }\n"
      "  float facing = dot(n, to_light);\n"
      "  ambient += strength * " +
      fixed +
      "[slot + 3].rgb;\n"
      "  diffuse += strength * max(facing, 0.0) * " +
      fixed +
      "[slot + 1].rgb;\n"
      "  vec3 h = to_light + to_eye;\n"
      "  float shine = dot(n, h) / max(length(h), 1e-6);\n"
      "  if (facing > 0.0 && shine > 0.0) specular += strength * pow(shine, power) * " +
      fixed +
      "[slot + 2].rgb;\n"
      "}\n";
  return text;
}

std::string FixedVertexText(const FixedPipeline& pipeline, const std::vector<Semantic>& varyings,
                            std::vector<Semantic>& inputs) {
  Read(inputs, {"POSITION", 0});
  Read(inputs, {"NORMAL", 0});
  const auto transformed = [](int slot, const std::string& what) {
    return "burin_transform(" + std::to_string(slot) + ", " + what + ")";
  };
  std::string main = "  vec4 world = " + transformed(kSlotWorld, "burin_in_POSITION0") + ";\n" +
                     "  gl_Position = " + transformed(kSlotProjection, transformed(kSlotView, "world")) + ";\n" +
                     "  vec3 turned = " + transformed(kSlotWorld, "vec4(burin_in_NORMAL0.xyz, 0.0)") + ".xyz;\n" +
                     "  vec3 normal = turned / max(length(turned), 1e-12);\n" + "  vec3 to_eye = normalize(" +
                     Slot(kSlotEye) + ".xyz - world.xyz);\n";
  if (pipeline.lighting) {
    const std::string diffuse = Source(pipeline.sources[0], kSlotMaterialDiffuse, inputs);
    main += "  vec3 lit_ambient = " + Slot(kSlotAmbient) + ".rgb;\n" +
            "  vec3 lit_diffuse = vec3(0.0), lit_specular = vec3(0.0);\n" + "  for (int i = 0; i < " +
            std::to_string(kFixedLights) + "; ++i)\n" + "    burin_light(i, world.xyz, normal, to_eye, " +
            Slot(kSlotMaterialPower) + ".x, lit_ambient, lit_diffuse, lit_specular);\n" +
            "  vec4 color = vec4(lit_ambient * " + Source(pipeline.sources[2], kSlotMaterialAmbient, inputs) +
            ".rgb + lit_diffuse * " + diffuse + ".rgb + " + Source(pipeline.sources[3], kSlotMaterialEmissive, inputs) +
            ".rgb, " + diffuse + ".a);\n" + "  vec4 shine = vec4(lit_specular * " +
            Source(pipeline.sources[1], kSlotMaterialSpecular, inputs) + ".rgb, 1.0);\n";
  } else {
    Read(inputs, {"COLOR", 0});
    main += "  vec4 color = burin_in_COLOR0;\n  vec4 shine = vec4(0.0);\n";
  }
  for (const Semantic& varying : varyings) {
    std::string value = "vec4(0.0)";
    if (varying == Semantic{"COLOR", 0}) {
      value = "clamp(color, 0.0, 1.0)";
    } else if (varying == Semantic{"COLOR", 1}) {
      value = "clamp(shine, 0.0, 1.0)";
    } else if (varying.name == "TEXCOORD") {
      const auto index = static_cast<std::size_t>(varying.index);
      FixedStage plain;
      plain.texcoord = std::min(varying.index, 7);
      value = Coordinates(index < pipeline.stages.size() ? pipeline.stages[index] : plain, varying.index, inputs);
    }
    main += "  burin_v_" + varying.Key() + " = " + value + ";\n";
  }
  return main;
}

}  // namespace burin::fx
