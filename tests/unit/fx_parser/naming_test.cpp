// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/naming.h"

#include <gtest/gtest.h>

#include "tests/unit/fx_parser/compile_effect.h"

namespace burin::fx {
namespace {

const std::vector<std::string> kKnown = {"color", "normal", "intensity", "my_attribute"};

ExtensionName Good(const std::string& name) {
  const auto parsed = ParseExtensionName(name, kKnown);
  EXPECT_TRUE(std::holds_alternative<ExtensionName>(parsed))
      << name << ": " << (parsed.index() == 1 ? std::get<NamingError>(parsed).text : "");
  return parsed.index() == 0 ? std::get<ExtensionName>(parsed) : ExtensionName{};
}

std::string Bad(const std::string& name) {
  const auto parsed = ParseExtensionName(name, kKnown);
  return parsed.index() == 1 ? std::get<NamingError>(parsed).text + " [" + std::get<NamingError>(parsed).code + "]"
                             : "accepted";
}

TEST(Naming, EveryFormatIsFoundWithoutCase) {
  int index = 0;
  for (const FormatInfo& info : AllFormats()) {
    EXPECT_EQ(static_cast<int>(info.format), index++);
    EXPECT_EQ(Good("GBAcolor_" + std::string(info.name)).format, info.format);
    EXPECT_EQ(&Info(info.format), &info);
  }
  EXPECT_EQ(index, 17);
  EXPECT_EQ(Good("GBAcolor_a8r8g8b8").format, Format::kA8R8G8B8);
}

TEST(Naming, AttributesHaveScales) {
  const ExtensionName plain = Good("GBAnormal_A16B16G16R16F");
  EXPECT_EQ(std::get<AttributeRole>(plain.role).attribute, "normal");
  EXPECT_EQ(plain.scale, 1.0);
  EXPECT_EQ(Good("GBAcolor_A8R8G8B8_S3").scale, 3.0);
  EXPECT_EQ(Good("GBAcolor_A8R8G8B8_s0_5").scale, 0.5);
  EXPECT_DOUBLE_EQ(Good("GBAcolor_A8R8G8B8_S2_25").scale, 2.25);
  EXPECT_EQ(std::get<AttributeRole>(Good("GBACOLOR_L8").role).attribute, "color");
  EXPECT_EQ(std::get<AttributeRole>(Good("GBAmy_attribute_L8_S2").role).attribute, "my_attribute");
}

TEST(Naming, PassResultsHaveTargets) {
  const auto role = std::get<PassResultRole>(Good("PASS12_R16F_S0_5_RT3").role);
  EXPECT_EQ(role.pass, 12);
  EXPECT_EQ(role.target, 3);
  EXPECT_EQ(std::get<PassResultRole>(Good("PASS0_R16F_rt1_S2").role).target, 1);
  EXPECT_EQ(Good("PASS0_R16F_RT1_S2").scale, 2.0);
}

TEST(Naming, FaultsAreNamed) {
  EXPECT_EQ(Bad("GBAcolour_A8R8G8B8"),
            "texture 'GBAcolour_A8R8G8B8': unknown attribute 'colour'; did you mean 'color'? [B1001]");
  EXPECT_EQ(Bad("GBAcolor_A8R8G8B9"),
            "texture 'GBAcolor_A8R8G8B9': unknown format 'A8R8G8B9'; did you mean 'A8R8G8B8'? [B1002]");
  EXPECT_EQ(Bad("GBAcolor_"), "texture 'GBAcolor_': unknown format '' [B1002]");
  EXPECT_EQ(Bad("GBAcolor"), "texture 'GBAcolor' names no format: expected GBA<attribute>_<FORMAT> [B1003]");
  EXPECT_EQ(Bad("PASS1"), "texture 'PASS1' names no format: expected PASS<k>_<FORMAT> [B1003]");
  EXPECT_EQ(Bad("PASS1x_L8"),
            "texture 'PASS1x_L8': '1x' is no pass number: expected PASS<k>_<FORMAT> with k from 0 to 999 [B1003]");
  EXPECT_EQ(Bad("GBAcolor_L8_Sx"), "texture 'GBAcolor_L8_Sx': malformed scale '_Sx': expected _S3 or _S0_5 [B1003]");
  EXPECT_EQ(Bad("GBAcolor_L8_S"), "texture 'GBAcolor_L8_S': malformed scale '_S': expected _S3 or _S0_5 [B1003]");
  EXPECT_EQ(Bad("GBAcolor_L8_S0"), "texture 'GBAcolor_L8_S0': the scale must be above 0 and at most 16 [B1003]");
  EXPECT_EQ(Bad("GBAcolor_L8_S17"), "texture 'GBAcolor_L8_S17': the scale must be above 0 and at most 16 [B1003]");
  EXPECT_EQ(Bad("GBAcolor_L8_RT1"),
            "texture 'GBAcolor_L8_RT1': only pass results have render targets, so '_RT1' has no place here [B1003]");
  EXPECT_EQ(Bad("PASS0_L8_RT8"), "texture 'PASS0_L8_RT8': render target 8 is too high: the last is 7 [B1003]");
  EXPECT_EQ(Bad("PASS0_L8_S2_S2"),
            "texture 'PASS0_L8_S2_S2': unexpected '_S2': expected _S<scale> or _RT<target> once [B1003]");
  EXPECT_EQ(Bad("PASS99999999999999_L8"),
            "texture 'PASS99999999999999_L8': '99999999999999' is no pass number: expected PASS<k>_<FORMAT> with k "
            "from 0 to 999 [B1003]");
}

TEST(Naming, OtherNamesAreLeftAlone) {
  for (const char* name : {"color", "PASSAGE_L8", "PASS_L8", "GBA", "GBA_L8", "gbacolor_L8", "pass0_L8", "GBA1_L8"}) {
    EXPECT_FALSE(IsExtensionName(name)) << name;
  }
  EXPECT_TRUE(IsExtensionName("GBAcolor_L8"));
  EXPECT_TRUE(IsExtensionName("PASS0"));
}

TEST(Naming, ErrorsHaveTheirPlace) {
  EXPECT_EQ(test::Messages("texture GBAdepht_R32F;\ntexture PASS0_A8R8;\nfloat4 PS() : COLOR { return 0; }\n"
                           "technique T { pass P { PixelShader = compile ps_2_0 PS(); } }"),
            "1:9: error: texture 'GBAdepht_R32F': unknown attribute 'depht'; did you mean 'depth'? [B1001]\n"
            "2:9: error: texture 'PASS0_A8R8': unknown format 'A8R8'; did you mean 'A8L8'? [B1002]\n");
}

}  // namespace
}  // namespace burin::fx
