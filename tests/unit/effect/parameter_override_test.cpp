// SPDX-License-Identifier: Apache-2.0
#include "core/effect/parameter_override.h"

#include <gtest/gtest.h>

#include "core/effect/parameter_range.h"
#include "tests/unit/effect/hand_built_effect.h"

namespace burin::effect {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

EffectBuilder Effect() {
  EffectBuilder builder;
  builder.Parameter("Sigma", fx::ScalarType(fx::Scalar::kFloat));
  builder.Parameter("Color", fx::VectorType(fx::Scalar::kFloat, 3));
  builder.Parameter("Count", fx::ScalarType(fx::Scalar::kInt));
  builder.Parameter("On", fx::ScalarType(fx::Scalar::kBool));
  builder.Parameter("Matrix", fx::MatrixType(fx::Scalar::kFloat, 2, 2));
  fx::Type array = fx::VectorType(fx::Scalar::kFloat, 2);
  array.array = {2};
  builder.Parameter("Points", array);
  fx::Type text;
  text.kind = fx::TypeKind::kString;
  builder.Parameter("Title", text);
  fx::Type structure;
  structure.kind = fx::TypeKind::kStruct;
  builder.Parameter("Light", structure);
  builder.Texture("Paper", fx::FileRole{});
  builder.Texture("GBAcolor_A8R8G8B8", fx::AttributeRole{"color", false});
  return builder;
}

std::vector<double> Numbers(const std::string& name, const std::string& text) {
  const EffectBuilder builder = Effect();
  const auto overrides = ParseOverrides(builder.effect, {{name, text}});
  EXPECT_TRUE(overrides.has_value()) << overrides.error().message;
  return overrides ? overrides->parameters.begin()->second.numbers : std::vector<double>{};
}

std::string ErrorOf(const std::string& name, const std::string& text) {
  const auto overrides = ParseOverrides(Effect().effect, {{name, text}});
  if (overrides) return "(none)";
  EXPECT_EQ(overrides.error().kind, ErrorKind::kUsage);
  return overrides.error().message;
}

TEST(ParseOverrides, TakesNumbersVectorsMatricesAndArrays) {
  EXPECT_EQ(Numbers("Sigma", "1.5e-1"), (std::vector<double>{0.15}));
  EXPECT_EQ(Numbers("Sigma", " +2 "), (std::vector<double>{2}));
  EXPECT_EQ(Numbers("Color", "1,0.5,0"), (std::vector<double>{1, 0.5, 0}));
  EXPECT_EQ(Numbers("Color", "1, 0.5, -0"), (std::vector<double>{1, 0.5, 0}));
  EXPECT_EQ(Numbers("Color", "1 .5 0"), (std::vector<double>{1, 0.5, 0}));
  EXPECT_EQ(Numbers("Matrix", "1,2,3,4"), (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(Numbers("Points", "1,2,3,4"), (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(Numbers("Count", "-3"), (std::vector<double>{-3}));
}

TEST(ParseOverrides, TakesPartsOfParameters) {
  EffectBuilder builder = Effect();
  fx::ast::Struct light;
  for (const char* name : {"Color", "Power"}) {
    auto member = std::make_unique<fx::ast::Variable>();
    member->name = name;
    member->type = name[0] == 'C' ? fx::VectorType(fx::Scalar::kFloat, 3) : fx::ScalarType(fx::Scalar::kInt);
    light.members.push_back(std::move(member));
  }
  light.components = 4;
  fx::Type type;
  type.kind = fx::TypeKind::kStruct;
  type.structure = &light;
  type.array = {2};
  builder.Parameter("Lights", type).default_value.numbers = {1, 1, 1, 5, 2, 2, 2, 6};
  const auto numbers = [&](const Settings& settings) {
    const auto overrides = ParseOverrides(builder.effect, settings);
    EXPECT_TRUE(overrides.has_value()) << overrides.error().message;
    return overrides ? overrides->parameters.begin()->second.numbers : std::vector<double>{};
  };
  const auto error = [&](const std::string& name, const std::string& text) {
    const auto overrides = ParseOverrides(builder.effect, {{name, text}});
    return overrides ? std::string("(none)") : overrides.error().message;
  };
  EXPECT_EQ(numbers({{"Lights[1].Color", "7,8,9"}}), (std::vector<double>{1, 1, 1, 5, 7, 8, 9, 6}));
  EXPECT_EQ(numbers({{"Lights[0]", "7,8,9,3"}, {"Lights[1].Power", "4"}}),
            (std::vector<double>{7, 8, 9, 3, 2, 2, 2, 4}));
  EXPECT_EQ(numbers({{"Lights", "1,2,3,4,5,6,7,8"}}), (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(numbers({{"Points[1]", "3,4"}}), (std::vector<double>{0, 0, 3, 4}));
  const std::string name = fx::ToString(type);
  EXPECT_EQ(error("Lights[2]", "1"),
            "parameter 'Lights[2]' of test.fx (" + name + "): there is no element 2: it has 2");
  EXPECT_EQ(error("Lights[0].Colour", "1"), "parameter 'Lights[0].Colour' of test.fx (" + name +
                                                "): there is no member 'Colour'; did you mean 'Color'?");
  EXPECT_EQ(error("Lights[0].Power", "1.5"),
            "parameter 'Lights[0].Power' of test.fx (" + name + "): '1.5' is not a whole number");
  EXPECT_EQ(error("Lights[x]", "1"), "parameter 'Lights[x]' of test.fx (" + name + "): '[x]' is no index");
  EXPECT_EQ(error("Sigma.x", "1"), "parameter 'Sigma.x' of test.fx (float): a float has no members");
  EXPECT_EQ(error("Sigma[0]", "1"), "parameter 'Sigma[0]' of test.fx (float): a float has no elements");
}

TEST(ParseOverrides, TakesBoolsInWords) {
  for (const char* text : {"true", "1", "YES", "on"}) EXPECT_EQ(Numbers("On", text), (std::vector<double>{1})) << text;
  for (const char* text : {"false", "0", "No", "off"}) EXPECT_EQ(Numbers("On", text), (std::vector<double>{0})) << text;
}

TEST(ParseOverrides, TakesTextsAndFiles) {
  const EffectBuilder builder = Effect();
  const auto overrides =
      ParseOverrides(builder.effect, {{"Title", "a, b"}, {"Paper", "one.png"}, {"Paper", "two.png"}});
  ASSERT_TRUE(overrides.has_value());
  EXPECT_EQ(overrides->parameters.at(6).strings, (std::vector<std::string>{"a, b"}));
  EXPECT_EQ(overrides->textures.at(0), "two.png");
}

TEST(ParseOverrides, RefusesWrongCounts) {
  EXPECT_EQ(ErrorOf("Color", "1,2"), "parameter 'Color' of test.fx (float3): expected 3 numbers, found 2");
  EXPECT_EQ(ErrorOf("Sigma", "1,2"), "parameter 'Sigma' of test.fx (float): expected 1 number, found 2");
  EXPECT_EQ(ErrorOf("Sigma", ""), "parameter 'Sigma' of test.fx (float): expected 1 number, found 0");
  EXPECT_EQ(ErrorOf("Color", "1,,2"), "parameter 'Color' of test.fx (float3): '' is not a number");
}

TEST(ParseOverrides, RefusesWrongTypes) {
  EXPECT_EQ(ErrorOf("Sigma", "soft"), "parameter 'Sigma' of test.fx (float): 'soft' is not a number");
  EXPECT_EQ(ErrorOf("Sigma", "1.5x"), "parameter 'Sigma' of test.fx (float): '1.5x' is not a number");
  EXPECT_EQ(ErrorOf("Sigma", "nan"), "parameter 'Sigma' of test.fx (float): 'nan' is not a number");
  EXPECT_EQ(ErrorOf("Sigma", "1e300"), "parameter 'Sigma' of test.fx (float): '1e300' is out of range");
  EXPECT_EQ(ErrorOf("Count", "1.5"), "parameter 'Count' of test.fx (int): '1.5' is not a whole number");
  EXPECT_EQ(ErrorOf("Count", "3000000000"), "parameter 'Count' of test.fx (int): '3000000000' is out of range");
  EXPECT_EQ(ErrorOf("On", "2"), "parameter 'On' of test.fx (bool): '2' is neither true nor false");
  EXPECT_NE(ErrorOf("Light", "1").find("values of this type cannot be set"), std::string::npos);
}

TEST(ParseOverrides, RefusesUnknownNamesAndSuggestsNearOnes) {
  EXPECT_EQ(ErrorOf("Sigmas", "1"), "test.fx has no parameter 'Sigmas'; did you mean 'Sigma'?");
  EXPECT_EQ(
      ErrorOf("Temperature", "1"),
      "test.fx has no parameter 'Temperature'; it has Sigma, Color, Count, On, Matrix, Points, Title, Light, Paper");
  EXPECT_EQ(ErrorOf("GBAcolor_A8R8G8B8", "x.png"),
            "texture 'GBAcolor_A8R8G8B8' of test.fx is rendered and takes no file");
  EXPECT_EQ(ErrorOf("Paper", ""), "texture 'Paper' of test.fx: no file named");
}

TEST(RangeWarnings, NameWhatIsOutsideTheEffectsLimits) {
  EffectBuilder builder;
  const auto number = [](const std::string& name, std::vector<double> numbers) {
    return fx::EffectAnnotation{name, {fx::ScalarType(fx::Scalar::kFloat), std::move(numbers), {}}};
  };
  builder.Parameter("Glow", fx::ScalarType(fx::Scalar::kFloat)).annotations = {number("uimin", {0}),
                                                                               number("UIMax", {2})};
  builder.Parameter("Free", fx::ScalarType(fx::Scalar::kFloat));
  builder.Parameter("Tint", fx::VectorType(fx::Scalar::kFloat, 2)).annotations = {number("ui_max", {1, 4})};
  const auto warnings = [&](const std::string& name, const std::string& value) {
    const auto overrides = ParseOverrides(builder.effect, {{name, value}});
    return overrides ? RangeWarnings(builder.effect, *overrides) : std::vector<std::string>{"?"};
  };
  EXPECT_TRUE(warnings("Glow", "2").empty());
  EXPECT_TRUE(warnings("Free", "99").empty());
  EXPECT_TRUE(warnings("Tint", "1,3").empty());
  EXPECT_EQ(warnings("Glow", "2.5"),
            std::vector<std::string>{"test.fx: parameter 'Glow' is 2.5, above its greatest 2"});
  EXPECT_EQ(warnings("Glow", "-1"), std::vector<std::string>{"test.fx: parameter 'Glow' is -1, below its least 0"});
  EXPECT_EQ(warnings("Tint", "0,5"), std::vector<std::string>{"test.fx: parameter 'Tint' is 5, above its greatest 4"});
}

}  // namespace
}  // namespace burin::effect
