// SPDX-License-Identifier: Apache-2.0
// MikuMikuEffect's annotations of techniques.
#include "core/effect/object_technique.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/effect/effect_runner.h"
#include "core/effect/schedule.h"
#include "tests/unit/effect/hand_built_effect.h"

namespace burin::effect {
namespace {

using testing::ElementsAre;

fx::EffectAnnotation Flag(const std::string& name, bool value) {
  fx::EffectAnnotation annotation;
  annotation.name = name;
  annotation.value.type = fx::ScalarType(fx::Scalar::kBool);
  annotation.value.numbers = {value ? 1.0 : 0.0};
  return annotation;
}

fx::Technique& Add(EffectBuilder& builder, const std::string& name, const std::string& pass,
                   std::vector<fx::EffectAnnotation> annotations = {}) {
  fx::Technique& technique = builder.Technique(name);
  if (!pass.empty()) annotations.push_back(EffectBuilder::Text("MMDPass", pass));
  technique.annotations = std::move(annotations);
  technique.passes = {EffectBuilder::Pass({})};
  technique.passes[0].projects = true;
  return technique;
}

EffectBuilder Model() {
  EffectBuilder builder;
  Add(builder, "Edge", "edge");
  Add(builder, "Plain", "object", {Flag("UseTexture", false)});
  Add(builder, "Textured", "Object", {Flag("UseTexture", true)});
  Add(builder, "Toon", "object", {Flag("UseToon", true)});
  Add(builder, "Shadowed", "object_ss");
  return builder;
}

TEST(ObjectTechniques, AreThoseThatDrawWhatIsSeen) {
  EXPECT_THAT(ObjectTechniques(Model().effect), ElementsAre(1u, 2u, 3u));
  EffectBuilder shadowed;
  Add(shadowed, "A", "zplot");
  Add(shadowed, "B", "object_ss");
  EXPECT_THAT(ObjectTechniques(shadowed.effect), ElementsAre(1u));
  EffectBuilder plain;
  Add(plain, "A", "");
  EXPECT_THAT(ObjectTechniques(plain.effect), ElementsAre());
}

TEST(ObjectTechniques, AreChosenByMaterial) {
  const EffectBuilder builder = Model();
  MaterialContext bare, textured;
  textured.has_texture = true;
  EXPECT_TRUE(Draws(builder.effect.techniques[1], bare));
  EXPECT_FALSE(Draws(builder.effect.techniques[1], textured));
  EXPECT_TRUE(Draws(builder.effect.techniques[2], textured));
  EXPECT_FALSE(Draws(builder.effect.techniques[3], bare));
  fx::Technique subset;
  subset.annotations = {EffectBuilder::Text("Subset", "0, 3-5,8-")};
  for (const int index : {0, 3, 4, 5, 8, 99}) EXPECT_TRUE(Draws(subset, {.index = index})) << index;
  for (const int index : {1, 2, 6, 7}) EXPECT_FALSE(Draws(subset, {.index = index})) << index;
}

TEST(ObjectTechniques, AreAllScheduledForAScene) {
  const EffectBuilder builder = Model();
  const auto choice = ChooseTechnique(builder.effect, "");
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->technique, 1u);
  const Schedule scene = MakeSchedule(builder.effect, choice->technique, {8, 4},
                                      {.has_scene = true, .number = {}, .by_object = choice->by_object});
  EXPECT_EQ(scene.steps.size(), 3u);
  const Schedule picture = MakeSchedule(builder.effect, choice->technique, {8, 4},
                                        {.has_scene = false, .number = {}, .by_object = choice->by_object});
  EXPECT_EQ(picture.steps.size(), 1u);
  EXPECT_TRUE(ChooseTechnique(builder.effect, "Edge")->by_object.empty()) << "one that is asked for draws everything";
}

}  // namespace
}  // namespace burin::effect
