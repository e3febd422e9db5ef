// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/effect/effect_runner.h"
#include "core/effect/technique_choice.h"
#include "tests/unit/effect/hand_built_effect.h"

namespace burin::effect {
namespace {

EffectBuilder ThreeTechniques() {
  EffectBuilder builder;
  builder.Technique("GBAcustom", "custom").passes.push_back(EffectBuilder::Pass({}));
  builder.Technique("Asm").unsupported = {"pass P0: asm shaders", "pass P1: fixed function"};
  builder.Technique("Empty");
  builder.Technique("Good").passes.push_back(EffectBuilder::Pass({}));
  builder.Technique("Better").passes.push_back(EffectBuilder::Pass({}));
  return builder;
}

TEST(ChooseTechnique, TakesTheFirstThatValidatesAndSaysWhyNotTheOthers) {
  const auto choice = ChooseTechnique(ThreeTechniques().effect, "");
  ASSERT_TRUE(choice.has_value());
  EXPECT_EQ(choice->technique, 3u);
  EXPECT_EQ(choice->rejected, (std::vector<std::pair<std::string, std::string>>{
                                  {"Asm", "pass P0: asm shaders; pass P1: fixed function"}, {"Empty", "it has no passes"}}));
}

TEST(ChooseTechnique, TakesTheOneThatIsNamed) {
  const auto choice = ChooseTechnique(ThreeTechniques().effect, "Better");
  ASSERT_TRUE(choice.has_value());
  EXPECT_EQ(choice->technique, 4u);
  EXPECT_TRUE(choice->rejected.empty());
}

TEST(ChooseTechnique, RefusesANamedOneThatCannotRun) {
  const auto choice = ChooseTechnique(ThreeTechniques().effect, "Asm");
  ASSERT_FALSE(choice.has_value());
  EXPECT_EQ(choice.error().kind, ErrorKind::kInput);
  EXPECT_EQ(choice.error().message,
            "test.fx: technique 'Asm' cannot run here: pass P0: asm shaders; pass P1: fixed function");
}

TEST(ChooseTechnique, SuggestsNearNames) {
  const auto near = ChooseTechnique(ThreeTechniques().effect, "good");
  ASSERT_FALSE(near.has_value());
  EXPECT_EQ(near.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(near.error().message, "test.fx has no technique 'good'; did you mean 'Good'?");
  const auto far = ChooseTechnique(ThreeTechniques().effect, "Watercolour");
  ASSERT_FALSE(far.has_value());
  EXPECT_EQ(far.error().message, "test.fx has no technique 'Watercolour'; it has Asm, Empty, Good, Better");
}

TEST(ChooseTechnique, DoesNotTakeACustomAttributesTechniqueForAFrame) {
  EffectBuilder builder;
  builder.Technique("GBAcustom", "custom").passes.push_back(EffectBuilder::Pass({}));
  const auto choice = ChooseTechnique(builder.effect, "");
  ASSERT_FALSE(choice.has_value());
  EXPECT_EQ(choice.error().message, "test.fx: no technique that draws a frame");
  EXPECT_FALSE(ChooseTechnique(ThreeTechniques().effect, "GBAcustom").has_value());
}

TEST(ChooseTechnique, ListsEveryReasonWhenNoneCanRun) {
  EffectBuilder builder;
  builder.Technique("A").unsupported = {"asm"};
  builder.Technique("").unsupported = {"fixed function"};
  const auto choice = ChooseTechnique(builder.effect, "");
  ASSERT_FALSE(choice.has_value());
  EXPECT_EQ(choice.error().kind, ErrorKind::kInput);
  EXPECT_EQ(choice.error().message,
            "test.fx: no technique can run here\n  'A': asm\n  (unnamed): fixed function");
}

// An effect whose one pass reads attributes of these names and formats.
image::Encoding EncodingOf(const std::vector<std::pair<std::string, fx::Format>>& attributes,
                           const std::string& annotation = {}) {
  EffectBuilder builder;
  std::vector<std::size_t> samplers;
  for (const auto& [name, format] : attributes) {
    samplers.push_back(builder.Sampler(builder.Texture("GBA" + name, fx::AttributeRole{name, false}, format)));
  }
  fx::Technique& technique = builder.Technique("T");
  technique.passes.push_back(EffectBuilder::Pass(samplers));
  if (!annotation.empty()) technique.annotations.push_back(EffectBuilder::Text("colorspace", annotation));
  return FrameEncoding(builder.effect, 0);
}

TEST(FrameEncoding, FollowsTheColourAttributes) {
  using enum fx::Format;
  EXPECT_EQ(EncodingOf({}), image::Encoding::kDisplay);
  EXPECT_EQ(EncodingOf({{"color", kA8R8G8B8}}), image::Encoding::kDisplay);
  EXPECT_EQ(EncodingOf({{"color", kA16B16G16R16}}), image::Encoding::kDisplay);
  EXPECT_EQ(EncodingOf({{"color", kA16B16G16R16F}}), image::Encoding::kSceneLinear);
  EXPECT_EQ(EncodingOf({{"color", kA16B16G16R16F}, {"video", kA8R8G8B8}}), image::Encoding::kDisplay);
  EXPECT_EQ(EncodingOf({{"depth", kR32F}}), image::Encoding::kDisplay);
  EXPECT_EQ(EncodingOf({{"intensity", kR16F}}), image::Encoding::kSceneLinear);
  EXPECT_EQ(EncodingOf({{"intensity", kL8}, {"color", kA16B16G16R16F}}), image::Encoding::kSceneLinear);
}

TEST(FrameEncoding, TheAnnotationOverrides) {
  EXPECT_EQ(EncodingOf({{"color", fx::Format::kA8R8G8B8}}, "Linear"), image::Encoding::kSceneLinear);
  EXPECT_EQ(EncodingOf({{"color", fx::Format::kR32F}}, "display"), image::Encoding::kDisplay);
}

TEST(AcceptsParameter, KnowsParametersAndFiles) {
  EffectBuilder builder;
  builder.Parameter("Sigma", fx::ScalarType(fx::Scalar::kFloat));
  builder.Texture("paper", fx::FileRole{});
  builder.Texture("GBAcolor_A8R8G8B8", fx::AttributeRole{"color", false});
  EXPECT_TRUE(AcceptsParameter(builder.effect, "Sigma"));
  EXPECT_TRUE(AcceptsParameter(builder.effect, "paper"));
  EXPECT_FALSE(AcceptsParameter(builder.effect, "sigma"));
  EXPECT_FALSE(AcceptsParameter(builder.effect, "GBAcolor_A8R8G8B8"));
}

}  // namespace
}  // namespace burin::effect
