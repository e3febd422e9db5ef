// SPDX-License-Identifier: Apache-2.0
// Scripts as steps over the effect's own textures, parameters and passes. What one of them names and the file has not
// is left out with a warning: the rest of the script may well be all that the technique needs.

#include <algorithm>

#include "fx_parser/effect/builder.h"
#include "fx_parser/effect/case.h"
#include "fx_parser/effect/parameter_meaning.h"
#include "fx_parser/effect/script.h"

namespace burin::fx {
namespace {

using Action = ScriptStep::Action;

/// Steps that one technique's script may have, passes put in.
constexpr std::size_t kMaxScriptSteps = 4096;

std::string StringOf(const std::vector<EffectAnnotation>& annotations, std::string_view name) {
  const EffectAnnotation* annotation = FindAnnotation(annotations, name);
  return annotation == nullptr || annotation->value.strings.empty() ? std::string() : annotation->value.strings[0];
}

Range ScriptRange(const std::vector<ast::Annotation>& annotations, const Range& otherwise) {
  for (const ast::Annotation& annotation : annotations) {
    if (EqualsIgnoringCase(annotation.name, "Script") && annotation.value != nullptr) return annotation.value->range;
  }
  return otherwise;
}

/// The index of what has this name: as written, or else without case; empty when nothing has.
template <class List>
std::optional<std::size_t> FindNamed(const List& list, const std::string& name) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].name == name) return i;
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (EqualsIgnoringCase(list[i].name, name)) return i;
  }
  return std::nullopt;
}

ScriptStep Step(Action action) {
  ScriptStep step;
  step.action = action;
  return step;
}

bool Draws(const ScriptStep& step) {
  return step.action == Action::kDrawGeometry || step.action == Action::kDrawBuffer;
}

/// Whether the vertex shader means a scene's geometry: it projects, or it reads what a quadrilateral has not.
bool ReadsGeometry(const Effect& effect, const Pass& pass) {
  const ShaderProgram& program = pass.program;
  if (pass.fixed && pass.fixed->is_vertex) return true;
  if (program.vertex_entry.empty()) return false;
  const bool projects = std::ranges::any_of(program.parameters, [&](std::size_t parameter) {
    return IsProjection(MeaningOf(effect.parameters[parameter], true).semantic);
  });
  return projects || std::ranges::any_of(program.vertex_inputs, [](const std::string& input) {
           return input == "NORMAL0" || input == "TANGENT0" || input == "BLENDWEIGHT0";
         });
}

}  // namespace

void EffectBuilder::WarnScript(const Range& range, const std::string& text) {
  diagnostics_.Warning(range, "B1020", "script: " + text);
}

std::optional<std::size_t> EffectBuilder::FindParameter(const std::string& name, const std::string& command,
                                                        const Range& range) {
  const auto found = FindNamed(effect_.parameters, name);
  if (!found) WarnScript(range, command + " names '" + name + "', which is no parameter");
  return found;
}

void EffectBuilder::AddScriptCommand(const ScriptCommand& command, const ast::Technique& source, Technique& technique,
                                     std::optional<std::size_t> pass, const Range& range) {
  std::vector<ScriptStep>& script = technique.script;
  const auto with_parameter = [&](Action action) {
    ScriptStep step = Step(action);
    step.parameter = FindParameter(command.value, command.name, range);
    if (step.parameter) script.push_back(step);
  };
  switch (command.verb) {
    case ScriptVerb::kPass: {
      const auto named = FindNamed(technique.passes, command.value);
      if (pass) return WarnScript(range, "a pass cannot run passes: 'Pass=" + command.value + "' is ignored");
      if (!named) return WarnScript(range, "technique '" + technique.name + "' has no pass '" + command.value + "'");
      return BuildPassScript(source, technique, *named);
    }
    case ScriptVerb::kDraw: {
      if (!pass) return WarnScript(range, "'Draw' stands in the script of a pass");
      ScriptStep step = Step(EqualsIgnoringCase(command.value, "Buffer") ? Action::kDrawBuffer : Action::kDrawGeometry);
      step.pass = *pass;
      script.push_back(step);
      return;
    }
    case ScriptVerb::kColorTarget:
    case ScriptVerb::kDepthStencilTarget: {
      const bool is_depth = command.verb == ScriptVerb::kDepthStencilTarget;
      ScriptStep step = Step(is_depth ? Action::kDepthStencilTarget : Action::kColorTarget);
      step.index = command.index;
      if (!command.value.empty()) {
        step.texture = FindNamed(effect_.textures, command.value);
        const auto* role =
            step.texture ? std::get_if<ScriptTargetRole>(&effect_.textures[*step.texture].role) : nullptr;
        if (role == nullptr || role->is_depth_stencil != is_depth) {
          return WarnScript(range, command.name + " names '" + command.value +
                                       "', which is no texture of the semantic " +
                                       (is_depth ? "RENDERDEPTHSTENCILTARGET" : "RENDERCOLORTARGET"));
        }
      }
      script.push_back(step);
      return;
    }
    case ScriptVerb::kClear:
      if (EqualsIgnoringCase(command.value, "Depth")) return script.push_back(Step(Action::kClearDepth));
      if (EqualsIgnoringCase(command.value, "Stencil")) return script.push_back(Step(Action::kClearStencil));
      return script.push_back(Step(Action::kClearColor));
    case ScriptVerb::kClearSetColor:
      return with_parameter(Action::kSetClearColor);
    case ScriptVerb::kClearSetDepth:
      return with_parameter(Action::kSetClearDepth);
    case ScriptVerb::kClearSetStencil:
      return with_parameter(Action::kSetClearStencil);
    case ScriptVerb::kExternal:
      return script.push_back(Step(Action::kDrawSource));
    case ScriptVerb::kLoopByCount: {
      ScriptStep step = Step(Action::kLoop);
      step.parameter = FindParameter(command.value, command.name, range);
      return script.push_back(step);  // without a parameter: once
    }
    case ScriptVerb::kLoopGetIndex:
      return with_parameter(Action::kLoopIndex);
    case ScriptVerb::kLoopEnd:
      return script.push_back(Step(Action::kLoopEnd));
    case ScriptVerb::kRenderPort: {
      const std::string viewer = LowerCase(command.value);
      const bool is_light = viewer.find("light") != std::string::npos || viewer.find("lamp") != std::string::npos;
      if (!viewer.empty() && !is_light)
        WarnScript(range, "RenderPort names '" + command.value + "', which is no light: the camera sees the scene");
      ScriptStep step = Step(Action::kViewer);
      step.viewer = command.value;
      return script.push_back(step);
    }
    case ScriptVerb::kTechnique:
    case ScriptVerb::kSignature:
      return;
    case ScriptVerb::kUnknown:
      break;
  }
  const std::string near = NearestName(command.name, ScriptCommandNames());
  WarnScript(range, "unknown command '" + command.name + "' is ignored" +
                        (near.empty() ? "" : "; did you mean '" + near + "'?"));
}

void EffectBuilder::BuildPassScript(const ast::Technique& source, Technique& technique, std::size_t pass) {
  if (technique.script.size() > kMaxScriptSteps) return;
  const Pass& built = technique.passes[pass];
  const Range range = ScriptRange(source.passes[pass].annotations, built.range);
  const std::size_t first = technique.script.size();
  for (const ScriptCommand& command : ParseScript(StringOf(built.annotations, "Script")))
    AddScriptCommand(command, source, technique, pass, range);
  const bool draws = std::any_of(technique.script.begin() + static_cast<std::ptrdiff_t>(first), technique.script.end(),
                                 [](const ScriptStep& step) { return Draws(step); });
  if (draws) return;
  ScriptStep step = Step(draws_geometry_ ? Action::kDrawGeometry : Action::kDrawBuffer);
  step.pass = pass;
  technique.script.push_back(step);
}

void EffectBuilder::BuildScript(const ast::Technique& source, Technique& technique) {
  if (!technique.custom_attribute.empty() || technique.passes.size() != source.passes.size()) return;
  const std::string text = StringOf(technique.annotations, "Script");
  const bool is_scripted = is_scripted_ || !text.empty();
  if (!is_scripted || !technique.unsupported.empty()) return;
  const Range range = ScriptRange(source.annotations, technique.range);
  for (const ScriptCommand& command : ParseScript(text)) {
    if (technique.script.size() > kMaxScriptSteps) {
      diagnostics_.Error(
          range, "B1021",
          "script: technique '" + technique.name + "' runs more than " + std::to_string(kMaxScriptSteps) + " steps");
      return;
    }
    AddScriptCommand(command, source, technique, std::nullopt, range);
  }
  if (!std::ranges::any_of(technique.script, Draws)) {
    for (std::size_t i = 0; i < technique.passes.size(); ++i) BuildPassScript(source, technique, i);
  }
}

void EffectBuilder::ChooseByScript() {
  for (ast::Variable* variable : checker_.globals()) {
    const auto at = parameters_.find(variable);
    if (at == parameters_.end() || !EqualsIgnoringCase(variable->semantic, "STANDARDSGLOBAL")) continue;
    is_scripted_ = true;
    const Parameter& global = effect_.parameters[at->second];
    draws_geometry_ = !EqualsIgnoringCase(StringOf(global.annotations, "ScriptClass"), "scene");
    const Range range = ScriptRange(variable->annotations, variable->range);
    for (const ScriptCommand& command : ParseScript(StringOf(global.annotations, "Script"))) {
      if (command.verb != ScriptVerb::kTechnique) continue;
      const std::vector<std::string> choices = ScriptChoices(command.value);
      const std::size_t before = effect_.preferred_techniques.size();
      for (const std::string& choice : choices) {
        if (const auto technique = FindNamed(effect_.techniques, choice))
          effect_.preferred_techniques.push_back(*technique);
      }
      // Not of one choice among several: those for Direct3D 10 stand behind an #if.
      if (!choices.empty() && effect_.preferred_techniques.size() == before)
        WarnScript(range, "there is no technique '" + choices.front() + "'");
    }
  }
}

void EffectBuilder::BuildScripts() {
  ChooseByScript();
  const auto sources = checker_.techniques();
  for (std::size_t i = 0; i < effect_.techniques.size() && i < sources.size(); ++i)
    BuildScript(*sources[i], effect_.techniques[i]);
  if (effect_.uses_extension) return;
  for (Technique& technique : effect_.techniques) {
    for (Pass& pass : technique.passes) {
      pass.projects = ReadsGeometry(effect_, pass);
    }
  }
}

}  // namespace burin::fx
