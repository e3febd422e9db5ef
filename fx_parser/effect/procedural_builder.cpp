// SPDX-License-Identifier: Apache-2.0
// Textures that a function fills, as D3DXFillTexture and FX Composer do: texture t < string function = "Make"; >, with
// float4 Make(float2 place : POSITION, float2 texel : PSIZE) : COLOR.

#include <algorithm>

#include "fx_parser/effect/builder.h"
#include "fx_parser/effect/case.h"

namespace burin::fx {
namespace {

constexpr int kUsualSize = 128;
constexpr int kUsualVolume = 32;
constexpr int kLargestSize = 4096;
constexpr int kLargestVolume = 256;

/// The annotation's own name, or a component of Dimensions.
int Texels(const std::vector<EffectAnnotation>& annotations, std::string_view name, std::size_t component, int usual,
           int largest) {
  double texels = usual;
  if (const EffectAnnotation* all = FindAnnotation(annotations, "Dimensions");
      all != nullptr && component < all->value.numbers.size()) {
    texels = all->value.numbers[component];
  }
  if (const EffectAnnotation* own = FindAnnotation(annotations, name); own != nullptr && !own->value.numbers.empty())
    texels = own->value.numbers[0];
  return texels >= 1 ? static_cast<int>(std::min<double>(texels, largest)) : usual;
}

}  // namespace

void EffectBuilder::BuildProceduralTexture(const ast::Variable& variable, Texture& texture) {
  const EffectAnnotation* named = FindAnnotation(texture.annotations, "function");
  if (named == nullptr || named->value.strings.empty() || !std::holds_alternative<FileRole>(texture.role)) return;
  const std::string& name = named->value.strings[0];
  const auto candidates = checker_.FindFunctions(name);
  const auto warn = [&](const std::string& text) {
    diagnostics_.Warning(variable.range, "B1022", "texture '" + variable.name + "': " + text);
  };
  if (candidates.empty()) {
    const std::string near = NearestName(name, checker_.FunctionNames());
    return warn("there is no function '" + name + "' to fill it" +
                (near.empty() ? "" : "; did you mean '" + near + "'?"));
  }
  const ast::Function& function = *candidates.front();
  const bool has_semantics =
      !function.semantic.empty() && std::ranges::all_of(function.parameters, [](const auto& parameter) {
        return !parameter->semantic.empty() || (parameter->qualifiers & ast::kUniform) != 0;
      });
  if (!has_semantics) return warn("'" + name + "' cannot fill it: its parameters and result need semantics");
  ProgramRequest request;
  request.fragment.function = &function;
  request.fragment.range = variable.range;
  request.fills_texture = true;
  ProgramText text = WriteProgram(request, checker_, written_, diagnostics_);
  if (text.fragment_glsl.empty()) return;
  const bool is_volume = texture.dimension == Dimension::k3D;
  const int usual = is_volume ? kUsualVolume : kUsualSize;
  const int largest = is_volume ? kLargestVolume : kLargestSize;
  ProceduralRole role;
  role.function = name;
  role.width = Texels(texture.annotations, "width", 0, usual, largest);
  role.height = Texels(texture.annotations, "height", 1, usual, largest);
  role.depth = is_volume ? Texels(texture.annotations, "depth", 2, usual, largest) : 1;
  if (texture.dimension == Dimension::kCube) role.height = role.width;
  if (texture.dimension == Dimension::k1D) role.height = 1;
  role.program.vertex_glsl = std::move(text.vertex_glsl);
  role.program.fragment_glsl = std::move(text.fragment_glsl);
  role.program.fragment_entry = name;
  role.program.vertex_inputs = std::move(text.vertex_inputs);
  role.program.targets = text.targets;
  for (const ast::Variable* parameter : text.parameters) role.program.parameters.push_back(parameters_.at(parameter));
  std::sort(role.program.parameters.begin(), role.program.parameters.end());
  if (!text.samplers.empty()) warn("'" + name + "' looks up textures, which read as 0 while textures are filled");
  if (const EffectAnnotation* format = FindAnnotation(texture.annotations, "Format");
      format != nullptr && !format->value.strings.empty()) {
    texture.format = FindFormat(format->value.strings[0]).value_or(Format::kA8R8G8B8);
  }
  texture.role = std::move(role);
}

void EffectBuilder::BuildProceduralTextures() {
  if (!write_programs_) return;
  for (const auto& [variable, index] : textures_) {
    if (diagnostics_.exhausted()) return;
    BuildProceduralTexture(*variable, effect_.textures[index]);
  }
}

}  // namespace burin::fx
