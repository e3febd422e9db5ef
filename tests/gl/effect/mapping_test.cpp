// SPDX-License-Identifier: Apache-2.0
// Pixels and texels: one to one, (0,0) at the top left, v downwards, and Direct3D 9's half pixel for files that do not
// use the extension's names.
#include <algorithm>
#include <string>

#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

std::string Copy(const std::string& format, const std::string& coordinate, const std::string& globals = {}) {
  const std::string texture = "GBAcolor_" + format;
  return globals + "float4 TexelSize;\ntexture " + texture + ";\nsampler s = sampler_state { Texture = <" + texture +
         ">; AddressU = Clamp; AddressV = Clamp; };\n"
         "float4 Copy(float2 uv : TEXCOORD0) : COLOR { return tex2D(s, " +
         coordinate +
         "); }\ntechnique T < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_2_0 Copy(); } }";
}

struct Size {
  int width, height;
};
constexpr Size kSizes[] = {{1, 1}, {3, 1}, {1, 7}, {17, 13}, {64, 64}, {101, 57}, {640, 359}, {1021, 3}};

TEST(Mapping, AnIdentityIsBitExactAtEverySize) {
  unsigned seed = 20261;
  for (const Size size : kSizes) {
    for (const auto& [format, type] :
         {std::pair{"A8R8G8B8", image::SampleType::kU8}, std::pair{"A16B16G16R16", image::SampleType::kU16},
          std::pair{"A32B32G32R32F", image::SampleType::kF32}}) {
      SCOPED_TRACE(testing::Message() << format << " " << size.width << "x" << size.height << " seed " << seed);
      const image::Image picture = MakeNoise(size.width, size.height, type, seed++);
      Bench bench(CompileText(Copy(format, "uv")), size.width, size.height);
      bench.Fill("color", picture);
      EXPECT_EQ(bench.RunImage(type).pixels, picture.pixels);
    }
  }
}

TEST(Mapping, EveryTexelSizeSwizzleShiftsByOneTexel) {
  constexpr int kWidth = 19;
  constexpr int kHeight = 11;
  const image::Image picture = MakeImage(kWidth, kHeight, image::SampleType::kF32, [](int x, int y) {
    return Rgba{static_cast<float>(x), static_cast<float>(y), 0, 1};
  });
  struct Case {
    const char* coordinate;
    int x, y;
  };
  for (const Case& tested :
       {Case{"uv + TexelSize.xw", 1, 0}, Case{"uv - TexelSize.xw", -1, 0}, Case{"uv + TexelSize.wy", 0, 1},
        Case{"uv - TexelSize.wy", 0, -1}, Case{"uv + TexelSize.xy", 1, 1}, Case{"uv - TexelSize.xy", -1, -1},
        Case{"uv + TexelSize.zw", 0, 0}}) {
    Bench bench(CompileText(Copy("A32B32G32R32F", tested.coordinate)), kWidth, kHeight);
    bench.Fill("color", picture);
    const PixelMap frame = bench.RunPixels();
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const auto expected_x = static_cast<float>(std::clamp(x + tested.x, 0, kWidth - 1));
        const auto expected_y = static_cast<float>(std::clamp(y + tested.y, 0, kHeight - 1));
        ASSERT_EQ(frame.at(x, y), (Rgba{expected_x, expected_y, 0, 1})) << tested.coordinate << " at " << x << "," << y;
      }
    }
  }
}

TEST(Mapping, TextureCoordinatesStartAtTheTopLeft) {
  const PixelMap frame = RunText(
      "texture GBAcolor_A8R8G8B8;\nfloat4 Uv(float2 uv : TEXCOORD0, float2 last : TEXCOORD7) : COLOR "
      "{ return float4(uv, last); }\ntechnique T < string ColorSpace = \"linear\"; >"
      " { pass P { PixelShader = compile ps_2_0 Uv(); } }",
      4, 2);
  EXPECT_RGBA(frame.at(0, 0), 0.125f, 0.25f, 0.125f, 0.25f);
  EXPECT_RGBA(frame.at(3, 1), 0.875f, 0.75f, 0.875f, 0.75f);
}

TEST(Mapping, PositionsAreInClipSpaceWithYUpwards) {
  const PixelMap frame = RunText(
      "texture GBAcolor_A8R8G8B8;\nstruct V { float4 p : POSITION; float4 q : TEXCOORD0; };\n"
      "V Vs(float4 p : POSITION) { V v; v.p = p; v.q = p; return v; }\n"
      "float4 Ps(V v) : COLOR { return v.q; }\ntechnique T < string ColorSpace = \"linear\"; >"
      " { pass P { VertexShader = compile vs_2_0 Vs(); PixelShader = compile ps_2_0 Ps(); } }",
      2, 2);
  EXPECT_RGBA(frame.at(0, 0), -0.5f, 0.5f, 0, 1);
  EXPECT_RGBA(frame.at(1, 1), 0.5f, -0.5f, 0, 1);
}

TEST(Mapping, VposIsTheIntegerPixel) {
  const PixelMap frame = RunText(
      "float4 P(float2 p : VPOS) : COLOR { return float4(p, 0, 1); }\n"
      "technique T < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_3_0 P(); } }",
      5, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) EXPECT_RGBA(frame.at(x, y), static_cast<float>(x), static_cast<float>(y), 0, 1);
  }
}

TEST(Mapping, DdyGoesDownwards) {
  EXPECT_RGBA(
      RunText(
          "texture GBAcolor_A8R8G8B8;\nfloat4 D(float2 uv : TEXCOORD0) : COLOR { return float4(ddx(uv), ddy(uv)); }\n"
          "technique T < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_3_0 D(); } }",
          4, 8)
          .at(1, 1),
      0.25f, 0, 0, 0.125f);
}

TEST(Mapping, FilesWithoutTheExtensionHaveDirect3DsHalfPixel) {
  const std::string text =
      "void Vs(float4 p : POSITION, float2 uv : TEXCOORD0, out float4 q : POSITION, out float2 v : TEXCOORD0) { q = p; "
      "v = uv; }\nfloat4 Uv(float2 uv : TEXCOORD0) : COLOR { return float4(uv * float2(4, 2), 0, 1); }\n"
      "technique T < string ColorSpace = \"linear\"; > { pass P { VertexShader = compile vs_2_0 Vs(); PixelShader = "
      "compile ps_2_0 Uv(); } }\n"
      "technique Host < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_2_0 Uv(); } }";
  const PixelMap plain = RunText(text, 4, 2);
  // Coordinates at integer pixels, to 1/128: pixel 0 shows the texture's very corner.
  EXPECT_TRUE(Near(plain.at(0, 0), {0, 0, 0, 1}, 1.0f / 64));
  EXPECT_TRUE(Near(plain.at(3, 1), {3, 1, 0, 1}, 1.0f / 64));
  // The quadrilateral of a pass without a vertex shader is right as it comes, as hosts of such files draw it.
  Bench host(CompileText(text), 4, 2, {}, "Host");
  EXPECT_TRUE(Near(host.RunPixels().at(0, 0), {0.5f, 0.5f, 0, 1}, 1e-5f));
  // An effect that subtracts it gets one to one.
  const std::string corrected =
      "struct V { float4 p : POSITION; float2 uv : TEXCOORD0; };\nfloat2 Size : VIEWPORTPIXELSIZE;\n"
      "V Vs(float4 p : POSITION, float2 uv : TEXCOORD0) { V v; v.p = p; v.p.xy -= float2(1, -1) / Size; v.uv = uv; "
      "return v; }\n"
      "float4 Ps(V v) : COLOR { return float4(v.uv * float2(4, 2), 0, 1); }\n"
      "technique T < string ColorSpace = \"linear\"; > { pass P { VertexShader = compile vs_2_0 Vs(); PixelShader = "
      "compile "
      "ps_2_0 Ps(); } }";
  const PixelMap exact = RunText(corrected, 4, 2);
  EXPECT_TRUE(Near(exact.at(0, 0), {0.5f, 0.5f, 0, 1}, 1.0f / 64));
  EXPECT_TRUE(Near(exact.at(3, 1), {3.5f, 1.5f, 0, 1}, 1.0f / 64));
}

TEST(Mapping, AsymmetricKernelsSeeTheRightNeighbours) {
  // A bright texel at (2, 1): the pixel left of it sees it on its right, the one above sees it below.
  const image::Image picture = MakeImage(5, 4, image::SampleType::kF32, [](int x, int y) {
    const float value = x == 2 && y == 1 ? 1.0f : 0.0f;
    return Rgba{value, value, value, 1};
  });
  const std::string text =
      "float4 TexelSize;\ntexture GBAcolor_A32B32G32R32F;\nsampler s = sampler_state { Texture = "
      "<GBAcolor_A32B32G32R32F>; "
      "AddressU = Clamp; AddressV = Clamp; };\nfloat At(float2 uv) { return tex2D(s, uv).r; }\n"
      "float4 Ps(float2 uv : TEXCOORD0) : COLOR { return float4(At(uv + TexelSize.xw), At(uv - TexelSize.xw), "
      "At(uv + TexelSize.wy), At(uv - TexelSize.wy)); }\ntechnique T { pass P { PixelShader = compile ps_2_0 Ps(); } }";
  Bench bench(CompileText(text), 5, 4);
  bench.Fill("color", picture);
  const PixelMap frame = bench.RunPixels();
  EXPECT_RGBA(frame.at(1, 1), 1, 0, 0, 0);
  EXPECT_RGBA(frame.at(3, 1), 0, 1, 0, 0);
  EXPECT_RGBA(frame.at(2, 0), 0, 0, 1, 0);
  EXPECT_RGBA(frame.at(2, 2), 0, 0, 0, 1);
}

}  // namespace
}  // namespace burin::effect
