// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/effect/schedule.h"
#include "core/effect/technique_choice.h"
#include "tests/unit/effect/hand_built_effect.h"

namespace burin::effect {
namespace {

using Builder = EffectBuilder;
using Action = fx::ScriptStep::Action;

fx::ScriptStep Do(Action action, std::optional<std::size_t> texture = {}, std::size_t pass = 0, int index = 0) {
  fx::ScriptStep step;
  step.action = action;
  step.texture = texture;
  step.pass = pass;
  step.index = index;
  return step;
}

fx::ScriptStep With(Action action, std::size_t parameter) {
  fx::ScriptStep step;
  step.action = action;
  step.parameter = parameter;
  return step;
}

fx::ScriptTargetRole Target(double ratio, bool is_depth = false) {
  fx::ScriptTargetRole role;
  role.is_depth_stencil = is_depth;
  role.width_ratio = role.height_ratio = ratio;
  return role;
}

TEST(ScriptSchedule, DrawsIntoTheTargetsThatAreSet) {
  Builder builder;
  const auto half = builder.Texture("Half", Target(0.5));
  const auto depth = builder.Texture("Depth", Target(0.5, true));
  const auto sampler = builder.Sampler(half);
  fx::Technique& technique = builder.Technique("T");
  technique.passes = {Builder::Pass({}), Builder::Pass({sampler})};
  technique.script = {Do(Action::kColorTarget, half),   Do(Action::kDepthStencilTarget, depth),
                      Do(Action::kDrawGeometry, {}, 0), Do(Action::kColorTarget),
                      Do(Action::kDepthStencilTarget),  Do(Action::kDrawBuffer, {}, 1)};
  const Schedule schedule = MakeSchedule(builder.effect, 0, {8, 4});
  ASSERT_EQ(schedule.steps.size(), 2u);
  EXPECT_EQ(schedule.steps[0].targets, (std::vector<std::size_t>{half}));
  EXPECT_EQ(schedule.steps[0].size, glm::ivec2(4, 2));
  EXPECT_EQ(schedule.steps[0].depth_stencil, depth);
  EXPECT_TRUE(schedule.steps[0].draws_scene);
  EXPECT_TRUE(schedule.steps[0].clears_targets);
  EXPECT_TRUE(schedule.steps[0].clears_depth_stencil);
  EXPECT_TRUE(schedule.steps[1].targets.empty());
  EXPECT_EQ(schedule.steps[1].size, glm::ivec2(8, 4));
  EXPECT_FALSE(schedule.steps[1].draws_scene);
  EXPECT_TRUE(schedule.steps[1].clears_targets);
  EXPECT_EQ(schedule.pass_results, (std::vector<std::size_t>{half}));
  EXPECT_FALSE(schedule.clears_frame_at_start);
}

TEST(ScriptSchedule, WhatTheScriptClearsOrCopiesIsNotClearedAgain) {
  Builder builder;
  const auto scene = builder.Texture("Scene", Target(1));
  builder.Parameter("Black", fx::VectorType(fx::Scalar::kFloat, 4));
  fx::Technique& technique = builder.Technique("T");
  technique.passes = {Builder::Pass({})};
  technique.script = {Do(Action::kColorTarget, scene), With(Action::kSetClearColor, 0), Do(Action::kClearColor),
                      Do(Action::kClearDepth),         Do(Action::kDrawSource),         Do(Action::kDrawBuffer)};
  const Schedule schedule = MakeSchedule(builder.effect, 0, {8, 4});
  ASSERT_EQ(schedule.steps.size(), 3u);
  EXPECT_EQ(schedule.steps[0].kind, Step::Kind::kClear);
  EXPECT_TRUE(schedule.steps[0].clear.color);
  EXPECT_TRUE(schedule.steps[0].clear.depth);
  EXPECT_FALSE(schedule.steps[0].clear.stencil);
  EXPECT_EQ(schedule.steps[0].clear.color_parameter, 0u);
  EXPECT_EQ(schedule.steps[1].kind, Step::Kind::kSource);
  EXPECT_TRUE(schedule.copies_source);
  EXPECT_FALSE(schedule.steps[2].clears_targets);
  EXPECT_FALSE(schedule.steps[2].clears_depth_stencil);
  EXPECT_TRUE(schedule.clears_frame_at_start);
}

TEST(ScriptSchedule, LoopsAreUnrolledByTheirParameters) {
  Builder builder;
  builder.Parameter("Count", fx::ScalarType(fx::Scalar::kFloat)).default_value.numbers = {3};
  builder.Parameter("Turn", fx::ScalarType(fx::Scalar::kFloat));
  builder.Parameter("Reset", fx::ScalarType(fx::Scalar::kBool), "FXComposer_ResetPulse");
  fx::Technique& technique = builder.Technique("T");
  technique.passes = {Builder::Pass({}), Builder::Pass({})};
  technique.script = {With(Action::kLoop, 2), Do(Action::kDrawBuffer, {}, 1), Do(Action::kLoopEnd),
                      With(Action::kLoop, 0), With(Action::kLoopIndex, 1),    Do(Action::kDrawBuffer, {}, 0),
                      Do(Action::kLoopEnd)};
  const Schedule schedule = MakeSchedule(builder.effect, 0, {8, 4});
  ASSERT_EQ(schedule.steps.size(), 4u);
  EXPECT_EQ(schedule.steps[0].pass, 1u);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(schedule.steps[i].pass, 0u);
    ASSERT_EQ(schedule.steps[i].loop_turns.size(), 1u);
    EXPECT_EQ(schedule.steps[i].loop_turns[0].parameter, 1u);
    EXPECT_EQ(schedule.steps[i].loop_turns[0].number, static_cast<double>(i - 1));
  }
  const auto five = [](std::size_t) { return 5.0; };
  EXPECT_EQ(MakeSchedule(builder.effect, 0, {8, 4}, {.has_scene = false, .number = five}).steps.size(), 6u);
  const auto many = [](std::size_t) { return 1e9; };
  const Schedule cut = MakeSchedule(builder.effect, 0, {8, 4}, {.has_scene = false, .number = many});
  EXPECT_TRUE(cut.is_cut);
  EXPECT_LE(cut.steps.size(), kMaxSteps);
}

TEST(ScriptSchedule, LoopsAroundNothingEnd) {
  Builder builder;
  builder.Parameter("Count", fx::ScalarType(fx::Scalar::kFloat)).default_value.numbers = {1e30};
  fx::Technique& technique = builder.Technique("T");
  technique.passes = {Builder::Pass({})};
  technique.script.assign(40, With(Action::kLoop, 0));
  EXPECT_TRUE(MakeSchedule(builder.effect, 0, {8, 4}).is_cut);
}

TEST(ScriptSchedule, TargetsOfOtherSizesThanTheFirstAreLeftOut) {
  Builder builder;
  const auto one = builder.Texture("One", Target(1));
  const auto half = builder.Texture("Half", Target(0.5));
  fx::Technique& technique = builder.Technique("T");
  technique.passes = {Builder::Pass({})};
  technique.script = {Do(Action::kColorTarget, one), Do(Action::kColorTarget, one, 0, 1),
                      Do(Action::kColorTarget, half, 0, 2), Do(Action::kDrawBuffer)};
  EXPECT_EQ(MakeSchedule(builder.effect, 0, {8, 4}).steps[0].targets, (std::vector<std::size_t>{one, one}));
}

TEST(Schedule, PassesThatProjectDrawTheSceneWhereThereIsOne) {
  Builder builder;
  fx::Technique& technique = builder.Technique("T");
  technique.passes = {Builder::Pass({})};
  technique.passes[0].projects = true;
  EXPECT_FALSE(MakeSchedule(builder.effect, 0, {8, 4}).steps[0].draws_scene);
  const Schedule schedule = MakeSchedule(builder.effect, 0, {8, 4}, {.has_scene = true, .number = {}});
  EXPECT_TRUE(schedule.steps[0].draws_scene);
  EXPECT_TRUE(schedule.steps[0].uses_depth_stencil);
  EXPECT_TRUE(schedule.steps[0].clears_depth_stencil);
}

TEST(TechniqueChoice, FollowsTheFilesScript) {
  Builder builder;
  for (const char* name : {"A", "B", "C"}) builder.Technique(name).passes = {Builder::Pass({})};
  builder.effect.techniques[2].unsupported = {"asm shaders"};
  builder.effect.preferred_techniques = {2, 1};
  const auto choice = ChooseTechnique(builder.effect, "");
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->technique, 1u);
}

}  // namespace
}  // namespace burin::effect
