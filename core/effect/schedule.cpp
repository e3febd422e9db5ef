// SPDX-License-Identifier: Apache-2.0
#include "core/effect/schedule.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "core/effect/render_states.h"
#include "core/effect/script_schedule.h"

namespace burin::effect {
namespace {

const fx::Pass& PassOf(const fx::Effect& effect, const Step& step) {
  return effect.techniques[step.technique].passes[step.pass];
}

void CollectTextures(const fx::Effect& effect, const fx::Technique& technique, std::set<std::size_t>& textures) {
  for (const fx::Pass& pass : technique.passes) {
    for (const std::size_t sampler : fx::SamplersOf(pass)) {
      if (effect.samplers[sampler].texture) textures.insert(*effect.samplers[sampler].texture);
    }
    textures.insert(pass.targets.begin(), pass.targets.end());
  }
  for (const fx::ScriptStep& step : technique.script) {
    if (step.texture) textures.insert(*step.texture);
  }
}

std::optional<std::size_t> CustomTechnique(const fx::Effect& effect, const std::string& attribute) {
  for (std::size_t i = 0; i < effect.techniques.size(); ++i) {
    if (effect.techniques[i].custom_attribute == attribute) return i;
  }
  return std::nullopt;
}

// The textures of the technique and, through the custom attributes among them, of the techniques that fill those.
std::set<std::size_t> TexturesUsed(const fx::Effect& effect, std::size_t technique) {
  std::set<std::size_t> used;
  CollectTextures(effect, effect.techniques[technique], used);
  std::size_t before = 0;
  while (before != used.size()) {
    before = used.size();
    for (const std::size_t index : std::set(used)) {
      const auto* role = std::get_if<fx::AttributeRole>(&effect.textures[index].role);
      if (role == nullptr || !role->is_custom) continue;
      if (const auto filler = CustomTechnique(effect, role->attribute)) {
        CollectTextures(effect, effect.techniques[*filler], used);
      }
    }
  }
  return used;
}

void SortByRole(const fx::Effect& effect, const std::set<std::size_t>& used, Schedule& schedule) {
  for (const std::size_t index : used) {
    const auto& role = effect.textures[index].role;
    if (const auto* attribute = std::get_if<fx::AttributeRole>(&role)) {
      (attribute->is_custom ? schedule.custom_attributes : schedule.attributes).push_back(index);
    } else if (std::holds_alternative<fx::PassResultRole>(role)) {
      schedule.pass_results.push_back(index);
    } else if (const auto* target = std::get_if<fx::ScriptTargetRole>(&role)) {
      if (!target->is_depth_stencil) schedule.pass_results.push_back(index);
      if (target->is_offscreen) schedule.offscreen.push_back(index);
    } else if (std::holds_alternative<fx::ProceduralRole>(role)) {
      schedule.procedural.push_back(index);
    } else {
      schedule.files.push_back(index);
    }
  }
}

// The last pass of some engines' techniques only puts states back.
bool DrawsNothing(const fx::Technique& technique, std::size_t pass) {
  return technique.passes.size() > 1 && technique.passes[pass].restores_states;
}

void AddSteps(const fx::Effect& effect, std::size_t technique, std::optional<std::size_t> custom_target,
              glm::ivec2 frame, bool has_scene, Schedule& schedule) {
  for (std::size_t pass = 0; pass < effect.techniques[technique].passes.size(); ++pass) {
    if (DrawsNothing(effect.techniques[technique], pass)) continue;
    Step step;
    step.technique = technique;
    step.pass = pass;
    step.draws_scene = custom_target.has_value() || (has_scene && effect.techniques[technique].passes[pass].projects);
    step.shows_source = !step.draws_scene && !effect.uses_extension;
    if (custom_target) {
      step.targets = {*custom_target};
    } else {
      step.targets = effect.techniques[technique].passes[pass].targets;
    }
    step.size = step.targets.empty() ? frame : schedule.texture_sizes[step.targets.front()];
    schedule.steps.push_back(std::move(step));
  }
}

// Targets are cleared by the first step that draws into them, or before all when one looks them up earlier.
void PlanClears(const fx::Effect& effect, Schedule& schedule) {
  std::set<std::size_t> touched;
  bool frame_touched = false;
  for (Step& step : schedule.steps) {
    for (const std::size_t sampler : fx::SamplersOf(PassOf(effect, step))) {
      const auto texture = effect.samplers[sampler].texture;
      if (!texture || touched.contains(*texture)) continue;
      const auto* attribute = std::get_if<fx::AttributeRole>(&effect.textures[*texture].role);
      const bool is_drawn = std::holds_alternative<fx::PassResultRole>(effect.textures[*texture].role) ||
                            (attribute != nullptr && attribute->is_custom);
      if (is_drawn && touched.insert(*texture).second) schedule.cleared_at_start.push_back(*texture);
    }
    if (step.targets.empty()) {
      step.clears_targets = !frame_touched;
      frame_touched = true;
    } else {
      step.clears_targets = true;
      for (const std::size_t target : step.targets) {
        if (!touched.insert(target).second) step.clears_targets = false;
      }
    }
  }
  schedule.clears_frame_at_start = !frame_touched;
}

bool IsCustom(const fx::Effect& effect, const Step& step) {
  return !effect.techniques[step.technique].custom_attribute.empty();
}

// What a pass's states, as far as they are constant, do with the depth-stencil buffer.
struct DepthUse {
  bool tests = false;          ///< with ZEnable
  bool at_quad_depth = false;  ///< its depth is the quadrilateral's 0: no vertex shader, no DEPTH output
  bool surely_needed = false;  ///< stencil, a comparison that a cleared buffer can fail, or not known before the frame
};

DepthUse UseOfDepth(const fx::Pass& pass) {
  RenderStates states;
  DepthUse use;
  for (const fx::PassState& state : pass.states) {
    if (const auto* value = std::get_if<fx::Value>(&state.value)) {
      static_cast<void>(SetState(states, state.name, *value));
    } else {
      use.surely_needed |= state.name == fx::RenderState::kZEnable || state.name == fx::RenderState::kZFunc ||
                           state.name == fx::RenderState::kStencilEnable;
    }
  }
  constexpr int kLessEqual = 4;
  constexpr int kAlways = 8;
  use.tests = states.z_enable;
  use.at_quad_depth = pass.program.vertex_entry.empty() && !pass.program.writes_depth;
  use.surely_needed |= states.stencil || (states.z_enable && states.z_func != kLessEqual && states.z_func != kAlways);
  return use;
}

// Every pass tests depth by default, yet with the usual comparison the test is only seen where several passes of one
// size lie at different depths. Where it cannot be seen there is no buffer: it would cost more than the shader.
void PlanDepthStencil(const fx::Effect& effect, Schedule& schedule) {
  const auto key = [](const Step& step) { return std::pair(step.size.x, step.size.y); };
  std::map<std::pair<int, int>, bool> needed;
  std::map<std::pair<int, int>, int> testing, off_quad;
  for (const Step& step : schedule.steps) {
    if (IsCustom(effect, step)) continue;
    needed[key(step)] |= step.draws_scene;
    const DepthUse use = UseOfDepth(PassOf(effect, step));
    needed[key(step)] |= use.surely_needed;
    testing[key(step)] += use.tests;
    off_quad[key(step)] += use.tests && !use.at_quad_depth;
  }
  std::set<std::pair<int, int>> cleared;
  std::size_t scene_target = 0;
  bool in_scene = false;
  for (Step& step : schedule.steps) {
    if (IsCustom(effect, step)) {
      step.uses_depth_stencil = true;
      step.clears_depth_stencil = !in_scene || scene_target != step.targets.front();
      scene_target = step.targets.front();
      in_scene = true;
      continue;
    }
    step.uses_depth_stencil = needed[key(step)] || (off_quad[key(step)] > 0 && testing[key(step)] > 1);
    step.clears_depth_stencil = step.uses_depth_stencil && cleared.insert(key(step)).second;
  }
}

// Those of files are known when they are loaded.
glm::ivec2 SizeOf(const fx::Texture& texture, glm::ivec2 frame) {
  if (std::holds_alternative<fx::FileRole>(texture.role)) return glm::ivec2(1);
  if (const auto* made = std::get_if<fx::ProceduralRole>(&texture.role)) return {made->width, made->height};
  const auto* target = std::get_if<fx::ScriptTargetRole>(&texture.role);
  if (target == nullptr) return ScaledSize(texture.scale, frame);
  if (target->width > 0) return {target->width, target->height};
  return {ScaledSize(target->width_ratio, frame).x, ScaledSize(target->height_ratio, frame).y};
}

}  // namespace

glm::ivec2 ScaledSize(double scale, glm::ivec2 frame) {
  constexpr double kLargest = 1 << 30;
  const auto scaled = [&](int length) {
    return static_cast<int>(std::clamp(std::floor(scale * length + 0.5), 1.0, kLargest));
  };
  return {scaled(frame.x), scaled(frame.y)};
}

Schedule MakeSchedule(const fx::Effect& effect, std::size_t technique, glm::ivec2 frame,
                      const ScheduleOptions& options) {
  const std::vector<std::size_t> techniques =
      options.by_object.empty() || !options.has_scene ? std::vector{technique} : options.by_object;
  Schedule schedule;
  for (const fx::Texture& texture : effect.textures) schedule.texture_sizes.push_back(SizeOf(texture, frame));
  std::set<std::size_t> used;
  for (const std::size_t each : techniques) used.merge(TexturesUsed(effect, each));
  SortByRole(effect, used, schedule);
  for (const std::size_t index : schedule.custom_attributes) {
    const auto& role = std::get<fx::AttributeRole>(effect.textures[index].role);
    if (const auto filler = CustomTechnique(effect, role.attribute))
      AddSteps(effect, *filler, index, frame, options.has_scene, schedule);
  }
  const bool is_scripted =
      std::ranges::any_of(techniques, [&](std::size_t each) { return !effect.techniques[each].script.empty(); });
  for (const std::size_t each : techniques) {
    if (!is_scripted) AddSteps(effect, each, std::nullopt, frame, options.has_scene, schedule);
  }
  PlanClears(effect, schedule);
  PlanDepthStencil(effect, schedule);
  if (is_scripted) {
    schedule.clears_frame_at_start = false;
    AddScriptSteps(effect, techniques, frame, options, schedule);
  }
  return schedule;
}

}  // namespace burin::effect
