// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/compile_effect.h"

namespace burin::fx {
namespace {

using test::Messages;

std::string WithStates(const std::string& states, const std::string& declarations = "") {
  return declarations +
         "float4 PS() : COLOR { return 0; }\ntechnique T { pass P { PixelShader = compile ps_2_0 PS();\n" + states +
         " } }";
}

/// The states' values in order.
std::vector<double> Numbers(const std::string& states) {
  const CompileResult result = test::Compile(WithStates(states));
  EXPECT_EQ(Messages(result), "");
  std::vector<double> numbers;
  if (!result.effect) return numbers;
  for (const PassState& state : result.effect->techniques[0].passes[0].states)
    numbers.push_back(std::get<Value>(state.value).numbers[0]);
  return numbers;
}

using V = std::vector<double>;

TEST(RenderStates, ValuesHaveDirect3DsNumbers) {
  EXPECT_EQ(Numbers("CullMode = None; CULLMODE = CW; cullmode = ccw;"), (V{1, 2, 3}));
  EXPECT_EQ(Numbers("ZFunc = Never; ZFunc = Less; ZFunc = Equal; ZFunc = LessEqual; ZFunc = Greater; ZFunc = NotEqual; "
                    "ZFunc = GreaterEqual; ZFunc = Always;"),
            (V{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(Numbers("SrcBlend = Zero; SrcBlend = ONE; SrcBlend = SrcColor; SrcBlend = InvSrcColor; SrcBlend = "
                    "SrcAlpha; SrcBlend = InvSrcAlpha; "
                    "SrcBlend = DestAlpha; SrcBlend = InvDestAlpha; SrcBlend = DestColor; SrcBlend = InvDestColor; "
                    "SrcBlend = SrcAlphaSat; "
                    "SrcBlend = BlendFactor; SrcBlend = InvBlendFactor;"),
            (V{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 14, 15}));
  EXPECT_EQ(Numbers("BlendOp = Add; BlendOp = Subtract; BlendOp = RevSubtract; BlendOp = Min; BlendOp = Max;"),
            (V{1, 2, 3, 4, 5}));
  EXPECT_EQ(Numbers("StencilPass = Keep; StencilPass = Zero; StencilPass = Replace; StencilPass = IncrSat; StencilPass "
                    "= DecrSat; "
                    "StencilPass = Invert; StencilPass = Incr; StencilPass = Decr;"),
            (V{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(Numbers("FillMode = Point; FillMode = Wireframe; FillMode = Solid;"), (V{1, 2, 3}));
  EXPECT_EQ(Numbers("ZEnable = true; ZEnable = FALSE; ZEnable = UseW; ZEnable = 1;"), (V{1, 0, 2, 1}));
}

TEST(RenderStates, TakeNumbersListsAndExpressions) {
  EXPECT_EQ(Numbers("ColorWriteEnable = RED | GREEN | BLUE | ALPHA; ColorWriteEnable = red|Blue; ColorWriteEnable = "
                    "0x7; ColorWriteEnable = 0;"),
            (V{15, 5, 7, 0}));
  EXPECT_EQ(Numbers("AlphaRef = 0x80; StencilMask = 0xFFFFFFFF; DepthBias = -0.5; DepthBias = 2; StencilRef = (1 + 2); "
                    "CullMode = (1);"),
            (V{128, 4294967295.0, -0.5, 2, 3, 1}));
  EXPECT_EQ(Numbers("BlendFactor = 0xff804020; BlendFactor = float4(1, 0, 0, 1);"), (V{4286595104.0, 4294901760.0}));
}

TEST(RenderStates, KeepExpressionsOverParameters) {
  const CompileResult result =
      test::Compile(WithStates("CullMode = <iCull>; ZEnable = (iCull > 1); AlphaRef = iCull;", "int iCull = 2;\n"));
  ASSERT_TRUE(result.effect) << Messages(result);
  for (const PassState& state : result.effect->techniques[0].passes[0].states)
    EXPECT_TRUE(std::holds_alternative<const ast::Expression*>(state.value));
}

TEST(RenderStates, UnknownNamesAreWarningsUnknownValuesErrors) {
  EXPECT_EQ(Messages(WithStates("CulMode = None;")),
            "3:1: warning: unknown render state 'CulMode' is ignored; did you mean 'CullMode'? [B1009]\n");
  EXPECT_EQ(Messages(WithStates("ZFunc = LesEqual;")),
            "3:9: error: undeclared identifier 'LesEqual' as value of ZFunc; did you mean 'lessequal'? [X3004]\n");
  EXPECT_EQ(Messages(WithStates("CullMode = Sideways;")),
            "3:12: error: undeclared identifier 'Sideways' as value of CullMode: expected a number, a parameter or one "
            "of true, false, none, cw, ccw [X3004]\n");
  EXPECT_EQ(Messages(WithStates("AlphaRef = <tint>;", "float4 tint;\n")),
            "4:13: error: AlphaRef takes a number, found 'float4' [X3020]\n");
  EXPECT_EQ(Messages(WithStates("ShadeMode = Gouraud; FogEnable = false; Lighting = false;")), "")
      << "harmless beside shaders";
}

TEST(SamplerStates, AreResolved) {
  const CompileResult result = test::Compile(
      "texture t;\nsampler s = sampler_state { Texture = <t>; MinFilter = Anisotropic; magfilter = LINEAR; MIPFILTER = "
      "point; AddressU = Wrap; AddressV = MIRROR;"
      " AddressW = MirrorOnce; BorderColor = 0xff0000ff; MaxAnisotropy = 8; MipMapLodBias = -0.5; SRGBTexture = true; "
      "MaxMipLevel = 1; };");
  ASSERT_TRUE(result.effect) << Messages(result);
  V numbers;
  for (const SamplerState& state : result.effect->samplers[0].states)
    numbers.push_back(std::get<Value>(state.value).numbers[0]);
  EXPECT_EQ(numbers, (V{3, 2, 1, 1, 2, 5, 4278190335.0, 8, -0.5, 1, 1}));
  EXPECT_EQ(result.effect->samplers[0].texture, 0u);
}

TEST(SamplerStates, CgAndDirect3D10NamesAreTranslated) {
  const CompileResult result = test::Compile(
      "texture t;\nsampler a = sampler_state { Texture = (t); MinFilter = LinearMipMapLinear; MagFilter = Linear; "
      "WrapS = Repeat; WrapT = ClampToEdge; };\n"
      "sampler b { Texture = t; Filter = MIN_MAG_LINEAR_MIP_POINT; AddressU = CLAMP; };");
  ASSERT_TRUE(result.effect) << Messages(result);
  const auto states = [&](std::size_t i) {
    std::vector<std::pair<SamplerStateName, double>> list;
    for (const SamplerState& state : result.effect->samplers[i].states)
      list.emplace_back(state.name, std::get<Value>(state.value).numbers[0]);
    return list;
  };
  using enum SamplerStateName;
  using States = std::vector<std::pair<SamplerStateName, double>>;
  EXPECT_EQ(states(0), (States{{kMinFilter, 2}, {kMipFilter, 2}, {kMagFilter, 2}, {kAddressU, 1}, {kAddressV, 3}}));
  EXPECT_EQ(states(1), (States{{kMinFilter, 2}, {kMagFilter, 2}, {kMipFilter, 1}, {kAddressU, 3}}));
}

TEST(SamplerStates, FaultsAreNamed) {
  EXPECT_EQ(Messages("texture t;\nsampler s = sampler_state { Texture = <u>; };"),
            "2:40: error: undeclared identifier 'u' [X3004]\n");
  EXPECT_EQ(Messages("float t;\nsampler s = sampler_state { Texture = <t>; };"),
            "2:40: error: 't' is a float, a texture was expected [X3020]\n");
  EXPECT_EQ(Messages("sampler s = sampler_state { Adress = WRAP; };"),
            "1:29: warning: unknown sampler state 'Adress' is ignored; did you mean 'AddressU'? [B1009]\n");
  EXPECT_EQ(Messages("textureCUBE t;\nsampler2D s = sampler_state { Texture = <t>; };"),
            "2:11: error: sampler 's' is a sampler2D, but its texture 't' is not [B1018]\n  1:13: note: 't' was "
            "declared here\n");
}

}  // namespace
}  // namespace burin::fx
