// SPDX-License-Identifier: Apache-2.0
// Scripts of NVIDIA's SAS on the device: targets, clears, the source, loops; and the dialects' own rules by value.
#include <cmath>
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
      kHead + "float Count = 3; float Turn; float4 PS() : COLOR { return (Turn + 1) * 5 / 255.0; }\n" +
      "technique T < string Script = \"LoopByCount=Count;LoopGetIndex=Turn;Pass=A;LoopEnd=;\"; > { " +
      Pass("A", "Draw=Buffer;", "PS()", "ZEnable = false; AlphaBlendEnable = true; SrcBlend = One; DestBlend = One;") +
      "}";
  const auto sum = [](int n) { return static_cast<float>(n * (n + 1) / 2 * 5) / 255.0f; };
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
      "float4 VS(float4 p : POSITION, float2 t : TEXCOORD0, out float4 c : COLOR0) : POSITION { c = float4(1, 0.5, "
      "0.25, "
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

// The middle of texel (2, 1) of 4 by 2.
TEST(ProceduralTextures, AreFilledByTexel) {
  const std::string text =
      "texture t < string function = \"Make\"; float2 Dimensions = {4, 2}; >; float Scale = 0.5;\n"
      "sampler s = sampler_state { Texture = <t>; };\n"
      "float4 Make(float2 p : POSITION, float2 size : PSIZE) : COLOR { return float4(p, size) * Scale; }\n"
      "float4 PS() : COLOR { return tex2D(s, float2(0.625, 0.75)); }\n"
      "technique T { pass { PixelShader = compile ps_2_0 PS(); } }";
  EXPECT_RGBA8(RunText(text, 1, 1).at(0, 0), 0.3125f, 0.375f, 0.125f, 0.25f);
  EXPECT_RGBA8(RunText(text, 1, 1, {{"Scale", "1"}}).at(0, 0), 0.625f, 0.75f, 0.25f, 0.5f);
}

TEST(ProceduralTextures, OfVolumesHaveTheirSlices) {
  const std::string text =
      "texture t < string function = \"Make\"; string ResourceType = \"3D\"; int width = 2; int height = 2; int depth "
      "= 4; "
      "string Format = \"A32B32G32R32F\"; >; sampler3D s = sampler_state { Texture = <t>; };\n"
      "float4 Make(float3 p : POSITION, float3 size : PSIZE) : COLOR { return float4(p * 4, size.z); }\n"
      "float4 PS() : COLOR { return tex3D(s, float3(0.25, 0.75, 0.9)) / 4; }\n"
      "technique T { pass { PixelShader = compile ps_2_0 PS(); } }";
  EXPECT_RGBA8(RunText(text, 1, 1).at(0, 0), 0.25f, 0.75f, 0.875f, 0.0625f);
}

// A cube that gives back the direction it is looked up in, on all six faces.
TEST(ProceduralTextures, OfCubesGetDirections) {
  const std::string head =
      "texture t < string function = \"Make\"; string ResourceType = \"Cube\"; int width = 64; "
      "string Format = \"A32B32G32R32F\"; >; samplerCUBE s = sampler_state { Texture = <t>; MinFilter = Linear; "
      "MagFilter = Linear; };\nfloat4 Make(float3 p : POSITION) : COLOR { return float4(normalize(p), 1); }\n"
      "float4 PS(uniform float3 d) : COLOR { return float4(texCUBE(s, d).xyz * 0.5 + 0.5, 1); }\n";
  const std::array<float, 3> directions[] = {{1, 0.3f, -0.2f}, {-1, 0.4f, 0.1f}, {0.2f, 1, -0.3f},
                                             {0.1f, -1, 0.5f}, {-0.4f, 0.3f, 1}, {0.3f, 0.2f, -1}};
  for (const auto& d : directions) {
    const std::string direction =
        "float3(" + std::to_string(d[0]) + ", " + std::to_string(d[1]) + ", " + std::to_string(d[2]) + ")";
    const PixelMap pixels =
        RunText(head + "technique T { pass { PixelShader = compile ps_2_0 PS(" + direction + "); } }", 1, 1);
    const float length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const auto expected = [&](std::size_t i) { return d[i] / length * 0.5f + 0.5f; };
    EXPECT_TRUE(Near(pixels.at(0, 0), {expected(0), expected(1), expected(2), 1}, 0.01f)) << direction;
  }
}

}  // namespace
}  // namespace burin::effect
