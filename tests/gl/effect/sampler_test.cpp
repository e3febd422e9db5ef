// SPDX-License-Identifier: Apache-2.0
// Sampler states and Direct3D 9's defaults for them.
#include <string>

#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

// A picture of 4x1 texels, 10 20 30 40 hundredths, looked up at a place.
float LookUp(const std::string& states, const std::string& coordinate, const std::string& function = "tex2D") {
  const std::string text =
      "texture picture < string ResourceName = \"ramp\"; >;\n"
      "sampler s = sampler_state { Texture = <picture>; " + states + " };\n"
      "float4 Read() : COLOR { return " + function + "(s, " + coordinate + "); }\n"
      "technique T < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_3_0 Read(); } }";
  const TextureLoader loader = [](const std::string& path) -> Result<image::Image> {
    EXPECT_EQ(path, "ramp");
    return MakeImage(4, 1, image::SampleType::kF32, [](int x, int) {
      const float value = 0.1f * static_cast<float>(x + 1);
      return Rgba{value, value, value, 1};
    });
  };
  Bench bench(CompileText(text), 1, 1, {}, {}, loader);
  return bench.RunPixels().at(0, 0)[0];
}

TEST(Sampler, WrapsAndPicksPointsByDefault) {
  EXPECT_FLOAT_EQ(LookUp("", "float2(1.125, 0.5)"), 0.1f);
  EXPECT_FLOAT_EQ(LookUp("", "float2(-0.125, 0.5)"), 0.4f);
  EXPECT_FLOAT_EQ(LookUp("", "float2(0.24, 0.5)"), 0.1f);
  EXPECT_FLOAT_EQ(LookUp("", "float2(0.26, 0.5)"), 0.2f);
}

TEST(Sampler, Clamps) {
  EXPECT_FLOAT_EQ(LookUp("AddressU = Clamp;", "float2(1.125, 0.5)"), 0.4f);
  EXPECT_FLOAT_EQ(LookUp("AddressU = CLAMP;", "float2(-7, 0.5)"), 0.1f);
}

TEST(Sampler, Mirrors) {
  EXPECT_FLOAT_EQ(LookUp("AddressU = Mirror;", "float2(1.125, 0.5)"), 0.4f);
  EXPECT_FLOAT_EQ(LookUp("AddressU = Mirror;", "float2(1.375, 0.5)"), 0.3f);
  EXPECT_FLOAT_EQ(LookUp("AddressU = Mirror;", "float2(2.125, 0.5)"), 0.1f);
  EXPECT_FLOAT_EQ(LookUp("AddressU = MirrorOnce;", "float2(-0.375, 0.5)"), 0.2f);
  EXPECT_FLOAT_EQ(LookUp("AddressU = MirrorOnce;", "float2(2.125, 0.5)"), 0.4f);
}

TEST(Sampler, BorderColourIsArgb) {
  const std::string states = "AddressU = Border; BorderColor = 0x40FF8020;";
  EXPECT_NEAR(LookUp(states, "float2(1.125, 0.5)"), 1.0f, 1e-6f);
  EXPECT_NEAR(LookUp(states, "float2(1.125, 0.5)).gggg + 0 * tex2D(s, 0"), 128.0f / 255, 1e-6f);
  EXPECT_NEAR(LookUp(states, "float2(1.125, 0.5)).aaaa + 0 * tex2D(s, 0"), 64.0f / 255, 1e-6f);
  EXPECT_NEAR(LookUp("AddressU = Border;", "float2(1.125, 0.5)"), 0.0f, 1e-6f);
}

TEST(Sampler, FiltersLinearly) {
  EXPECT_NEAR(LookUp("MagFilter = Linear; MinFilter = Linear;", "float2(0.25, 0.5)"), 0.15f, 1e-3f);
  EXPECT_NEAR(LookUp("MagFilter = Linear; AddressU = Clamp;", "float2(0.0, 0.5)"), 0.1f, 1e-3f);
  // Wrapping, half of the first texel and half of the last.
  EXPECT_NEAR(LookUp("MagFilter = Linear;", "float2(0.0, 0.5)"), 0.25f, 1e-3f);
}

TEST(Sampler, MipmapsAreMadeWhenAskedFor) {
  EXPECT_NEAR(LookUp("MipFilter = Point;", "float4(0.125, 0.5, 0, 2)", "tex2Dlod"), 0.25f, 1e-3f);
  EXPECT_NEAR(LookUp("MipFilter = Linear; MinFilter = Linear;", "float4(0.25, 0.5, 0, 1)", "tex2Dlod"), 0.15f, 1e-3f);
  // MipFilter None stays on the first level.
  EXPECT_NEAR(LookUp("", "float4(0.125, 0.5, 0, 2)", "tex2Dlod"), 0.1f, 1e-6f);
}

TEST(Sampler, MaxMipLevelAndBias) {
  EXPECT_NEAR(LookUp("MipFilter = Point; MaxMipLevel = 2;", "float4(0.125, 0.5, 0, 0)", "tex2Dlod"), 0.25f, 1e-3f);
  EXPECT_NEAR(LookUp("MaxMipLevel = 2;", "float4(0.125, 0.5, 0, 0)", "tex2Dlod"), 0.25f, 1e-3f);
  EXPECT_NEAR(LookUp("MipFilter = Point; MipMapLodBias = 2;", "float4(0.125, 0.5, 0, 0)", "tex2Dlod"), 0.25f, 1e-3f);
}

TEST(Sampler, ProjectionDividesByW) {
  EXPECT_FLOAT_EQ(LookUp("", "float4(1.5, 1, 0, 4)", "tex2Dproj"), 0.2f);
}

TEST(Sampler, OneTextureMayHaveSeveralSamplers) {
  const std::string text =
      "texture picture < string ResourceName = \"ramp\"; >;\n"
      "sampler a = sampler_state { Texture = <picture>; AddressU = Clamp; };\n"
      "sampler b = sampler_state { Texture = <picture>; AddressU = Wrap; };\n"
      "float4 Read() : COLOR { return float4(tex2D(a, float2(1.1, 0)).x, tex2D(b, float2(1.1, 0)).x, 0, 0); }\n"
      "technique T < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_3_0 Read(); } }";
  const TextureLoader loader = [](const std::string&) -> Result<image::Image> {
    return MakeImage(2, 1, image::SampleType::kF32, [](int x, int) { return Rgba{x == 0 ? 3.0f : 5.0f, 0, 0, 1}; });
  };
  Bench bench(CompileText(text), 1, 1, {}, {}, loader);
  EXPECT_RGBA(bench.RunPixels().at(0, 0), 5, 3, 0, 0);
}

TEST(FileTexture, ParametersNameFiles) {
  const std::string text =
      "texture picture; sampler s = sampler_state { Texture = <picture>; };\n"
      "float4 TexelSize_picture;\n"
      "float4 Read() : COLOR { return float4(tex2D(s, float2(0.5, 0.5)).xyz, TexelSize_picture.x); }\n"
      "technique T < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_2_0 Read(); } }";
  const TextureLoader loader = [](const std::string& path) -> Result<image::Image> {
    EXPECT_EQ(path, "given.png");
    return MakeImage(4, 4, image::SampleType::kU8, [](int, int) { return Rgba{0.2f, 0.4f, 0.6f, 1}; });
  };
  Bench bench(CompileText(text), 1, 1, {{"picture", "given.png"}}, {}, loader);
  EXPECT_RGBA(bench.RunPixels().at(0, 0), 0.2f, 0.4f, 0.6f, 0.25f);
}

TEST(FileTexture, OnesWithoutAFileAreWhiteWithOneWarning) {
  const std::string text =
      "texture picture; sampler s = sampler_state { Texture = <picture>; };\n"
      "texture bumps : NORMAL; sampler n = sampler_state { Texture = <bumps>; };\n"
      "texture sky; samplerCUBE c = sampler_state { Texture = <sky>; };\n"
      "float4 Read() : COLOR { return float4(tex2D(s, 0.5).x, tex2D(n, 0.5).xz, texCUBE(c, float3(0, 1, 0)).x); }\n"
      "technique T < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_2_0 Read(); } }";
  Bench bench(CompileText(text), 1, 1);
  EXPECT_RGBA8(bench.RunPixels().at(0, 0), 1, 0.502f, 1, 0.502f);
  ASSERT_TRUE(bench.runner);
  EXPECT_EQ(bench.runner->warnings(),
            (std::vector<std::string>{"test.fx: texture 'picture' names no file: a stand-in is used",
                                      "test.fx: texture 'bumps' names no file: a stand-in is used",
                                      "test.fx: texture 'sky' names no file: a stand-in is used"}));
}

TEST(FileTexture, AMissingFileIsAnError) {
  const std::string text =
      "texture picture < string ResourceName = \"gone.png\"; >; sampler s = sampler_state { Texture = <picture>; };\n"
      "float4 Read() : COLOR { return tex2D(s, 0.5); }\n"
      "technique T { pass P { PixelShader = compile ps_2_0 Read(); } }";
  const auto effect = CompileText(text);
  ASSERT_TRUE(effect);
  RunnerOptions options;
  options.width = options.height = 1;
  options.display_frame_format = options.linear_frame_format = gl::PlainFormat(gl::Numeric::kUnorm, 8, 4);
  options.load_texture = [](const std::string& path) -> Result<image::Image> {
    return Fail(ErrorKind::kInput, "no file '" + path + "' in /effects");
  };
  const auto runner = EffectRunner::Create(effect, options);
  ASSERT_FALSE(runner.has_value());
  EXPECT_EQ(runner.error().kind, ErrorKind::kInput);
  EXPECT_EQ(runner.error().message, "texture 'picture' of test.fx: no file 'gone.png' in /effects");
}

}  // namespace
}  // namespace burin::effect
