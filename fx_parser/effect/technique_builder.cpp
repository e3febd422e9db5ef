// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fx_parser/effect/builder.h"
#include "fx_parser/effect/case.h"
#include "fx_parser/effect/state_table.h"

namespace burin::fx {
namespace {

bool IsVertexShaderState(std::string_view name) {
  return EqualsIgnoringCase(name, "VertexShader") || EqualsIgnoringCase(name, "VertexProgram");
}
bool IsPixelShaderState(std::string_view name) {
  return EqualsIgnoringCase(name, "PixelShader") || EqualsIgnoringCase(name, "FragmentProgram");
}

bool IsFalse(const ast::Expression& value) {
  if (const auto* literal = std::get_if<ast::BoolLiteral>(&value.node)) return !literal->value;
  const auto* number = std::get_if<ast::IntLiteral>(&value.node);
  return number != nullptr && number->value == 0;
}

std::string PassTitle(const Pass& pass, int index) {
  return "pass " + (pass.name.empty() ? std::to_string(index) : "'" + pass.name + "'");
}

}  // namespace

void EffectBuilder::BuildPassState(ast::StateAssignment& assignment, Pass& pass, PassShaders& shaders,
                                   std::vector<std::string>& unsupported) {
  if (assignment.is_call || assignment.value == nullptr) {
    unsupported.push_back("Direct3D 10's " + assignment.name);
    return;
  }
  if (IsVertexShaderState(assignment.name)) {
    shaders.vertex = ResolveShader(*assignment.value, true);
    return;
  }
  if (IsPixelShaderState(assignment.name)) {
    shaders.pixel = ResolveShader(*assignment.value, false);
    return;
  }
  if (assignment.index == nullptr && BuildCgState(assignment, pass, shaders)) return;
  const auto* info = FindState(RenderStates(), assignment.name);
  if (info != nullptr && assignment.index == nullptr) {
    auto value = ResolveState(*assignment.value, std::string(info->name), static_cast<int>(info->kind), info->values,
                              assignment.form);
    if (value) pass.states.push_back({info->state, std::move(*value), assignment.range});
    return;
  }
  if (BuildFixedState(assignment, shaders.fixed)) return;
  switch (Classify(assignment.name)) {
    case OtherState::kHarmless:
      if (EqualsIgnoringCase(assignment.name, "FogEnable") && !IsFalse(*assignment.value))
        diagnostics_.Warning(assignment.name_range, "B1023", "FogEnable: the fixed pipeline's fog is not drawn");
      return;
    case OtherState::kFixedVertex:
    case OtherState::kFixedPixel:
      if (!IsFalse(*assignment.value))
        diagnostics_.Warning(assignment.name_range, "B1024",
                             assignment.name + " is ignored: the fixed pipeline here has no such state" +
                                 (assignment.index != nullptr ? " or stage" : ""));
      return;
    case OtherState::kOtherStage: {
      const auto* name = std::get_if<ast::Name>(&assignment.value->node);
      if (name == nullptr || !EqualsIgnoringCase(name->name, "NULL")) unsupported.push_back(assignment.name);
      return;
    }
    case OtherState::kUnknown:
      break;
  }
  const std::string near = NearestName(assignment.name, KnownPassStates());
  diagnostics_.Warning(assignment.name_range, "B1009",
                       "unknown render state '" + assignment.name + "' is ignored" +
                           (near.empty() ? "" : "; did you mean '" + near + "'?"));
}

void EffectBuilder::FindTargets(Technique& technique, Pass& pass) {
  if (!technique.custom_attribute.empty()) return;  // the host draws those into the attribute's own textures
  const int index = static_cast<int>(technique.passes.size());
  std::map<int, std::size_t> targets;
  for (std::size_t i = 0; i < effect_.textures.size(); ++i) {
    const auto* role = std::get_if<PassResultRole>(&effect_.textures[i].role);
    if (role != nullptr && role->pass == index) targets[role->target] = i;
  }
  for (const auto& [target, texture] : targets) pass.targets.push_back(texture);
}

void EffectBuilder::CheckDataFlow(const Technique& technique, const Pass& pass, int index) {
  for (const std::size_t s : SamplersOf(pass)) {
    const Sampler& sampler = effect_.samplers[s];
    if (!sampler.texture) continue;
    const Texture& texture = effect_.textures[*sampler.texture];
    const std::string reads =
        PassTitle(pass, index) + " of technique '" + technique.name + "' reads texture '" + texture.name + "'";
    const auto* attribute = std::get_if<AttributeRole>(&texture.role);
    const auto* result = std::get_if<PassResultRole>(&texture.role);
    std::string fault;
    std::string code = "B1005";
    const bool own_target = std::ranges::find(pass.targets, *sampler.texture) != pass.targets.end();
    const bool own_attribute = attribute != nullptr && !technique.custom_attribute.empty() &&
                               attribute->attribute == technique.custom_attribute;
    if (own_target || own_attribute) {
      fault = ", which it writes";
    } else if (result != nullptr && !technique.custom_attribute.empty()) {
      fault = ": attributes are drawn before any pass";
      code = "B1004";
    } else if (result != nullptr && static_cast<std::size_t>(result->pass) >= technique.passes.size()) {
      fault = ", but the technique has no pass " + std::to_string(result->pass);
      code = "B1004";
    }
    if (!fault.empty()) {
      diagnostics_.Error(pass.range, code, reads + fault)
          .notes.push_back({sampler.range, "through sampler '" + sampler.name + "'"});
    } else if (result != nullptr && technique.custom_attribute.empty() && result->pass > index) {
      diagnostics_
          .Warning(pass.range, "B1010", reads + " before pass " + std::to_string(result->pass) + " has drawn it")
          .notes.push_back({sampler.range, "through sampler '" + sampler.name + "'"});
    }
  }
}

void EffectBuilder::BuildPass(ast::Pass& source, Technique& technique) {
  Pass pass;
  pass.name = source.name;
  pass.range = source.range;
  pass.annotations = BuildAnnotations(source.annotations);
  PassShaders shaders;
  std::vector<std::string> unsupported;
  for (ast::StateAssignment& assignment : source.states) BuildPassState(assignment, pass, shaders, unsupported);
  FinishCgCulling(pass, shaders);
  WritePrograms(pass, shaders, unsupported);
  FindTargets(technique, pass);
  const int index = static_cast<int>(technique.passes.size());
  for (const std::string& reason : unsupported) {
    const std::string text = PassTitle(pass, index) + ": " + reason;
    if (std::ranges::find(technique.unsupported, text) == technique.unsupported.end())
      technique.unsupported.push_back(text);
  }
  technique.passes.push_back(std::move(pass));
}

void EffectBuilder::BuildTechniques() {
  std::map<std::string, const ast::Technique*> names;
  for (ast::Technique* source : checker_.techniques()) {
    if (diagnostics_.exhausted()) return;
    Technique technique;
    technique.name = source->name;
    technique.range = source->range;
    technique.annotations = BuildAnnotations(source->annotations);
    if (source->name.starts_with("GBA") && source->name.size() > 3)
      technique.custom_attribute = LowerCase(std::string_view(source->name).substr(3));
    const auto [at, inserted] = names.emplace(source->name, source);
    if (!inserted && !source->name.empty()) {
      diagnostics_
          .Warning(source->range, "B1027", "a second technique '" + source->name + "': its name means the first one")
          .notes.push_back({at->second->range, "'" + source->name + "' was defined here"});
    }
    if (source->keyword == "technique10" || source->keyword == "technique11") {
      technique.unsupported.push_back(source->keyword + " is not supported");
    } else if (source->passes.empty()) {
      technique.unsupported.push_back("it has no passes");
    } else {
      for (ast::Pass& pass : source->passes) BuildPass(pass, technique);
      for (std::size_t i = 0; i < technique.passes.size(); ++i)
        CheckDataFlow(technique, technique.passes[i], static_cast<int>(i));
    }
    // One without passes says on purpose that nothing is to be drawn.
    if (!technique.unsupported.empty() && !source->passes.empty() && !diagnostics_.has_errors()) {
      std::string text = "technique " + (technique.name.empty() ? "" : "'" + technique.name + "' ") + "cannot run here";
      for (const std::string& reason : technique.unsupported)
        text += (&reason == &technique.unsupported.front() ? ": " : "; ") + reason;
      diagnostics_.Warning(technique.range, "B1026", text);
    }
    effect_.techniques.push_back(std::move(technique));
  }
}

}  // namespace burin::fx
