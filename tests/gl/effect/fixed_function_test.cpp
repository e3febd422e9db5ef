// SPDX-License-Identifier: Apache-2.0
// Direct3D 9's fixed pipeline by value: texture stages, lights, materials.
#include <algorithm>
#include <functional>
#include <string>

#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

const std::string kVertex =
    "float4 Diffuse = {0.8, 0.4, 0.2, 0.5};\n"
    "void VS(float4 p : POSITION, out float4 q : POSITION, out float4 c : COLOR0, out float4 s : COLOR1) { q = p; c = "
    "Diffuse; s = float4(0.1, 0.2, 0.3, 0.25); }\n";

Rgba Stages(const std::string& states) {
  return RunText(kVertex + "technique T { pass P { VertexShader = compile vs_2_0 VS(); " + states + " } }", 1, 1)
      .at(0, 0);
}

// Each operation on the texture factor (0.25, 0.5, 1, 0.75) and the diffuse colour.
TEST(FixedFunction, OperationsOfTextureStages) {
  constexpr Rgba a = {0.25f, 0.5f, 1, 0.75f};
  constexpr Rgba b = {0.8f, 0.4f, 0.2f, 0.5f};
  using Operation = std::function<float(float, float)>;
  const std::pair<const char*, Operation> operations[] = {
      {"SelectArg1", [](float x, float) { return x; }},
      {"SelectArg2", [](float, float y) { return y; }},
      {"Modulate", [](float x, float y) { return x * y; }},
      {"Modulate2x", [](float x, float y) { return 2 * x * y; }},
      {"MODULATE4X", [](float x, float y) { return 4 * x * y; }},
      {"Add", [](float x, float y) { return x + y; }},
      {"AddSigned", [](float x, float y) { return x + y - 0.5f; }},
      {"AddSigned2x", [](float x, float y) { return 2 * (x + y - 0.5f); }},
      {"Subtract", [](float x, float y) { return x - y; }},
      {"AddSmooth", [](float x, float y) { return x + y - x * y; }},
      {"BlendDiffuseAlpha", [](float x, float y) { return x * 0.5f + y * 0.5f; }},
      {"BlendFactorAlpha", [](float x, float y) { return x * 0.75f + y * 0.25f; }},
  };
  for (const auto& [name, operation] : operations) {
    const std::string states = "TextureFactor = 0xBF4080FF; ColorOp[0] = " + std::string(name) +
                               "; ColorArg1[0] = TFactor; ColorArg2[0] = Diffuse; AlphaOp[0] = " + std::string(name) +
                               "; AlphaArg1[0] = TFactor; AlphaArg2[0] = Diffuse;";
    Rgba expected;
    for (std::size_t i = 0; i < 4; ++i) expected[i] = std::clamp(operation(a[i], b[i]), 0.0f, 1.0f);
    EXPECT_TRUE(Near(Stages(states), expected, 2.0f / 255)) << name;
  }
}

TEST(FixedFunction, ArgumentsAreComplementedAndReplicated) {
  EXPECT_RGBA8(Stages("ColorOp[0] = SelectArg1; ColorArg1[0] = Diffuse | Complement; AlphaOp[0] = SelectArg1; "
                      "AlphaArg1[0] = Diffuse | Complement;"),
               0.2f, 0.6f, 0.8f, 0.5f);
  EXPECT_RGBA8(Stages("ColorOp[0] = SelectArg1; ColorArg1[0] = Diffuse | AlphaReplicate; AlphaOp[0] = SelectArg1; "
                      "AlphaArg1[0] = Diffuse;"),
               0.5f, 0.5f, 0.5f, 0.5f);
  EXPECT_RGBA8(Stages("ColorOp[0] = SelectArg1; ColorArg1[0] = Specular; AlphaOp[0] = SelectArg1; AlphaArg1[0] = "
                      "Specular;"),
               0.1f, 0.2f, 0.3f, 0.25f);
}

TEST(FixedFunction, StagesWorkOnEachOther) {
  EXPECT_RGBA8(
      Stages("ColorOp[0] = SelectArg1; ColorArg1[0] = Diffuse; ColorOp[1] = Add; ColorArg1[1] = Current; "
             "ColorArg2[1] = Specular; ColorOp[2] = Disable; AlphaOp[0] = SelectArg1; AlphaArg1[0] = Diffuse;"),
      0.9f, 0.6f, 0.5f, 0.5f);
  EXPECT_RGBA8(
      Stages("SpecularEnable = true; ColorOp[0] = SelectArg1; ColorArg1[0] = Diffuse; AlphaOp[0] = SelectArg1; "
             "AlphaArg1[0] = Diffuse;"),
      0.9f, 0.6f, 0.5f, 0.5f);
}

TEST(FixedFunction, TexturesAreLookedUpAtTheVertexShadersCoordinates) {
  const std::string text =
      "texture t < string ResourceName = \"t\"; >;\n"
      "void VS(float4 p : POSITION, out float4 q : POSITION, out float4 c : COLOR0, out float2 t : TEXCOORD0) { q = p; "
      "c "
      "= 0.5; t = float2(0.75, 0.5); }\n"
      "technique T { pass P { VertexShader = compile vs_2_0 VS(); Texture[0] = <t>; ColorOp[0] = Modulate; "
      "ColorArg1[0] "
      "= Texture; ColorArg2[0] = Diffuse; AlphaOp[0] = SelectArg1; AlphaArg1[0] = Texture; } }";
  const TextureLoader loader = [](const std::string&) -> Result<image::Image> {
    return MakeImage(2, 1, image::SampleType::kU8, [](int x, int) { return Rgba{x == 0 ? 0.2f : 0.8f, 0.4f, 0, 1}; });
  };
  Bench bench(CompileText(text), 1, 1, {}, {}, loader);
  EXPECT_RGBA8(bench.RunPixels().at(0, 0), 0.4f, 0.2f, 0, 1);
}

TEST(FixedFunction, ASamplerOfARegisterTakesThePassesTexture) {
  const std::string text =
      "texture t < string ResourceName = \"t\"; >; sampler given = sampler_state { Texture = <t>; };\n"
      "sampler s : register(s1);\nfloat4 PS() : COLOR { return tex2D(s, 0.5); }\n"
      "technique A { pass P { Texture[1] = <t>; PixelShader = compile ps_2_0 PS(); } }\n"
      "technique B { pass P { Sampler[1] = (given); PixelShader = compile ps_2_0 PS(); } }";
  const TextureLoader loader = [](const std::string&) -> Result<image::Image> {
    return MakeImage(1, 1, image::SampleType::kU8, [](int, int) { return Rgba{0.2f, 0.4f, 0.6f, 1}; });
  };
  for (const char* technique : {"A", "B"}) {
    Bench bench(CompileText(text), 1, 1, {}, technique, loader);
    EXPECT_RGBA8(bench.RunPixels().at(0, 0), 0.2f, 0.4f, 0.6f, 1) << technique;
  }
}

// The quadrilateral faces the eye: its normal is +z.
Rgba Lit(const std::string& states, const Settings& parameters = {}) {
  const std::string text =
      "float4 Paint = {0.5, 1, 0.25, 0.5}; float4 Way = {0, 0, -1, 0};\n"
      "technique T { pass P { VertexShader = NULL; PixelShader = NULL; Ambient = 0; CullMode = None; " +
      states + " } }";
  Bench bench(CompileText(text), 1, 1, parameters);
  bench.context.eye_world = {0, 0, 1e4f};
  return bench.RunPixels().at(0, 0);
}

TEST(FixedFunction, LightsAndMaterials) {
  const std::string light =
      "Lighting = true; LightEnable[0] = true; LightType[0] = Directional; LightDirection[0] = <Way>; "
      "LightDiffuse[0] = float4(1, 0.5, 1, 1); MaterialDiffuse = <Paint>; MaterialAmbient = float4(0, 0, 0, 0); ";
  EXPECT_RGBA8(Lit(light), 0.5f, 0.5f, 0.25f, 0.5f);
  EXPECT_RGBA8(Lit(light, {{"Way", "0,0,1,0"}}), 0, 0, 0, 0.5f);
  // 60 degrees from the normal, of a vector that is not unit.
  EXPECT_RGBA8(Lit(light, {{"Way", "1.7320508,0,-1,0"}}), 0.25f, 0.25f, 0.125f, 0.5f);
  EXPECT_RGBA8(Lit(light + "MaterialEmissive = {0.25, 0, 0, 1};"), 0.75f, 0.5f, 0.25f, 0.5f);
  EXPECT_RGBA8(Lit(light + "Ambient = 0xff808080; MaterialAmbient = (Paint * 0.5);"), 0.6255f, 0.751f, 0.3127f, 0.5f);
  EXPECT_RGBA8(Lit(light + "LightEnable[0] = false;"), 0, 0, 0, 0.5f);
  EXPECT_RGBA8(Lit("Lighting = false;"), 1, 1, 1, 1);
}

TEST(FixedFunction, PointLightsFadeAndSpotLightsEnd) {
  const std::string point =
      "Lighting = true; LightEnable[1] = true; LightType[1] = Point; LightPosition[1] = float3(0, 0, 2); "
      "MaterialDiffuse = float4(1, 1, 1, 1); MaterialAmbient = float4(0, 0, 0, 0); ";
  // Vertices are lit, which are at the corners: the light is the root of 6 away, at an angle whose cosine is 2 of that.
  constexpr float kFacing = 0.8165f, kFaded = 0.3333f;
  EXPECT_RGBA8(Lit(point), kFacing, kFacing, kFacing, 1);
  EXPECT_RGBA8(Lit(point + "LightAttenuation0[1] = 0; LightAttenuation1[1] = 1;"), kFaded, kFaded, kFaded, 1);
  EXPECT_RGBA8(Lit(point + "LightRange[1] = 1;"), 0, 0, 0, 1);
}

// Turned by the pass's own matrices: World puts the quadrilateral beyond the right edge.
TEST(FixedFunction, TransformsOfThePass) {
  const std::string text =
      "float4x4 Away = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1};\nfloat4x4 Here = {1, 0, 0, 0, 0, 1, 0, 0, 0, "
      "0, 1, 0, 0, 0, 0, 1};\n"
      "technique A { pass P { Lighting = false; WorldTransform[0] = <Away>; } }\n"
      "technique H { pass P { Lighting = false; WorldTransform[0] = <Here>; } }";
  Bench away(CompileText(text), 1, 1, {}, "A");
  EXPECT_RGBA8(away.RunPixels().at(0, 0), 0, 0, 0, 0);
  Bench here(CompileText(text), 1, 1, {}, "H");
  EXPECT_RGBA8(here.RunPixels().at(0, 0), 1, 1, 1, 1);
}

TEST(ShaderChoice, FollowsTheParameter) {
  const std::string text =
      "float4 Red() : COLOR { return float4(1, 0, 0, 1); } float4 Green() : COLOR { return float4(0, 1, 0, 1); }\n"
      "float4 A(float4 p : POSITION) : POSITION { return p; } float4 B(float4 p : POSITION) : POSITION { return p + "
      "float4(5, 0, 0, 0); }\nint Which = 0; int Where = 0;\n"
      "PixelShader ps[2] = { compile ps_2_0 Red(), compile ps_2_0 Green() };\n"
      "VertexShader vs[2] = { compile vs_2_0 A(), compile vs_2_0 B() };\n"
      "technique T { pass P { VertexShader = (vs[Where]); PixelShader = (ps[Which]); } }";
  const auto at = [&](const Settings& settings) { return RunText(text, 1, 1, settings).at(0, 0); };
  EXPECT_RGBA8(at({}), 1, 0, 0, 1);
  EXPECT_RGBA8(at({{"Which", "1"}}), 0, 1, 0, 1);
  EXPECT_RGBA8(at({{"Where", "1"}}), 0, 0, 0, 0);
  EXPECT_RGBA8(at({{"Which", "9"}}), 0, 1, 0, 1) << "the nearest that there is";
}

}  // namespace
}  // namespace burin::effect
