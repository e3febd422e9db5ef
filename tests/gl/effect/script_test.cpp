// SPDX-License-Identifier: Apache-2.0
// Scripts of NVIDIA's SAS on the device: targets, clears, the source, loops; and the dialects' own rules by value.
#include <string>

#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

constexpr int kSize = 4;

const std::string kHead =
    "texture Scene : RENDERCOLORTARGET < float2 ViewPortRatio = {1, 1}; string Format = \"A8R8G8B8\"; >;\n"
    "sampler2D SceneSampler = sampler_state { texture = <Scene>; };\n"
    "texture Depth : RENDERDEPTHSTENCILTARGET < string Format = \"D24S8\"; >;\n"
    "float4 Ground = {0.2, 0.4, 0.6, 0.8}; float Far = 1;\n"
    "float2 Size : VIEWPORTPIXELSIZE;\n"
    "void VS(float4 p : POSITION, float2 t : TEXCOORD0, out float4 op : POSITION, out float2 ot : TEXCOORD0)\n"
    "{ op = p; ot = t + 0.5 / Size; }\n";

std::string Pass(const std::string& name, const std::string& script, const std::string& shader,
                 const std::string& states = "ZEnable = false;") {
  return "pass " + name + " < string Script = \"" + script + "\"; > { VertexShader = compile vs_2_0 VS(); " + states +
         " PixelShader = compile ps_2_0 " + shader + "; }\n";
}

TEST(Scripts, CopyTheSourceTexelByTexel) {
  const std::string text =
      kHead + "float4 PS(float2 t : TEXCOORD0) : COLOR { return tex2D(SceneSampler, t).bgra; }\n" +
      "technique T < string Script = \"RenderColorTarget0=Scene;ScriptExternal=color;Pass=A;\"; > { " +
      Pass("A", "RenderColorTarget0=;Draw=Buffer;", "PS()") + "}";
  Bench bench(CompileText(text), kSize, kSize);
  const image::Image noise = MakeNoise(kSize, kSize, image::SampleType::kU8, 7);
  bench.Fill("color", noise);
  const PixelMap pixels = bench.RunPixels();
  const auto bytes = noise.As<std::uint8_t>();
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const std::size_t at = static_cast<std::size_t>(y * kSize + x) * 4;
      const auto value = [&](std::size_t i) { return static_cast<float>(bytes[at + i]) / 255.0f; };
      EXPECT_RGBA8(pixels.at(x, y), value(2), value(1), value(0), value(3)) << x << ", " << y;
    }
  }
}

TEST(Scripts, ClearWithTheirParameters) {
  const std::string text =
      kHead + "float4 PS(float2 t : TEXCOORD0) : COLOR { return tex2D(SceneSampler, t); }\n" +
      "technique T < string Script = \"RenderColorTarget0=Scene;ClearSetColor=Ground;Clear=Color;Pass=A;\"; > { " +
      Pass("A", "RenderColorTarget0=;Draw=Buffer;", "PS()") + "}";
  EXPECT_RGBA8(RunText(text, kSize, kSize).at(1, 2), 0.2f, 0.4f, 0.6f, 0.8f);
  EXPECT_RGBA8(RunText(text, kSize, kSize, {{"Ground", "1,0,0,1"}}).at(0, 0), 1, 0, 0, 1);
}

// The quadrilateral lies at depth 0: it passes LESS against 1 and fails against 0.
TEST(Scripts, ClearDepthOfTheBufferThatIsSet) {
  const std::string text =
      kHead + "float4 PS() : COLOR { return 1; }\n" +
      "technique T < string Script = \"RenderDepthStencilTarget=Depth;ClearSetDepth=Far;Clear=Depth;Pass=A;\"; > { " +
      Pass("A", "Draw=Buffer;", "PS()", "ZFunc = Less;") + "}";
  EXPECT_RGBA8(RunText(text, kSize, kSize, {{"Far", "1"}}).at(0, 0), 1, 1, 1, 1);
  EXPECT_RGBA8(RunText(text, kSize, kSize, {{"Far", "0"}}).at(0, 0), 0, 0, 0, 0);
}

TEST(Scripts, LoopsCountTheirTurns) {
  const std::string text =
      kHead + "float Count = 3; float Turn; float4 PS() : COLOR { return (Turn + 1) / 16.0; }\n" +
      "technique T < string Script = \"LoopByCount=Count;LoopGetIndex=Turn;Pass=A;LoopEnd=;\"; > { " +
      Pass("A", "Draw=Buffer;", "PS()", "ZEnable = false; AlphaBlendEnable = true; SrcBlend = One; DestBlend = One;") +
      "}";
  const auto sum = [](int n) { return static_cast<float>(n * (n + 1)) / 32.0f; };
  EXPECT_RGBA8(RunText(text, 1, 1).at(0, 0), sum(3), sum(3), sum(3), sum(3));
  EXPECT_RGBA8(RunText(text, 1, 1, {{"Count", "4"}}).at(0, 0), sum(4), sum(4), sum(4), sum(4));
  EXPECT_RGBA8(RunText(text, 1, 1, {{"Count", "0"}}).at(0, 0), 0, 0, 0, 0);
}

TEST(Scripts, EveryFrameBeginsAnew) {
  const std::string text =
      kHead + "float4 PS(float2 t : TEXCOORD0) : COLOR { return tex2D(SceneSampler, t) + 0.25; }\n" +
      "technique T < string Script = \"Pass=A;Pass=B;\"; > { " + Pass("A", "RenderColorTarget0=;Draw=Buffer;", "PS()") +
      Pass("B", "RenderColorTarget0=Scene;Draw=Buffer;", "PS2()") + "}";
  std::string both = text;
  both.insert(both.find("technique"), "float4 PS2() : COLOR { return 0.5; }\n");
  Bench bench(CompileText(both), 2, 2);
  EXPECT_RGBA8(bench.RunPixels().at(0, 0), 0.25f, 0.25f, 0.25f, 0.25f);
  EXPECT_RGBA8(bench.RunPixels().at(0, 0), 0.25f, 0.25f, 0.25f, 0.25f);
}

TEST(Dialects, ADiffuseColourIsDrawnWithoutAPixelShader) {
  const std::string text =
      "float4 VS(float4 p : POSITION, float2 t : TEXCOORD0, out float4 c : COLOR0) : POSITION { c = float4(1, 0.5, 0.25, "
      "2); return p; }\nfloat4 Plain(float4 p : POSITION) : POSITION { return p; }\n"
      "technique Given { pass { VertexShader = compile vs_2_0 VS(); PixelShader = NULL; } }\n"
      "technique White { pass { VertexShader = compile vs_2_0 Plain(); } }";
  EXPECT_RGBA8(RunText(text, 1, 1).at(0, 0), 1, 0.5f, 0.25f, 1);
  Bench white(CompileText(text), 1, 1, {}, "White");
  EXPECT_RGBA8(white.RunPixels().at(0, 0), 1, 1, 1, 1);
}

TEST(Dialects, SamplersOfArraysAreChosenAsTheShaderRuns) {
  const std::string text =
      "texture GBAcolor_A8R8G8B8; texture GBAnormal_A8R8G8B8;\n"
      "sampler s[2] = { sampler_state { Texture = <GBAcolor_A8R8G8B8>; }, sampler_state { Texture = "
      "<GBAnormal_A8R8G8B8>; } };\nfloat4 PS(float2 t : TEXCOORD0) : COLOR { float4 sum = 0; for (int i = 0; i < 2; "
      "i++) sum += tex2D(s[1 - i], t) * (i == 0 ? 1 : 0.5); return sum; }\n"
      "technique T { pass { PixelShader = compile ps_3_0 PS(); } }";
  Bench bench(CompileText(text), 1, 1);
  bench.Fill("color", MakeImage(1, 1, image::SampleType::kU8, [](int, int) { return Rgba{0.4f, 0, 0, 0.4f}; }));
  bench.Fill("normal", MakeImage(1, 1, image::SampleType::kU8, [](int, int) { return Rgba{0, 0.8f, 0, 0.2f}; }));
  EXPECT_RGBA8(bench.RunPixels().at(0, 0), 0.2f, 0.8f, 0, 0.4f);
}

// A texel of a row of four by its number of pixels.
TEST(Dialects, CgsRectanglesAreLookedUpByPixel) {
  const std::string text =
      "texture GBAcolor_A8R8G8B8; samplerRECT s = sampler_state { Texture = <GBAcolor_A8R8G8B8>; };\n"
      "float4 PS(float2 t : TEXCOORD0) : COLOR { return texRECT(s, float2(2.5, 0.5)); }\n"
      "technique T { pass { FragmentProgram = compile fp40 PS(); } }";
  Bench bench(CompileText(text, "test.cgfx"), 4, 1);
  bench.Fill("color", MakeImage(4, 1, image::SampleType::kU8, [](int x, int) {
               return Rgba{static_cast<float>(x) / 4.0f, 0, 0, 1};
             }));
  EXPECT_RGBA8(bench.RunPixels().at(0, 0), 0.5f, 0, 0, 1);
}

}  // namespace
}  // namespace burin::effect
