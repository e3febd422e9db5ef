// SPDX-License-Identifier: Apache-2.0
// Scripts of NVIDIA's Standard Annotations and Semantics 0.8, as FX Composer runs them. What is not cleared by the
// script is cleared where a frame first draws into it, since nothing is carried from one frame to the next.
#include "core/effect/script_schedule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include "core/effect/text.h"

namespace burin::effect {
namespace {

using Action = fx::ScriptStep::Action;
constexpr std::size_t kColorTargets = 8;

class ScriptRun {
 public:
  ScriptRun(const fx::Effect& effect, glm::ivec2 frame, const ScheduleOptions& options, Schedule& schedule)
      : effect_(effect), frame_(frame), options_(options), schedule_(schedule) {}

  void Run(const std::vector<std::size_t>& techniques) {
    for (const std::size_t technique : techniques) RunTechnique(technique);
    if (!drew_into_frame_) schedule_.clears_frame_at_start = true;
  }

 private:
  void RunTechnique(std::size_t technique);
  void RunRange(std::size_t begin, std::size_t end);
  void RunAction(const fx::ScriptStep& step);
  [[nodiscard]] std::size_t LoopEnd(std::size_t begin, std::size_t end) const;
  [[nodiscard]] long Count(const fx::ScriptStep& loop) const;
  [[nodiscard]] Step NewStep() const;
  void AddClear();
  void AddPass(const fx::ScriptStep& draw);
  void AddSource();
  void TouchColors(Step& step, bool clears);
  void TouchDepth(Step& step);
  void Add(Step step);

  const fx::Effect& effect_;
  glm::ivec2 frame_;
  const ScheduleOptions& options_;
  Schedule& schedule_;
  std::span<const fx::ScriptStep> script_;  // of the technique that runs
  std::size_t technique_ = 0;
  bool takes_source_ = false;  // by ScriptExternal; then textures are no other way to it
  std::array<std::optional<std::size_t>, kColorTargets> colors_;
  std::optional<std::size_t> depth_stencil_;
  std::string viewer_;
  ClearStep clear_;            // values as set; what to clear only until it is done
  std::vector<double> turns_;  // of the loops around, innermost last
  std::vector<LoopTurn> loop_turns_;
  std::size_t turns_run_ = 0;  // of all loops
  std::set<std::size_t> touched_;
  std::set<std::pair<std::size_t, std::pair<int, int>>> depth_touched_;
  bool drew_into_frame_ = false;
};

// Each begins with the frame as its target; what was touched before stays so.
void ScriptRun::RunTechnique(std::size_t technique) {
  technique_ = technique;
  script_ = effect_.techniques[technique].script;
  takes_source_ =
      std::ranges::any_of(script_, [](const fx::ScriptStep& step) { return step.action == Action::kDrawSource; });
  colors_ = {};
  depth_stencil_.reset();
  viewer_.clear();
  RunRange(0, script_.size());
  if (clear_.color || clear_.depth || clear_.stencil) AddClear();
}

std::size_t ScriptRun::LoopEnd(std::size_t begin, std::size_t end) const {
  int depth = 1;
  for (std::size_t i = begin; i < end; ++i) {
    if (script_[i].action == Action::kLoop) ++depth;
    if (script_[i].action == Action::kLoopEnd && --depth == 0) return i;
  }
  return end;
}

// FXCOMPOSER_RESETPULSE is true in the first frame, and every frame here is one.
long ScriptRun::Count(const fx::ScriptStep& loop) const {
  if (!loop.parameter) return 1;
  const fx::Parameter& parameter = effect_.parameters[*loop.parameter];
  if (EqualsIgnoringCase(parameter.semantic, "FXCOMPOSER_RESETPULSE")) return 1;
  double count = parameter.default_value.numbers.empty() ? 0.0 : parameter.default_value.numbers[0];
  if (options_.number) count = options_.number(*loop.parameter);
  return std::lround(std::clamp(count, 0.0, static_cast<double>(kMaxSteps)));
}

void ScriptRun::RunRange(std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end && !schedule_.is_cut; ++i) {
    if (script_[i].action != Action::kLoop) {
      RunAction(script_[i]);
      continue;
    }
    const std::size_t last = LoopEnd(i + 1, end);
    const long count = Count(script_[i]);
    turns_.push_back(0.0);
    for (long turn = 0; turn < count && !schedule_.is_cut; ++turn) {
      // Also of loops around nothing, which add no step.
      if (++turns_run_ > kMaxSteps) schedule_.is_cut = true;
      turns_.back() = static_cast<double>(turn);
      RunRange(i + 1, last);
    }
    turns_.pop_back();
    i = last;
  }
}

void ScriptRun::RunAction(const fx::ScriptStep& step) {
  const bool clears =
      step.action == Action::kClearColor || step.action == Action::kClearDepth || step.action == Action::kClearStencil;
  const bool sets = step.action == Action::kSetClearColor || step.action == Action::kSetClearDepth ||
                    step.action == Action::kSetClearStencil;
  // Clears that follow each other are one.
  if (!clears && !sets && (clear_.color || clear_.depth || clear_.stencil)) AddClear();
  switch (step.action) {
    case Action::kColorTarget:
      if (static_cast<std::size_t>(step.index) < kColorTargets)
        colors_[static_cast<std::size_t>(step.index)] = step.texture;
      return;
    case Action::kDepthStencilTarget:
      depth_stencil_ = step.texture;
      return;
    case Action::kSetClearColor:
      clear_.color_parameter = step.parameter;
      return;
    case Action::kSetClearDepth:
      clear_.depth_parameter = step.parameter;
      return;
    case Action::kSetClearStencil:
      clear_.stencil_parameter = step.parameter;
      return;
    case Action::kClearColor:
      clear_.color = true;
      return;
    case Action::kClearDepth:
      clear_.depth = true;
      return;
    case Action::kClearStencil:
      clear_.stencil = true;
      return;
    case Action::kDrawGeometry:
    case Action::kDrawBuffer:
      return AddPass(step);
    case Action::kDrawSource:
      return AddSource();
    case Action::kLoopIndex:
      std::erase_if(loop_turns_, [&](const LoopTurn& turn) { return turn.parameter == *step.parameter; });
      loop_turns_.push_back({*step.parameter, turns_.empty() ? 0.0 : turns_.back()});
      return;
    case Action::kViewer:
      viewer_ = step.viewer;
      return;
    case Action::kLoop:
    case Action::kLoopEnd:
      return;
  }
}

// Several targets must be of one size; those that are not, and those behind a gap, are left out.
Step ScriptRun::NewStep() const {
  Step step;
  step.technique = technique_;
  step.depth_stencil = depth_stencil_;
  step.loop_turns = loop_turns_;
  step.viewer = viewer_;
  step.size = colors_[0] ? schedule_.texture_sizes[*colors_[0]] : frame_;
  for (const auto& color : colors_) {
    if (!color || schedule_.texture_sizes[*color] != step.size) break;
    step.targets.push_back(*color);
  }
  return step;
}

void ScriptRun::Add(Step step) {
  if (schedule_.steps.size() >= kMaxSteps) {
    schedule_.is_cut = true;
    return;
  }
  schedule_.steps.push_back(std::move(step));
}

void ScriptRun::TouchColors(Step& step, bool clears) {
  if (step.targets.empty()) {
    step.clears_targets = clears && !drew_into_frame_;
    drew_into_frame_ = true;
    return;
  }
  std::vector<std::size_t> fresh;
  for (const std::size_t target : step.targets) {
    if (touched_.insert(target).second) fresh.push_back(target);
  }
  step.clears_targets = clears && fresh.size() == step.targets.size();
  if (clears && !step.clears_targets) {
    auto& at_start = schedule_.cleared_at_start;
    at_start.insert(at_start.end(), fresh.begin(), fresh.end());
  }
}

void ScriptRun::TouchDepth(Step& step) {
  const std::size_t owner = step.depth_stencil.value_or(effect_.textures.size());
  step.uses_depth_stencil = true;
  step.clears_depth_stencil = depth_touched_.insert({owner, {step.size.x, step.size.y}}).second;
}

void ScriptRun::AddClear() {
  Step step = NewStep();
  step.kind = Step::Kind::kClear;
  step.clear = clear_;
  clear_.color = clear_.depth = clear_.stencil = false;
  if (step.clear.color) TouchColors(step, false);
  if (step.clear.depth || step.clear.stencil) TouchDepth(step);
  Add(std::move(step));
}

void ScriptRun::AddSource() {
  Step step = NewStep();
  step.kind = Step::Kind::kSource;
  TouchColors(step, false);
  schedule_.copies_source = true;
  Add(std::move(step));
}

void ScriptRun::AddPass(const fx::ScriptStep& draw) {
  Step step = NewStep();
  step.pass = draw.pass;
  step.draws_scene = draw.action == Action::kDrawGeometry;
  step.shows_source = !step.draws_scene && !takes_source_;
  for (const std::size_t sampler : fx::SamplersOf(effect_.techniques[technique_].passes[draw.pass])) {
    const auto texture = effect_.samplers[sampler].texture;
    const auto* role = texture ? std::get_if<fx::ScriptTargetRole>(&effect_.textures[*texture].role) : nullptr;
    if (role != nullptr && !role->is_depth_stencil && !role->is_offscreen && touched_.insert(*texture).second)
      schedule_.cleared_at_start.push_back(*texture);
  }
  TouchColors(step, true);
  TouchDepth(step);
  Add(std::move(step));
}

}  // namespace

void AddScriptSteps(const fx::Effect& effect, const std::vector<std::size_t>& techniques, glm::ivec2 frame,
                    const ScheduleOptions& options, Schedule& schedule) {
  ScriptRun(effect, frame, options, schedule).Run(techniques);
}

}  // namespace burin::effect
