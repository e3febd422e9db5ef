// SPDX-License-Identifier: Apache-2.0
// The edge detector with dilation that figure 2 of "The G2-Buffer Framework" declares, rewritten: the language that the
// whole program exists for.

#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

constexpr const char* kEffect = R"(// Roberts cross on the intensity attribute, then a 3x3 dilation.
float4 TexelSize;                 // filled in by the host: one texel
float  edgeThreshold   = 0.09f;
float  dilateThreshold = 9.0f;

Texture GBAintensity_A8R8G8B8;    // an attribute
Texture PASS0_A8R8G8B8;           // what pass 0 leaves behind

struct VS_EDGE_OUT
{
    float4 Pos  : POSITION;
    float2 Tex0 : TEXCOORD0;
    float2 Tex1 : TEXCOORD1;
    float2 Tex2 : TEXCOORD2;
};

VS_EDGE_OUT VSEdgeFilter(float3 Pos : POSITION, float2 Tex0 : TEXCOORD0, float2 Tex1 : TEXCOORD1)
{
    VS_EDGE_OUT Out;
    Out.Pos.xyz = Pos;
    Out.Pos.w = 1.0f;
    Out.Tex0 = Tex0;
    float2 below = Tex0 - TexelSize.wy;
    Out.Tex1 = below - TexelSize.xw;
    Out.Tex2 = below + TexelSize.xw;
    return Out;
}

struct VS_DILATE_OUT
{
    float4 Pos  : POSITION;
    float2 Tex0 : TEXCOORD0;
    float4 Tex1 : TEXCOORD1;
    float4 Tex2 : TEXCOORD2;
};

VS_DILATE_OUT VSDilate(float3 Pos : POSITION, float2 Tex0 : TEXCOORD0)
{
    VS_DILATE_OUT Out;
    Out.Pos.xyz = Pos;
    Out.Pos.w = 1.0f;
    Out.Tex0 = Tex0;
    Out.Tex1.xy = Tex0 + TexelSize.xw;
    Out.Tex1.zw = Tex0 - TexelSize.xw;
    Out.Tex2.xy = Tex0 - TexelSize.xw
                + TexelSize.wy;
    Out.Tex2.zw = Tex0 - TexelSize.wy;
    return Out;
}

sampler objInt = sampler_state
{
    texture = <GBAintensity_A8R8G8B8>;
    AddressU = WRAP;
    AddressV = WRAP;
    MIPFILTER = POINT;
    MINFILTER = POINT;
};

float4 PSEdgeFilter(VS_EDGE_OUT In) : COLOR
{
    float4 centre = tex2D(objInt, In.Tex0);
    float4 left   = tex2D(objInt, In.Tex1);
    float4 right  = tex2D(objInt, In.Tex2);
    float edgeWeight = abs(centre.x - left.x) + abs(centre.x - right.x);
    float4 edgeColor = 1.0f;
    if (edgeWeight > edgeThreshold)
        edgeColor = 0.0f;
    return edgeColor;
}

sampler edge = sampler_state
{
    texture = <PASS0_A8R8G8B8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MIPFILTER = POINT;
    MINFILTER = POINT;
};

float4 PSDilate(VS_DILATE_OUT In) : COLOR
{
    float weight = tex2D(edge, In.Tex0) + tex2D(edge, In.Tex1.xy) + tex2D(edge, In.Tex1.zw)
                 + tex2D(edge, In.Tex2.xy) + tex2D(edge, In.Tex2.zw);
    float shade = 1.0f;
    if (weight < dilateThreshold)
        shade = 0.0f;
    return shade;
}

technique T0
{
    pass P0
    {
        VertexShader = compile vs_1_1 VSEdgeFilter();
        PixelShader  = compile ps_2_0 PSEdgeFilter();
    }
    pass P1
    {
        VertexShader = compile vs_1_1 VSDilate();
        PixelShader  = compile ps_2_0 PSDilate();
    }
}
)";

TEST(ParserPaperEffect, ParsesFigure2) {
  const auto parsed = ParseText(kEffect);
  EXPECT_EQ(parsed->Formatted(), "");
  ASSERT_EQ(parsed->module.declarations.size(), 14u);
  EXPECT_EQ(Dump(parsed->module.declarations[0]), "[float4 TexelSize]");
  EXPECT_EQ(Dump(parsed->module.declarations[1]), "[float edgeThreshold = 0.09f]");
  EXPECT_EQ(Dump(parsed->module.declarations[3]), "[Texture GBAintensity_A8R8G8B8]");
  EXPECT_EQ(Dump(parsed->module.declarations[4]), "[Texture PASS0_A8R8G8B8]");
  EXPECT_EQ(Dump(parsed->module.declarations[9]),
            "[sampler objInt = (states texture=<GBAintensity_A8R8G8B8> AddressU=WRAP AddressV=WRAP MIPFILTER=POINT "
            "MINFILTER=POINT)]");
  EXPECT_EQ(
      Dump(parsed->module.declarations[10]),
      "(function float4 PSEdgeFilter [VS_EDGE_OUT In] : COLOR { "
      "(var [float4 centre = (call tex2D objInt (. In Tex0))]) "
      "(var [float4 left = (call tex2D objInt (. In Tex1))]) "
      "(var [float4 right = (call tex2D objInt (. In Tex2))]) "
      "(var [float edgeWeight = (+ (call abs (- (. centre x) (. left x))) (call abs (- (. centre x) (. right x))))]) "
      "(var [float4 edgeColor = 1f]) (if (> edgeWeight edgeThreshold) (= edgeColor 0f)) (return edgeColor) })");
  EXPECT_EQ(
      Dump(parsed->module.declarations[13]),
      "(technique T0 (pass P0 VertexShader=(compile vs_1_1 VSEdgeFilter) PixelShader=(compile ps_2_0 PSEdgeFilter)) "
      "(pass P1 VertexShader=(compile vs_1_1 VSDilate) PixelShader=(compile ps_2_0 PSDilate)))");
}

TEST(ParserPaperEffect, PointsAtTheWordThatIsWrong) {
  std::string text = kEffect;
  text.replace(text.find("AddressU = CLAMP;"), 17, "AddressU = CLAMP");
  const auto parsed = ParseText(text);
  EXPECT_EQ(parsed->Formatted(),
            "main.fx:75:21: error: expected ';' after sampler state [X3000]\n"
            "    AddressU = CLAMP\n"
            "                    ^\n");
}

}  // namespace
}  // namespace burin::fx::test
