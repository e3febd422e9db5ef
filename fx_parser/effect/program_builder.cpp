// SPDX-License-Identifier: Apache-2.0
// The shader texts of a pass: of its shaders, of the fixed pipeline where it lacks one, and of all shaders that a
// parameter chooses among.

#include <algorithm>

#include "fx_parser/effect/builder.h"
#include "fx_parser/effect/case.h"
#include "fx_parser/effect/state_table.h"
#include "fx_parser/glsl/interface.h"
#include "fx_parser/glsl/semantic.h"

namespace burin::fx {
namespace {

/// Pairs of shaders that one pass may choose among.
constexpr std::size_t kMaxChoices = 64;

/// Whether the pass may test alpha: a constant false says it does not.
bool SetsAlphaTest(const Pass& pass) {
  bool sets = false;
  for (const PassState& state : pass.states) {
    if (state.name != RenderState::kAlphaTestEnable) continue;
    const auto* value = std::get_if<Value>(&state.value);
    sets = value == nullptr || value->numbers[0] != 0;
  }
  return sets;
}

bool IsTexcoord0(const std::string& semantic) { return ParseSemantic(semantic) == Semantic{"TEXCOORD", 0}; }

bool WritesTexcoord0(const ast::Function& function) {
  const auto of_type = [](const Type& type, const std::string& semantic) {
    if (type.kind != TypeKind::kStruct || type.structure == nullptr) return IsTexcoord0(semantic);
    return std::ranges::any_of(type.structure->members,
                               [](const auto& member) { return IsTexcoord0(member->semantic); });
  };
  return of_type(function.return_type, function.semantic) ||
         std::ranges::any_of(function.parameters, [&](const auto& parameter) {
           return (parameter->qualifiers & ast::kOut) != 0 && of_type(parameter->type, parameter->semantic);
         });
}

bool IsTransform(const FixedState& state) {
  return state.name == FixedName::kWorldTransform || state.name == FixedName::kViewTransform ||
         state.name == FixedName::kProjectionTransform;
}

bool SaysNothing(const FixedPassStates& fixed) {
  return fixed.states.empty() && !fixed.lighting.value_or(false) &&
         std::ranges::all_of(fixed.stages, [](const auto& stage) {
           constexpr int kDisable = 1;
           return !stage.second.texture && !stage.second.sampler &&
                  stage.second.color_op.value_or(kDisable) == kDisable;
         });
}

/// "s3" as 3; -1 for what is no sampler's register.
int SamplerRegister(const ast::Variable& variable) {
  for (const std::string& name : variable.registers) {
    if (name.size() == 2 && LowerCase(name[0]) == 's' && name[1] >= '0' && name[1] < '0' + kFixedStages)
      return name[1] - '0';
  }
  return -1;
}

}  // namespace

void EffectBuilder::NoteSamplers(const ProgramText& text, const Pass& pass, ShaderProgram& program) {
  for (const SamplerBinding& binding : text.samplers) {
    const auto at = FindSampler(binding);
    if (!at) continue;
    program.samplers.push_back(*at);
    Sampler& sampler = effect_.samplers[*at];
    const Dimension used = text.dimensions.at(binding);
    const Texture* texture = sampler.texture ? &effect_.textures[*sampler.texture] : nullptr;
    if (texture != nullptr && texture->dimension != Dimension::kUnknown && texture->dimension != used) {
      diagnostics_
          .Error(sampler.range, "B1018",
                 "sampler '" + sampler.name + "' is looked up in another dimension than its texture '" + texture->name +
                     "' has")
          .notes.push_back({pass.range, "by the shaders of this pass"});
    } else if (sampler.dimension == Dimension::kUnknown) {
      sampler.dimension = used;
    }
  }
}

/// Texture[i], Sampler[i] and MinFilter[i] of a pass change what the shader's sampler of register s<i> is.
void EffectBuilder::RebindRegisters(const FixedPassStates& fixed, const std::vector<SamplerBinding>& bindings,
                                    ShaderProgram& program) {
  if (bindings.size() != program.samplers.size()) return;  // an error, reported elsewhere
  for (std::size_t i = 0; i < bindings.size(); ++i) {
    const auto stage = fixed.stages.find(SamplerRegister(*bindings[i].sampler));
    if (stage == fixed.stages.end() || bindings[i].element >= 0) continue;
    const TextureStageStates& states = stage->second;
    const Dimension used = effect_.samplers[program.samplers[i]].dimension;
    Sampler sampler = effect_.samplers[states.sampler.value_or(program.samplers[i])];
    sampler.name = effect_.samplers[program.samplers[i]].name;
    if (states.texture) sampler.texture = states.texture;
    if (sampler.dimension == Dimension::kUnknown) sampler.dimension = used;
    sampler.states.insert(sampler.states.end(), states.sampler_states.begin(), states.sampler_states.end());
    effect_.samplers.push_back(std::move(sampler));
    program.samplers[i] = effect_.samplers.size() - 1;
  }
}

std::optional<ShaderProgram> EffectBuilder::WriteShaders(Pass& pass, const PassShaders& shaders, const Shader* vertex,
                                                         const Shader* pixel) {
  const FixedPassStates& fixed = shaders.fixed;
  ProgramRequest request;
  if (vertex != nullptr) request.vertex = vertex->entry;
  if (pixel != nullptr) request.fragment = pixel->entry;
  request.alpha_test = SetsAlphaTest(pass);
  request.pixel_offset = !effect_.uses_extension;
  const bool moves = fixed.lighting.value_or(false) || std::ranges::any_of(fixed.states, IsTransform);
  const bool plain = effect_.uses_extension && SaysNothing(fixed);
  std::vector<std::size_t> fixed_samplers;
  FixedPipeline pipeline;
  if (!plain && (pixel == nullptr || (vertex == nullptr && moves))) {
    if (pixel == nullptr) {
      const bool own_texture = vertex == nullptr || WritesTexcoord0(*vertex->entry.function);
      pipeline = MakeFixedPipeline(fixed, pass, own_texture && !effect_.uses_extension, fixed_samplers);
    }
    pipeline.lighting = fixed.lighting.value_or(true);
    pipeline.is_pixel = pixel == nullptr;
    pipeline.is_vertex = vertex == nullptr;
    request.fixed = &pipeline;
    pass.fixed = FixedFunction{.is_vertex = pipeline.is_vertex,
                               .is_pixel = pipeline.is_pixel,
                               .is_lit = pipeline.is_vertex && fixed.lighting.value_or(true),
                               .states = fixed.states};
  }
  ProgramText text = WriteProgram(request, checker_, written_, diagnostics_);
  if (text.vertex_glsl.empty()) return std::nullopt;
  ShaderProgram program;
  program.vertex_glsl = std::move(text.vertex_glsl);
  program.fragment_glsl = std::move(text.fragment_glsl);
  if (vertex != nullptr) program.vertex_entry = request.vertex.function->name;
  if (pixel != nullptr) program.fragment_entry = request.fragment.function->name;
  for (const ast::Variable* variable : text.parameters) program.parameters.push_back(parameters_.at(variable));
  std::sort(program.parameters.begin(), program.parameters.end());
  NoteSamplers(text, pass, program);
  if (pixel != nullptr) RebindRegisters(fixed, text.samplers, program);
  program.samplers.insert(program.samplers.end(), fixed_samplers.begin(), fixed_samplers.end());
  program.vertex_inputs = std::move(text.vertex_inputs);
  program.targets = text.targets;
  program.writes_depth = text.writes_depth;
  program.alpha_test = program.fragment_glsl.find(kUniformAlphaTest) != std::string::npos;
  return program;
}

void EffectBuilder::WriteChoices(Pass& pass, const PassShaders& shaders) {
  const auto options = [](const std::optional<Shader>& shader) {
    std::vector<const Shader*> list;
    if (!shader || !shader->present) return std::vector<const Shader*>{nullptr};
    if (shader->choice == nullptr) return std::vector<const Shader*>{&*shader};
    for (const Shader& option : shader->options) list.push_back(&option);
    return list;
  };
  const std::vector<const Shader*> vertices = options(shaders.vertex);
  const std::vector<const Shader*> pixels = options(shaders.pixel);
  if (vertices.size() * pixels.size() < 2) return;
  if (vertices.size() * pixels.size() > kMaxChoices) {
    diagnostics_.Warning(pass.range, "B1011",
                         "the pass chooses among " + std::to_string(vertices.size() * pixels.size()) +
                             " pairs of shaders; above " + std::to_string(kMaxChoices) +
                             " those of the parameters' initial values are taken");
    return;
  }
  const auto usable = [](const Shader* shader) {
    return shader == nullptr || (!shader->failed && shader->unsupported.empty());
  };
  const auto present = [](const Shader* shader) { return shader != nullptr && shader->present ? shader : nullptr; };
  for (const Shader* vertex : vertices) {
    for (const Shader* pixel : pixels) {
      ShaderProgram program;
      if (usable(vertex) && usable(pixel))
        program = WriteShaders(pass, shaders, present(vertex), present(pixel)).value_or(ShaderProgram{});
      pass.choices.push_back(std::move(program));
    }
  }
  if (shaders.vertex) pass.vertex_choice = {shaders.vertex->choice, vertices.size()};
  if (shaders.pixel) pass.pixel_choice = {shaders.pixel->choice, pixels.size()};
}

void EffectBuilder::WritePrograms(Pass& pass, const PassShaders& shaders, std::vector<std::string>& unsupported) {
  const bool has_vertex = shaders.vertex && shaders.vertex->present;
  const bool has_pixel = shaders.pixel && shaders.pixel->present;
  if (has_vertex && !shaders.vertex->unsupported.empty()) unsupported.push_back(shaders.vertex->unsupported);
  if (has_pixel && !shaders.pixel->unsupported.empty()) unsupported.push_back(shaders.pixel->unsupported);
  pass.restores_states = shaders.vertex && shaders.pixel && !has_vertex && !has_pixel && SaysNothing(shaders.fixed);
  if (!write_programs_ || !unsupported.empty() || (shaders.vertex && shaders.vertex->failed) ||
      (shaders.pixel && shaders.pixel->failed)) {
    return;
  }
  auto program =
      WriteShaders(pass, shaders, has_vertex ? &*shaders.vertex : nullptr, has_pixel ? &*shaders.pixel : nullptr);
  if (!program) return;
  pass.program = *std::move(program);
  WriteChoices(pass, shaders);
}

}  // namespace burin::fx
