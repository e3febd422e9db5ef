// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/compile_effect.h"

namespace burin::fx {
namespace {

using test::Compile;
using test::Messages;

const char kShaders[] =
    "float4 VS(float4 p : POSITION, float2 t : TEXCOORD0, out float2 o : TEXCOORD0) : POSITION { o = t; return p; }\n"
    "float4 One() : COLOR { return 1; }\n";

std::string Reading(const std::string& texture) {
  return "texture " + texture + ";\nsampler s_" + texture + " = sampler_state { Texture = <" + texture +
         ">; };\nfloat4 PS_" + texture + "(float2 t : TEXCOORD0) : COLOR { return tex2D(s_" + texture + ", t); }\n";
}

TEST(Effect, ThePapersFigure2IsWholeAndValid) {
  DiskFileSystem files;
  Options options;
  options.attributes = test::Attributes();
  const CompileResult result = CompileEffect(test::DataFile("figure2.fx"), files, options);
  ASSERT_TRUE(result.effect) << Messages(result);
  EXPECT_EQ(Messages(result), "113:26: warning: implicit truncation of vector type from 'float4' to 'float' [X3206]\n");
  const Effect& effect = *result.effect;
  EXPECT_TRUE(effect.uses_extension);
  ASSERT_EQ(effect.parameters.size(), 3u);
  EXPECT_EQ(effect.parameters[0].name, "TexelSize");
  EXPECT_FALSE(effect.parameters[0].has_default);
  EXPECT_EQ(effect.parameters[1].default_value.numbers, std::vector<double>{0.09});
  ASSERT_EQ(effect.textures.size(), 2u);
  EXPECT_EQ(std::get<AttributeRole>(effect.textures[0].role).attribute, "intensity");
  EXPECT_EQ(std::get<PassResultRole>(effect.textures[1].role).pass, 0);
  ASSERT_EQ(effect.techniques.size(), 1u);
  ASSERT_EQ(effect.techniques[0].passes.size(), 2u);
  const Pass& first = effect.techniques[0].passes[0];
  EXPECT_EQ(first.targets, std::vector<std::size_t>{1});
  EXPECT_EQ(first.program.vertex_entry, "VSEdgeFilter");
  EXPECT_EQ(first.program.fragment_entry, "PSEdgeFilter");
  EXPECT_EQ(first.program.samplers, std::vector<std::size_t>{0});
  EXPECT_EQ(first.program.parameters, (std::vector<std::size_t>{0, 1}));
  EXPECT_THAT(first.program.vertex_inputs, testing::ElementsAre("POSITION0", "TEXCOORD0", "TEXCOORD1"));
  EXPECT_EQ(first.program.targets, 1);
  const Pass& second = effect.techniques[0].passes[1];
  EXPECT_TRUE(second.targets.empty());
  EXPECT_EQ(second.program.samplers, std::vector<std::size_t>{1});
  EXPECT_EQ(first.program.vertex_glsl.find("burin_pixel_offset"), std::string::npos)
      << "texel meets pixel in the extension";
}

TEST(Effect, ParametersKeepTypesSemanticsAndAnnotations) {
  const CompileResult result = Compile(
      "float4x4 wvp : WorldViewProjection;\n"
      "float Script : STANDARDSGLOBAL < string UIWidget = \"none\"; float2 Range = { 0, 1 }; int Order = 1 + 1; > = "
      "0.8;\n"
      "string Title = \"a\" \"b\";\nstatic float no; const float promised = 1; const float table[2] = { 1, "
      "2 }; shared float yes;");
  ASSERT_TRUE(result.effect) << Messages(result);
  const auto& parameters = result.effect->parameters;
  ASSERT_EQ(parameters.size(), 5u);
  EXPECT_EQ(parameters[0].semantic, "WorldViewProjection");
  EXPECT_EQ(FindAnnotation(parameters[1].annotations, "uiwidget")->value.strings, std::vector<std::string>{"none"});
  EXPECT_EQ(FindAnnotation(parameters[1].annotations, "RANGE")->value.numbers, (std::vector<double>{0, 1}));
  EXPECT_EQ(FindAnnotation(parameters[1].annotations, "Order")->value.numbers, std::vector<double>{2});
  EXPECT_EQ(FindAnnotation(parameters[1].annotations, "other"), nullptr);
  EXPECT_EQ(parameters[2].default_value.strings, std::vector<std::string>{"ab"});
  EXPECT_EQ(parameters[3].name, "promised");
  EXPECT_EQ(parameters[4].name, "yes");
}

TEST(Effect, TexturesOfFilesKnowTheirFileAndDimension) {
  const CompileResult result = Compile(
      "texture a < string ResourceName = \"a.dds\"; string ResourceType = \"CUBE\"; >;\n"
      "texture b < string name = \"b.png\"; >;\ntexture c;\nsampler3D s = sampler_state { Texture = <c>; };\n"
      "texture d;\nsampler u = sampler_state { Texture = <d>; };\nfloat4 PS(float3 t : TEXCOORD0) : COLOR { return "
      "texCUBE(u, t); }\n"
      "technique T { pass P { PixelShader = compile ps_2_0 PS(); } }");
  ASSERT_TRUE(result.effect) << Messages(result);
  const auto& textures = result.effect->textures;
  EXPECT_EQ(std::get<FileRole>(textures[0].role).file, "a.dds");
  EXPECT_EQ(textures[0].dimension, Dimension::kCube);
  EXPECT_EQ(std::get<FileRole>(textures[1].role).file, "b.png");
  EXPECT_EQ(textures[1].dimension, Dimension::k2D);
  EXPECT_EQ(textures[2].dimension, Dimension::k3D);
  EXPECT_EQ(textures[3].dimension, Dimension::kCube) << "an untyped sampler takes its dimension from its use";
  EXPECT_FALSE(result.effect->uses_extension);
  EXPECT_EQ(result.effect->techniques[0].passes[0].program.vertex_glsl.find("burin_pixel_offset"), std::string::npos)
      << "the host's quadrilateral is right as it comes";
}

TEST(Effect, AUsesOwnTechniqueMakesACustomAttribute) {
  const CompileResult result = Compile(
      std::string(kShaders) + Reading("GBAheat_R16F") +
      "technique Main { pass P { PixelShader = compile ps_2_0 PS_GBAheat_R16F(); } }\n"
      "technique GBAheat { pass P { VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 One(); } }");
  ASSERT_TRUE(result.effect) << Messages(result);
  const auto& role = std::get<AttributeRole>(result.effect->textures[0].role);
  EXPECT_EQ(role.attribute, "heat");
  EXPECT_TRUE(role.is_custom);
  EXPECT_EQ(result.effect->techniques[0].custom_attribute, "");
  EXPECT_EQ(result.effect->techniques[1].custom_attribute, "heat");
}

TEST(DataFlow, APassResultNeedsItsPass) {
  EXPECT_EQ(Messages(std::string(kShaders) + "texture PASS2_L8;\ntechnique T { pass { PixelShader = compile ps_2_0 "
                                             "One(); } pass { PixelShader = compile ps_2_0 One(); } }"),
            "3:9: error: texture 'PASS2_L8': no technique has a pass 2; the last is 1 [B1004]\n");
  EXPECT_EQ(Messages("texture PASS0_L8;"), "1:9: error: texture 'PASS0_L8': no technique has a pass 0 [B1004]\n");
  // Another technique has the pass, the one that reads does not.
  EXPECT_EQ(
      Messages(
          std::string(kShaders) + Reading("PASS1_L8") +
          "technique A { pass { PixelShader = compile ps_2_0 One(); } pass { PixelShader = compile ps_2_0 One(); } }\n"
          "technique B { pass P { PixelShader = compile ps_2_0 PS_PASS1_L8(); } }"),
      "7:20: error: pass 'P' of technique 'B' reads texture 'PASS1_L8', but the technique has no pass 1 [B1004]\n"
      "  4:9: note: through sampler 's_PASS1_L8'\n");
}

TEST(DataFlow, ReadingTheWrittenTextureIsAnError) {
  EXPECT_EQ(Messages(std::string(kShaders) + Reading("PASS0_L8") +
                     "technique T { pass P { PixelShader = compile ps_2_0 PS_PASS0_L8(); } }"),
            "6:20: error: pass 'P' of technique 'T' reads texture 'PASS0_L8', which it writes [B1005]\n"
            "  4:9: note: through sampler 's_PASS0_L8'\n");
  EXPECT_EQ(Messages(std::string(kShaders) + Reading("GBAheat_L8") +
                     "technique GBAheat { pass P { VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 "
                     "PS_GBAheat_L8(); } }"),
            "6:26: error: pass 'P' of technique 'GBAheat' reads texture 'GBAheat_L8', which it writes [B1005]\n"
            "  4:9: note: through sampler 's_GBAheat_L8'\n");
}

TEST(DataFlow, ReadingALaterResultIsAWarning) {
  EXPECT_EQ(Messages(std::string(kShaders) + Reading("PASS1_L8") +
                     "technique T { pass P { PixelShader = compile ps_2_0 PS_PASS1_L8(); } pass Q { PixelShader = "
                     "compile ps_2_0 One(); } }"),
            "6:20: warning: pass 'P' of technique 'T' reads texture 'PASS1_L8' before pass 1 has drawn it [B1010]\n"
            "  4:9: note: through sampler 's_PASS1_L8'\n");
}

TEST(DataFlow, TargetsOfOnePassFitTogether) {
  const std::string technique =
      "float4 Two(out float4 b : COLOR1) : COLOR0 { b = 1; return 0; }\ntechnique T { pass P { PixelShader = compile "
      "ps_2_0 Two(); } pass Q { PixelShader = compile ps_2_0 Two(); } }";
  EXPECT_EQ(Messages("texture PASS0_L8;\ntexture PASS0_R16F;\n" + technique),
            "2:9: error: texture 'PASS0_R16F' takes the same result as 'PASS0_L8': target 0 of pass 0 [B1007]\n  1:9: "
            "note: 'PASS0_L8' was declared here\n");
  EXPECT_EQ(Messages("texture PASS0_L8;\ntexture PASS0_L8_S2_RT1;\n" + technique),
            "2:9: error: texture 'PASS0_L8_S2_RT1' and 'PASS0_L8' are targets of one pass, so they must have one scale "
            "[B1006]\n  1:9: note: 'PASS0_L8' was declared here\n");
  EXPECT_EQ(Messages("texture PASS0_L8_RT1;\n" + technique),
            "1:9: error: texture 'PASS0_L8_RT1' is target 1 of pass 0, which has no target 0 [B1008]\n");
  const CompileResult good = Compile("texture PASS0_R16F_RT1;\ntexture PASS0_L8;\n" + technique);
  ASSERT_TRUE(good.effect) << Messages(good);
  EXPECT_EQ(good.effect->techniques[0].passes[0].targets, (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(good.effect->techniques[0].passes[0].program.targets, 2);
}

TEST(Techniques, WhatThisHostLacksIsAReasonNotAnError) {
  const CompileResult result = Compile(
      std::string(kShaders) +
      "technique A { pass P0 { VertexShader = asm { vs_1_1 mov oPos, v0 }; PixelShader = compile ps_2_0 One(); } }\n"
      "technique B { pass P0 { ColorOp[0] = SelectArg1; } }\n"
      "technique C { pass P0 { PixelShader = compile ps_9_9 One(); } }\n"
      "technique10 D { pass P0 { SetVertexShader(CompileShader(vs_4_0, VS())); } }\n"
      "technique E { pass P0 { GeometryShader = compile gs_4_0 VS(); PixelShader = compile ps_2_0 One(); } }\n"
      "technique F { pass P0 { Lighting = true; PixelShader = compile ps_2_0 One(); } }\n"
      "technique G { }\n"
      "technique I { pass P0 { Lighting = false; SpecularEnable = 0; PixelShader = compile ps_2_0 One(); } }\n"
      "technique H { pass P0 { VertexShader = NULL; PixelShader = compile ps_2_0 One(); GeometryShader = NULL; } }\n");
  ASSERT_TRUE(result.effect) << Messages(result);
  const auto reasons = [&](std::size_t i) { return result.effect->techniques[i].unsupported; };
  using testing::ElementsAre;
  EXPECT_THAT(reasons(0), ElementsAre("pass 'P0': asm shaders"));
  EXPECT_THAT(reasons(1), ElementsAre());
  EXPECT_THAT(reasons(2), ElementsAre("pass 'P0': unknown or unsupported profile 'ps_9_9'"));
  EXPECT_THAT(reasons(3), ElementsAre("technique10 is not supported"));
  EXPECT_THAT(reasons(4), ElementsAre("pass 'P0': GeometryShader"));
  EXPECT_THAT(reasons(5), ElementsAre());
  EXPECT_THAT(reasons(6), ElementsAre("it has no passes"));
  EXPECT_THAT(reasons(7), ElementsAre());
  EXPECT_THAT(reasons(8), ElementsAre());
}

TEST(Techniques, ShadersComeFromVariablesAndArrays) {
  const CompileResult result = Compile(
      "float4 A(float4 p : POSITION) : POSITION { return p; }\nfloat4 B(float4 p : POSITION) : POSITION { return p * "
      "2; }\nfloat4 One() : COLOR { return 1; }\n"
      "int which = 1;\nVertexShader both[2] = { compile vs_2_0 A(), compile vs_2_0 B() };\nPixelShader one = compile "
      "ps_2_0 One();\n"
      "technique T { pass P { VertexShader = (both[which]); PixelShader = (one); } pass Q { VertexShader = (both[0]); "
      "PixelShader = <one>; } "
      "pass R { VertexShader = both[1]; PixelShader = NULL; } }");
  ASSERT_TRUE(result.effect) << Messages(result);
  const auto& passes = result.effect->techniques[0].passes;
  EXPECT_EQ(passes[0].program.vertex_entry, "B");
  EXPECT_EQ(passes[1].program.vertex_entry, "A");
  EXPECT_EQ(passes[1].program.fragment_entry, "One");
  EXPECT_EQ(passes[2].program.fragment_entry, "");
  EXPECT_EQ(passes[2].program.targets, 1);  // the diffuse colour
  EXPECT_EQ(Messages(result), "");
  ASSERT_EQ(passes[0].choices.size(), 2u);
  EXPECT_EQ(passes[0].choices[0].vertex_entry, "A");
  EXPECT_EQ(passes[0].choices[1].vertex_entry, "B");
  EXPECT_EQ(passes[0].vertex_choice.count, 2u);
  EXPECT_NE(passes[0].vertex_choice.index, nullptr);
  EXPECT_EQ(passes[0].pixel_choice.index, nullptr);
  EXPECT_TRUE(passes[1].choices.empty());
}

TEST(Techniques, EntryPointsAreChecked) {
  const std::string prefix =
      "float4 VSMain(float4 p : POSITION, uniform float k) : POSITION { return p * k; }\nfloat4 One() : COLOR { return "
      "1; }\ntechnique T { pass P {\n";
  EXPECT_EQ(Messages(prefix + "VertexShader = compile vs_2_0 VSMian(1); } }"),
            "4:31: error: 'VSMian': entrypoint not found; did you mean 'VSMain'? [X3501]\n");
  EXPECT_EQ(Messages(prefix + "VertexShader = compile vs_2_0 VSMain(); } }"),
            "4:16: error: 'VSMain': entry point takes 1 uniform arguments, found 0 [X3013]\n");
  EXPECT_EQ(Messages(prefix + "VertexShader = compile vs_2_0 VSMain(1, 2); } }"),
            "4:16: error: 'VSMain': entry point takes 1 uniform arguments, found 2 [X3013]\n");
  EXPECT_EQ(Messages(prefix + "VertexShader = compile ps_2_0 VSMain(1); } }"),
            "4:24: error: 'ps_2_0' is no profile of a vertex shader [B1017]\n");
  EXPECT_EQ(Messages(prefix + "VertexShader = compile vs_2_0 One(); } }"),
            "4:16: error: 'One': vertex shader must write POSITION [X4541]\n");
}

TEST(Techniques, SignaturesNeedSemantics) {
  const auto vertex = [](const std::string& function) {
    return Messages(function + "\ntechnique T { pass P { VertexShader = compile vs_2_0 F(); } }");
  };
  const auto pixel = [](const std::string& function) {
    return Messages(function + "\ntechnique T { pass P { PixelShader = compile ps_2_0 F(); } }");
  };
  EXPECT_EQ(vertex("float4 F(float4 p) : POSITION { return p; }"),
            "1:17: error: 'F': input parameter 'p' missing semantics [X3502]\n");
  EXPECT_EQ(pixel("float4 F() { return 1; }"), "1:8: error: 'F': function return value missing semantics [X3503]\n");
  EXPECT_EQ(pixel("struct O { float4 c : COLOR; float4 d; };\nO F() { return (O)0; }"),
            "1:37: error: 'F': output parameter '.d' missing semantics [X3503]\n");
  EXPECT_EQ(vertex("float4 F() : COLOR { return 1; }"),
            "2:39: error: 'F': vertex shader must write POSITION [X4541]\n");
  EXPECT_EQ(pixel("float4 F() : TEXCOORD0 { return 1; }"),
            "1:8: error: 'F': invalid pixel shader output semantic 'TEXCOORD0' [X4502]\n");
  EXPECT_EQ(vertex("float4 F(float4 p : POSITION) : POSITION { clip(p); return p; }"),
            "1:44: error: 'clip' cannot be used in a vertex shader [X4532]\n");
}

TEST(Techniques, OneSamplerIsLookedUpInOneDimension) {
  EXPECT_EQ(Messages("sampler s;\nfloat4 PS(float3 t : TEXCOORD0) : COLOR { return tex2D(s, t.xy) + texCUBE(s, t); }\n"
                     "technique T { pass P { PixelShader = compile ps_2_0 PS(); } }"),
            "2:75: error: sampler 's' is looked up as a samplerCube here and as a sampler2D elsewhere in the same "
            "shader [B1012]\n");
}

}  // namespace
}  // namespace burin::fx
