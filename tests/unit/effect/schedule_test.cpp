// SPDX-License-Identifier: Apache-2.0
#include "core/effect/schedule.h"

#include <gtest/gtest.h>

#include "tests/unit/effect/hand_built_effect.h"

namespace burin::effect {
namespace {

using Builder = EffectBuilder;

TEST(ScaledSize, RoundsAndIsNeverEmpty) {
  EXPECT_EQ(ScaledSize(3, {17, 11}), glm::ivec2(51, 33));
  EXPECT_EQ(ScaledSize(0.5, {17, 11}), glm::ivec2(9, 6));
  EXPECT_EQ(ScaledSize(0.001, {17, 11}), glm::ivec2(1, 1));
  EXPECT_EQ(ScaledSize(1e30, {17, 11}), glm::ivec2(1 << 30, 1 << 30));
}

TEST(Schedule, ClearsEachTargetWhereItIsFirstDrawnInto) {
  Builder builder;
  const auto result = builder.Texture("PASS0", fx::PassResultRole{0, 0});
  const auto sampler = builder.Sampler(result);
  fx::Technique& technique = builder.Technique("T");
  technique.passes = {Builder::Pass({}, {result}), Builder::Pass({sampler}), Builder::Pass({sampler})};
  const Schedule schedule = MakeSchedule(builder.effect, 0, {8, 4});
  ASSERT_EQ(schedule.steps.size(), 3u);
  EXPECT_TRUE(schedule.steps[0].clears_targets);
  EXPECT_TRUE(schedule.steps[1].clears_targets);    // the frame
  EXPECT_FALSE(schedule.steps[2].clears_targets);
  EXPECT_TRUE(schedule.cleared_at_start.empty());
  EXPECT_FALSE(schedule.clears_frame_at_start);
  EXPECT_EQ(schedule.pass_results, (std::vector<std::size_t>{result}));
}

TEST(Schedule, ClearsAtTheStartWhatIsReadBeforeItIsDrawn) {
  Builder builder;
  const auto later = builder.Texture("PASS1", fx::PassResultRole{1, 0});
  const auto sampler = builder.Sampler(later);
  builder.Technique("T").passes = {Builder::Pass({sampler}), Builder::Pass({}, {later})};
  const Schedule schedule = MakeSchedule(builder.effect, 0, {8, 4});
  EXPECT_EQ(schedule.cleared_at_start, (std::vector<std::size_t>{later}));
  EXPECT_FALSE(schedule.steps[1].clears_targets);
}

TEST(Schedule, ClearsAFrameThatNoPassDrawsInto) {
  Builder builder;
  const auto result = builder.Texture("PASS0", fx::PassResultRole{0, 0});
  builder.Technique("T").passes = {Builder::Pass({}, {result})};
  EXPECT_TRUE(MakeSchedule(builder.effect, 0, {8, 4}).clears_frame_at_start);
}

TEST(Schedule, HasOnlyTheTexturesOfItsTechnique) {
  Builder builder;
  const auto color = builder.Texture("GBAcolor", fx::AttributeRole{"color", false});
  const auto normal = builder.Texture("GBAnormal", fx::AttributeRole{"normal", false});
  const auto file = builder.Texture("paper", fx::FileRole{});
  const auto a = builder.Sampler(color);
  const auto b = builder.Sampler(normal);
  const auto c = builder.Sampler(file);
  builder.Technique("One").passes = {Builder::Pass({a})};
  builder.Technique("Two").passes = {Builder::Pass({b, c})};
  const Schedule one = MakeSchedule(builder.effect, 0, {8, 4});
  EXPECT_EQ(one.attributes, (std::vector<std::size_t>{color}));
  EXPECT_TRUE(one.files.empty());
  const Schedule two = MakeSchedule(builder.effect, 1, {8, 4});
  EXPECT_EQ(two.attributes, (std::vector<std::size_t>{normal}));
  EXPECT_EQ(two.files, (std::vector<std::size_t>{file}));
}

TEST(Schedule, FillsCustomAttributesFirstAndWhatTheyReadThemselves) {
  Builder builder;
  const auto custom = builder.Texture("GBAtint", fx::AttributeRole{"tint", true}, fx::Format::kA8R8G8B8, 2.0);
  const auto color = builder.Texture("GBAcolor", fx::AttributeRole{"color", false});
  const auto s = builder.Sampler(custom);
  const auto t = builder.Sampler(color);
  builder.Technique("T").passes = {Builder::Pass({s})};
  builder.Technique("GBAtint", "tint").passes = {Builder::Pass({t}), Builder::Pass({})};
  const Schedule schedule = MakeSchedule(builder.effect, 0, {8, 4});
  EXPECT_EQ(schedule.attributes, (std::vector<std::size_t>{color}));
  EXPECT_EQ(schedule.custom_attributes, (std::vector<std::size_t>{custom}));
  ASSERT_EQ(schedule.steps.size(), 3u);
  EXPECT_TRUE(schedule.steps[0].draws_scene);
  EXPECT_TRUE(schedule.steps[0].clears_targets);
  EXPECT_TRUE(schedule.steps[0].clears_depth_stencil);
  EXPECT_EQ(schedule.steps[0].size, glm::ivec2(16, 8));
  EXPECT_TRUE(schedule.steps[1].draws_scene);
  EXPECT_FALSE(schedule.steps[1].clears_targets);
  EXPECT_FALSE(schedule.steps[1].clears_depth_stencil);
  EXPECT_FALSE(schedule.steps[2].draws_scene);
}

// Whether the passes of a technique get a depth-stencil buffer.
bool UsesDepth(std::vector<fx::Pass> passes) {
  Builder builder;
  builder.Technique("T").passes = std::move(passes);
  const Schedule schedule = MakeSchedule(builder.effect, 0, {8, 4});
  return schedule.steps.back().uses_depth_stencil;
}

fx::Pass WithVertexShader() {
  fx::Pass pass = Builder::Pass({});
  pass.program.vertex_entry = "Vs";
  return pass;
}

fx::Pass WithState(fx::RenderState name, double value) {
  fx::Pass pass = Builder::Pass({});
  pass.states.push_back(Builder::Set(name, value));
  return pass;
}

TEST(Schedule, HasADepthBufferOnlyWhereItCanBeSeen) {
  EXPECT_FALSE(UsesDepth({Builder::Pass({})}));
  EXPECT_FALSE(UsesDepth({Builder::Pass({}), Builder::Pass({})}));
  EXPECT_FALSE(UsesDepth({WithVertexShader()}));
  EXPECT_TRUE(UsesDepth({WithVertexShader(), WithVertexShader()}));
  EXPECT_TRUE(UsesDepth({WithVertexShader(), Builder::Pass({})}));
  EXPECT_TRUE(UsesDepth({WithState(fx::RenderState::kZFunc, 2)}));
  EXPECT_TRUE(UsesDepth({WithState(fx::RenderState::kStencilEnable, 1)}));
  EXPECT_FALSE(UsesDepth({WithState(fx::RenderState::kZEnable, 0), WithState(fx::RenderState::kZEnable, 0)}));
}

}  // namespace
}  // namespace burin::effect
