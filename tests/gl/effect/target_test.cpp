// SPDX-License-Identifier: Apache-2.0
// Attributes and pass results: sizes, several targets, what is kept and what is cleared.
#include <string>

#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

const std::string kLinear = "technique T < string ColorSpace = \"linear\"; > ";

TEST(Target, ScaledAttributesHaveRoundedSizes) {
  const std::string text =
      "texture GBAcolor_A8R8G8B8_S3; texture GBAnormal_A8R8G8B8_S0_5; texture GBAdepth_R32F_S0_01;\n"
      "sampler a = sampler_state { Texture = <GBAcolor_A8R8G8B8_S3>; };\n"
      "sampler b = sampler_state { Texture = <GBAnormal_A8R8G8B8_S0_5>; };\n"
      "sampler c = sampler_state { Texture = <GBAdepth_R32F_S0_01>; };\n"
      "float4 TexelSize; float4 TexelSize_GBAcolor_A8R8G8B8_S3; float4 TexelSize_GBAnormal_A8R8G8B8_S0_5;\n"
      "float4 Ps(float2 uv : TEXCOORD0) : COLOR { return float4(1 / TexelSize.x, 1 / TexelSize_GBAcolor_A8R8G8B8_S3.xy, "
      "1 / TexelSize_GBAnormal_A8R8G8B8_S0_5.y) + 0 * (tex2D(a, uv) + tex2D(b, uv) + tex2D(c, uv)); }\n" +
      kLinear + "{ pass P { PixelShader = compile ps_2_0 Ps(); } }";
  Bench bench(CompileText(text), 17, 11);
  ASSERT_TRUE(bench.runner);
  ASSERT_EQ(bench.runner->attributes().size(), 3u);
  const auto& attributes = bench.runner->attributes();
  EXPECT_EQ(attributes[0].texture->width(), 51);
  EXPECT_EQ(attributes[0].texture->height(), 33);
  EXPECT_EQ(attributes[1].texture->width(), 9);
  EXPECT_EQ(attributes[1].texture->height(), 6);
  EXPECT_EQ(attributes[2].texture->width(), 1);
  EXPECT_EQ(attributes[2].texture->height(), 1);
  EXPECT_TRUE(Near(bench.RunPixels().at(0, 0), {17, 51, 33, 6}, 1e-4f));
}

TEST(Target, ColourAttributesAreEncodedByTheirFormat) {
  const std::string text =
      "texture GBAcolor_A8R8G8B8; texture GBAalbedo_A16B16G16R16F;\n"
      "sampler a = sampler_state { Texture = <GBAcolor_A8R8G8B8>; }; sampler b = sampler_state { Texture = "
      "<GBAalbedo_A16B16G16R16F>; };\nfloat4 Ps(float2 uv : TEXCOORD0) : COLOR { return tex2D(a, uv) + tex2D(b, uv); }\n";
  const std::string pass = "{ pass P { PixelShader = compile ps_2_0 Ps(); } }";
  Bench plain(CompileText(text + "technique T " + pass), 1, 1);
  ASSERT_TRUE(plain.runner);
  EXPECT_EQ(plain.runner->frame_encoding(), image::Encoding::kDisplay);
  EXPECT_EQ(plain.runner->attributes()[0].encoding, image::Encoding::kDisplay);
  EXPECT_EQ(plain.runner->attributes()[1].encoding, image::Encoding::kSceneLinear);
  Bench linear(CompileText(text + kLinear + pass), 1, 1);
  ASSERT_TRUE(linear.runner);
  EXPECT_EQ(linear.runner->frame_encoding(), image::Encoding::kSceneLinear);
  EXPECT_EQ(linear.runner->attributes()[0].encoding, image::Encoding::kSceneLinear);
}

TEST(Target, OnlyAttributesThatTheTechniqueReadsAreAskedFor) {
  const std::string text =
      "texture GBAcolor_A8R8G8B8; texture GBAnormal_A8R8G8B8;\n"
      "sampler a = sampler_state { Texture = <GBAcolor_A8R8G8B8>; }; sampler b = sampler_state { Texture = "
      "<GBAnormal_A8R8G8B8>; };\nfloat4 A(float2 uv : TEXCOORD0) : COLOR { return tex2D(a, uv); }\n"
      "float4 B(float2 uv : TEXCOORD0) : COLOR { return tex2D(b, uv); }\n"
      "technique One { pass P { PixelShader = compile ps_2_0 A(); } }\n"
      "technique Two { pass P { PixelShader = compile ps_2_0 B(); } }";
  Bench bench(CompileText(text), 1, 1, {}, "Two");
  ASSERT_TRUE(bench.runner);
  ASSERT_EQ(bench.runner->attributes().size(), 1u);
  EXPECT_EQ(bench.runner->attributes()[0].attribute, "normal");
}

TEST(Target, AnyLaterPassReadsEarlierResults) {
  const std::string text =
      "texture PASS0_A32B32G32R32F; texture PASS1_A32B32G32R32F;\n"
      "sampler a = sampler_state { Texture = <PASS0_A32B32G32R32F>; }; sampler b = sampler_state { Texture = "
      "<PASS1_A32B32G32R32F>; };\nfloat4 P0(float2 uv : TEXCOORD0) : COLOR { return float4(uv, 1, 2); }\n"
      "float4 P1(float2 uv : TEXCOORD0) : COLOR { return tex2D(a, uv) * 10; }\n"
      "float4 P2(float2 uv : TEXCOORD0) : COLOR { return tex2D(a, uv) + tex2D(b, uv); }\n" +
      kLinear +
      "{ pass A { PixelShader = compile ps_2_0 P0(); } pass B { PixelShader = compile ps_2_0 P1(); } pass C { PixelShader = "
      "compile ps_2_0 P2(); } }";
  EXPECT_RGBA(RunText(text, 2, 2).at(1, 0), 8.25f, 2.75f, 11, 22);
}

TEST(Target, OnePassDrawsIntoSeveralTargetsOfDifferentFormats) {
  const std::string text =
      "texture PASS0_A8R8G8B8; texture PASS0_R32F_RT1; texture PASS0_A16B16G16R16F_RT2;\n"
      "sampler a = sampler_state { Texture = <PASS0_A8R8G8B8>; }; sampler b = sampler_state { Texture = <PASS0_R32F_RT1>; };\n"
      "sampler c = sampler_state { Texture = <PASS0_A16B16G16R16F_RT2>; };\n"
      "struct Out { float4 a : COLOR0; float4 b : COLOR1; float4 c : COLOR2; };\n"
      "Out Write() { Out o; o.a = float4(1, 0, 0, 1); o.b = 1000; o.c = float4(-1, -2, -3, -4); return o; }\n"
      "float4 Read(float2 uv : TEXCOORD0) : COLOR { return float4(tex2D(a, uv).r, tex2D(b, uv).r, tex2D(c, uv).ga); }\n" +
      kLinear + "{ pass A { PixelShader = compile ps_2_0 Write(); } pass B { PixelShader = compile ps_2_0 Read(); } }";
  EXPECT_RGBA(RunText(text, 1, 1).at(0, 0), 1, 1000, -2, -4);
}

TEST(Target, EachOfSeveralTargetsHasItsWriteMask) {
  const std::string text =
      "texture PASS0_A8R8G8B8; texture PASS0_A8R8G8B8_RT1;\n"
      "sampler a = sampler_state { Texture = <PASS0_A8R8G8B8>; }; sampler b = sampler_state { Texture = "
      "<PASS0_A8R8G8B8_RT1>; };\nstruct Out { float4 a : COLOR0; float4 b : COLOR1; };\n"
      "Out Write() { Out o; o.a = 1; o.b = 1; return o; }\n"
      "float4 Read(float2 uv : TEXCOORD0) : COLOR { return float4(tex2D(a, uv).rg, tex2D(b, uv).rg); }\n" +
      kLinear +
      "{ pass A { ColorWriteEnable = Red; ColorWriteEnable1 = Green; PixelShader = compile ps_2_0 Write(); } pass B { "
      "PixelShader = compile ps_2_0 Read(); } }";
  EXPECT_RGBA(RunText(text, 1, 1).at(0, 0), 1, 0, 0, 1);
}

TEST(Target, EveryFrameStartsFromTheSameContent) {
  // Pass 1 looks up the result of pass 2, which is drawn later: 0 in every frame.
  const std::string text =
      "float Time;\ntexture PASS0_A32B32G32R32F; texture PASS1_A32B32G32R32F;\n"
      "sampler a = sampler_state { Texture = <PASS0_A32B32G32R32F>; }; sampler b = sampler_state { Texture = "
      "<PASS1_A32B32G32R32F>; };\nfloat4 P0(float2 uv : TEXCOORD0) : COLOR { return tex2D(b, uv) + Time; }\n"
      "float4 P1(float2 uv : TEXCOORD0) : COLOR { return 5; }\n"
      "float4 P2(float2 uv : TEXCOORD0) : COLOR { return float4(tex2D(a, uv).x, tex2D(b, uv).x, 0, 1); }\n" +
      kLinear +
      "{ pass A { AlphaBlendEnable = true; SrcBlend = One; DestBlend = One; PixelShader = compile ps_2_0 P0(); } pass B { "
      "PixelShader = compile ps_2_0 P1(); } pass C { PixelShader = compile ps_2_0 P2(); } }";
  Bench bench(CompileText(text), 1, 1);
  for (const double time : {1.0, 2.0, 1.0}) {
    bench.context.time_s = time;
    EXPECT_RGBA(bench.RunPixels().at(0, 0), static_cast<float>(time), 5, 0, 1);
  }
}

TEST(Target, TargetsOfOneSizeShareDepthAndThoseOfAnotherHaveTheirOwn) {
  const auto result = [](const std::string& scale) {
    const std::string name = "PASS0_A8R8G8B8" + scale;
    return RunText("texture " + name + ";\nsampler a = sampler_state { Texture = <" + name + ">; };\n"
                   "float4 At(float4 p : POSITION, uniform float z) : POSITION { return float4(p.xy, z, 1); }\n"
                   "float4 P0() : COLOR { return 1; }\nfloat4 P1() : COLOR { return float4(1, 2, 3, 4); }\n" +
                       kLinear +
                       "{ pass A { VertexShader = compile vs_2_0 At(0.25); PixelShader = compile ps_2_0 P0(); }"
                       " pass B { VertexShader = compile vs_2_0 At(0.5); PixelShader = compile ps_2_0 P1(); } }",
                   2, 2)
        .at(0, 0);
  };
  EXPECT_RGBA(result(""), 0, 0, 0, 0);
  EXPECT_RGBA(result("_S2"), 1, 2, 3, 4);
}

TEST(Technique, OneThatTheDriverRefusesGivesWayToTheNext) {
  const auto compiled = CompileText(
      "float4 A() : COLOR { return 1; } float4 B() : COLOR { return 2; }\n"
      "technique First < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_2_0 A(); } }\n"
      "technique Second < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_2_0 B(); } }");
  ASSERT_TRUE(compiled);
  auto broken = std::make_shared<fx::Effect>(*compiled);
  broken->techniques[0].passes[0].program.fragment_glsl = "#version 450 core\nno shader\n";
  Bench bench(broken, 1, 1);
  ASSERT_TRUE(bench.runner);
  EXPECT_RGBA(bench.RunPixels().at(0, 0), 2, 2, 2, 2);
  ASSERT_EQ(bench.runner->choice().rejected.size(), 1u);
  EXPECT_EQ(bench.runner->choice().rejected[0].first, "First");
  // The one that was asked for has no substitute.
  RunnerOptions options;
  options.technique = "First";
  options.width = options.height = 1;
  options.display_frame_format = options.linear_frame_format = gl::PlainFormat(gl::Numeric::kUnorm, 8, 4);
  EXPECT_FALSE(EffectRunner::Create(broken, options).has_value());
}

TEST(Target, OneTooLargeForTheDeviceIsAnErrorThatNamesIt) {
  const auto effect = CompileText(
      "texture GBAcolor_A8R8G8B8_S16; sampler a = sampler_state { Texture = <GBAcolor_A8R8G8B8_S16>; };\n"
      "float4 P(float2 uv : TEXCOORD0) : COLOR { return tex2D(a, uv); }\ntechnique T { pass A { PixelShader = compile ps_2_0 "
      "P(); } }");
  ASSERT_TRUE(effect);
  RunnerOptions options;
  options.width = options.height = 4096;
  options.display_frame_format = options.linear_frame_format = gl::PlainFormat(gl::Numeric::kUnorm, 8, 4);
  const auto runner = EffectRunner::Create(effect, options);
  ASSERT_FALSE(runner.has_value());
  EXPECT_NE(runner.error().message.find("GBAcolor_A8R8G8B8_S16"), std::string::npos) << runner.error().message;
  EXPECT_NE(runner.error().message.find("65536x65536"), std::string::npos) << runner.error().message;
}

}  // namespace
}  // namespace burin::effect
