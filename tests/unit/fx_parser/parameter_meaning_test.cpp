// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/parameter_meaning.h"

#include <gtest/gtest.h>

#include "fx_parser/effect/sas_address.h"

namespace burin::fx {
namespace {

Parameter Make(const std::string& name, const Type& type, const std::string& semantic = {}) {
  Parameter parameter;
  parameter.name = name;
  parameter.type = type;
  parameter.semantic = semantic;
  return parameter;
}

EffectAnnotation Text(const std::string& name, const std::string& value) {
  EffectAnnotation annotation;
  annotation.name = name;
  annotation.value.type.kind = TypeKind::kString;
  annotation.value.strings = {value};
  return annotation;
}

const Type kMatrix = MatrixType(Scalar::kFloat, 4, 4);
const Type kFloat3 = VectorType(Scalar::kFloat, 3);

TEST(ParameterMeaning, MatricesByTheNamesThatProgramsGiveThem) {
  const std::pair<const char*, const char*> names[] = {{"g_mWorldViewProjection", "worldviewprojection"},
                                                       {"g_mWorld", "world"},
                                                       {"mWVP", "worldviewprojection"},
                                                       {"matWorldViewProj", "worldviewprojection"},
                                                       {"World", "world"},
                                                       {"view_matrix", "view"},
                                                       {"gWorldInverseTranspose", "worldinversetranspose"},
                                                       {"matWorldIT", "worldinversetranspose"},
                                                       {"InvViewProj", "viewprojectioninverse"},
                                                       {"g_mViewInv", "viewinverse"},
                                                       {"ViewProjXf", "viewprojection"},
                                                       {"ObjectToWorld", "world"},
                                                       {"mProj", "projection"},
                                                       {"modelViewProj", "worldviewprojection"}};
  for (const auto& [name, semantic] : names) EXPECT_EQ(MatrixOfName(name), semantic) << name;
  for (const char* name : {"g_mLightViewProj", "texProj", "ShadowMatrix", "mBones", "m", "g_", "", "Colour", "worldly"})
    EXPECT_EQ(MatrixOfName(name), "") << name;
}

TEST(ParameterMeaning, NamesCountOnlyWithoutAnythingBetter) {
  const Parameter eye = Make("g_vEyePt", kFloat3);
  EXPECT_EQ(MeaningOf(eye, true).semantic, "position");
  EXPECT_EQ(MeaningOf(eye, true).object, "camera");
  EXPECT_TRUE(MeaningOf(eye, true).is_implied);
  EXPECT_EQ(MeaningOf(eye, false).semantic, "");
  Parameter given = Make("lightDir", kFloat3);
  EXPECT_EQ(MeaningOf(given, true).semantic, "direction");
  given.has_default = true;
  EXPECT_EQ(MeaningOf(given, true).semantic, "");
  EXPECT_EQ(MeaningOf(Make("World", kMatrix, "VIEW"), true).semantic, "view");
  Parameter ui = Make("SurfaceColor", kFloat3);
  ui.annotations = {Text("UIWidget", "Color")};
  EXPECT_EQ(MeaningOf(ui, true).semantic, "");
}

TEST(ParameterMeaning, NumbersInNamesCountLights) {
  EXPECT_EQ(MeaningOf(Make("LightPos1", kFloat3), true).object, "light1");
  EXPECT_EQ(MeaningOf(Make("Light2Color", kFloat3), true).object, "light2");
  EXPECT_EQ(MeaningOf(Make("DirLight0Direction", kFloat3), true).object, "light0");
  EXPECT_EQ(MeaningOf(Make("Time7", ScalarType(Scalar::kFloat)), true).semantic, "");
}

TEST(ParameterMeaning, MatricesOfLights) {
  for (const char* name : {"g_mLightViewProj", "LightViewProjection", "matLightViewProj"}) {
    const ParameterMeaning meaning = MeaningOf(Make(name, kMatrix), true);
    EXPECT_EQ(meaning.semantic, "viewprojection") << name;
    EXPECT_EQ(meaning.object, "light") << name;
  }
  EXPECT_EQ(MeaningOf(Make("LightWorld", kMatrix), true).semantic, "");
}

TEST(ParameterMeaning, AddressesOfDxsas) {
  Parameter parameter = Make("x", kMatrix);
  parameter.annotations = {Text("SasBindAddress", "Sas.Camera.WorldToView")};
  EXPECT_EQ(MeaningOf(parameter, false).semantic, "view");
  parameter.annotations = {Text("SasBindAddress", "Sas.Nothing")};
  EXPECT_FALSE(MeaningOf(parameter, false).is_known_address);
  parameter.semantic = "WORLD";
  EXPECT_EQ(MeaningOf(parameter, false).semantic, "world");
  const auto light = MeaningOfSasAddress("sas.PointLight[ 3 ].Position");
  ASSERT_TRUE(light);
  EXPECT_EQ(light->semantic, "position");
  EXPECT_EQ(light->object, "pointlight3");
  EXPECT_EQ(MeaningOfSasAddress("Sas.Skeleton.MeshToJointToWorld[0]")->semantic, "world");
  EXPECT_FALSE(MeaningOfSasAddress("Sas.PointLight[0]"));
}

TEST(ParameterMeaning, StatesThatEnginesNameInAnnotations) {
  Parameter parameter = Make("gDiffuse", VectorType(Scalar::kFloat, 4));
  parameter.annotations = {Text("materialState", "Diffuse")};
  EXPECT_EQ(MeaningOf(parameter, false).object, "geometry");
  parameter.annotations = {Text("lightState", "1,Direction")};
  EXPECT_EQ(MeaningOf(parameter, false).semantic, "direction");
  EXPECT_EQ(MeaningOf(parameter, false).object, "light1");
}

}  // namespace
}  // namespace burin::fx
