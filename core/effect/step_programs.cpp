// SPDX-License-Identifier: Apache-2.0
#include "core/effect/step_programs.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <string>

namespace burin::effect {
namespace {

// What this device lacks for one pass; empty when nothing.
std::string DeviceRefusal(const fx::Pass& pass) {
  GLint draw_buffers = 0;
  GLint units = 0;
  glGetIntegerv(GL_MAX_DRAW_BUFFERS, &draw_buffers);
  glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
  if (static_cast<GLint>(pass.targets.size()) > draw_buffers) {
    return fmt::format("pass {} draws into {} targets; this device has {}", pass.name, pass.targets.size(),
                       draw_buffers);
  }
  if (static_cast<GLint>(pass.program.samplers.size()) > units) {
    return fmt::format("pass {} uses {} samplers; this device has {}", pass.name, pass.program.samplers.size(), units);
  }
  return {};
}

}  // namespace

Result<std::vector<StepPrograms>> CompilePrograms(const fx::Effect& effect, const Schedule& schedule) {
  std::vector<StepPrograms> programs;
  for (const Step& step : schedule.steps) {
    if (step.kind != Step::Kind::kPass) {
      programs.emplace_back();
      continue;
    }
    const fx::Technique& technique = effect.techniques[step.technique];
    const fx::Pass& pass = technique.passes[step.pass];
    const std::string label = fmt::format("{}: technique '{}', pass '{}'", effect.path, technique.name, pass.name);
    if (const std::string refusal = DeviceRefusal(pass); !refusal.empty())
      return Fail(ErrorKind::kInput, label + ": " + refusal);
    StepPrograms& own = programs.emplace_back();
    const auto add = [&](const fx::ShaderProgram& shaders) -> Result<void> {
      auto program = PassProgram::Create(effect, shaders, label);
      if (!program) return std::unexpected(program.error());
      own.push_back(std::move(*program));
      return {};
    };
    if (auto added = add(pass.program); !added) return std::unexpected(added.error());
    for (const fx::ShaderProgram& choice : pass.choices) {
      if (choice.vertex_glsl.empty()) continue;
      if (auto added = add(choice); !added) return std::unexpected(added.error());
    }
  }
  return programs;
}

}  // namespace burin::effect
