// SPDX-License-Identifier: Apache-2.0
#include "core/effect/texture_meaning.h"

#include <gtest/gtest.h>

#include "core/effect/offscreen.h"
#include "tests/unit/effect/hand_built_effect.h"

namespace burin::effect {
namespace {

fx::Texture Make(const std::string& name, const std::string& file = {}, const std::string& semantic = {},
                 fx::Dimension dimension = fx::Dimension::k2D) {
  fx::Texture texture;
  texture.name = name;
  texture.semantic = semantic;
  texture.role = fx::FileRole{file};
  texture.dimension = dimension;
  return texture;
}

TEST(TextureMeaning, BySemanticThenFileThenName) {
  using enum TextureMeaning;
  EXPECT_EQ(MeaningOf(Make("t", "", "diffuse")), kBaseColor);
  EXPECT_EQ(MeaningOf(Make("NormalTexture", "", "DIFFUSE")), kBaseColor) << "a semantic goes before a name";
  EXPECT_EQ(MeaningOf(Make("t", "textures\\default_bump_normal.dds")), kNormal);
  EXPECT_EQ(MeaningOf(Make("ColorTex", "stone_nrm.tga")), kNormal) << "a file goes before a name";
  EXPECT_EQ(MeaningOf(Make("g_NormalMapTexture")), kNormal);
  EXPECT_EQ(MeaningOf(Make("NoiseTex")), kNoise);
  EXPECT_EQ(MeaningOf(Make("ToonRamp")), kRamp);
  EXPECT_EQ(MeaningOf(Make("g_MeshTexture")), kBaseColor);
  EXPECT_EQ(MeaningOf(Make("ObjectToon", "", "MATERIALTOONTEXTURE")), kWhite);
}

TEST(TextureMeaning, ByDimension) {
  using enum TextureMeaning;
  EXPECT_EQ(MeaningOf(Make("t", "", "NORMAL", fx::Dimension::kCube)), kEnvironment);
  EXPECT_EQ(MeaningOf(Make("t", "", "", fx::Dimension::k3D)), kNoise);
  EXPECT_EQ(MeaningOf(Make("t", "", "", fx::Dimension::k1D)), kRamp);
  EXPECT_EQ(MeaningOf(Make("EnvMap")), kWhite) << "surroundings are cubes";
}

TEST(TextureMeaning, FxComposersDefaults) {
  EXPECT_TRUE(IsDefaultFile("Default_Color.dds"));
  EXPECT_TRUE(IsDefaultFile("..\\media\\default_reflection.dds"));
  EXPECT_FALSE(IsDefaultFile("color.dds"));
}

OffscreenContent Content(const std::string& rules) {
  fx::Texture texture;
  if (!rules.empty()) texture.annotations = {EffectBuilder::Text("DefaultEffect", rules)};
  return ContentOf(texture);
}

TEST(Offscreen, TheSceneIsAModelAndNotItself) {
  using Kind = OffscreenContent::Kind;
  EXPECT_EQ(Content("").kind, Kind::kScene);
  EXPECT_EQ(Content("self = hide; * = none;").kind, Kind::kScene);
  EXPECT_EQ(Content("self=hide;*=hide").kind, Kind::kNothing);
  const OffscreenContent mask = Content("self = hide; *.x = none; Miku*.pmd = a.fx; * = Sub\\mask.fx ;");
  EXPECT_EQ(mask.kind, Kind::kEffect);
  EXPECT_EQ(mask.file, "Sub\\mask.fx");
  EXPECT_EQ(Content("*.pmx = b.fx; * = hide;").file, "b.fx");
  EXPECT_EQ(Content("Other.pmx = b.fx;").kind, Kind::kScene);
  EXPECT_EQ(Content(std::string(2000, '*') + "z = b.fx;").kind, Kind::kScene) << "and in no time";
}

}  // namespace
}  // namespace burin::effect
