// SPDX-License-Identifier: Apache-2.0
// Render states, their Direct3D 9 defaults, and what lasts from pass to pass.
#include <string>

#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

// Shaders that tests share: Fill(r, g, b, a) as a pixel shader, At(z) as a vertex shader, Reversed winds the quadrilateral
// counter-clockwise by mirroring it.
const std::string kShaders = R"(
float4 Fill(uniform float r, uniform float g, uniform float b, uniform float a) : COLOR { return float4(r, g, b, a); }
float4 At(float4 p : POSITION, uniform float z) : POSITION { return float4(p.xy, z, 1); }
float4 Reversed(float4 p : POSITION) : POSITION { return float4(-p.x, p.y, 0, 1); }
struct Placed { float4 p : POSITION; float2 uv : TEXCOORD0; };
Placed LeftHalf(float4 p : POSITION, float2 uv : TEXCOORD0, uniform float z)
{ Placed o; o.p = float4(p.x < 0 ? -1 : 0, p.y, z, 1); o.uv = uv; return o; }
)";

std::string Technique(const std::string& passes) {
  // A name of the extension, so that no half pixel is added.
  return "texture GBAcolor_A8R8G8B8;\n" + kShaders + "technique T < string ColorSpace = \"linear\"; > {" + passes + "}";
}

// The frame, in floats, after the passes; 2x1 pixels unless told otherwise.
PixelMap Draw(const std::string& passes, const Settings& parameters = {}, const std::string& globals = {}) {
  return RunText(globals + Technique(passes), 2, 1, parameters);
}

TEST(RenderState, TheQuadrilateralPassesTheDefaults) {
  EXPECT_RGBA(Draw("pass A { PixelShader = compile ps_2_0 Fill(1, 2, 3, 4); }").at(1, 0), 1, 2, 3, 4);
}

TEST(RenderState, CounterClockwiseFacesAreCulledByDefault) {
  const std::string pass = "VertexShader = compile vs_2_0 Reversed(); PixelShader = compile ps_2_0 Fill(1, 1, 1, 1);";
  EXPECT_RGBA(Draw("pass A {" + pass + "}").at(0, 0), 0, 0, 0, 0);
  EXPECT_RGBA(Draw("pass A { CullMode = CW; " + pass + "}").at(0, 0), 1, 1, 1, 1);
  EXPECT_RGBA(Draw("pass A { CullMode = None; " + pass + "}").at(0, 0), 1, 1, 1, 1);
}

TEST(RenderState, ClockwiseFacesAreCulledByCw) {
  const std::string pass = "PixelShader = compile ps_2_0 Fill(1, 1, 1, 1);";
  EXPECT_RGBA(Draw("pass A { CullMode = CW; " + pass + "}").at(0, 0), 0, 0, 0, 0);
  EXPECT_RGBA(Draw("pass A { CullMode = CCW; " + pass + "}").at(0, 0), 1, 1, 1, 1);
}

TEST(RenderState, VfaceIsPositiveOnClockwiseFaces) {
  const std::string shader = "float4 Face(float f : VFACE) : COLOR { return float4(f > 0 ? 1 : 0, f < 0 ? 1 : 0, 0, 1); }\n";
  const std::string reversed = "VertexShader = compile vs_3_0 Reversed();";
  EXPECT_RGBA(Draw("pass A { PixelShader = compile ps_3_0 Face(); }", {}, shader).at(0, 0), 1, 0, 0, 1);
  EXPECT_RGBA(Draw("pass A { CullMode = None; " + reversed + " PixelShader = compile ps_3_0 Face(); }", {}, shader).at(0, 0),
              0, 1, 0, 1);
}

TEST(RenderState, TheFrameStartsTransparentBlackEveryTime) {
  const std::string text = Technique(
      "pass A { AlphaBlendEnable = true; SrcBlend = One; DestBlend = One; PixelShader = compile ps_2_0 Fill(1, 2, 3, 4); }");
  Bench bench(CompileText(text), 1, 1);
  EXPECT_RGBA(bench.RunPixels().at(0, 0), 1, 2, 3, 4);
  EXPECT_RGBA(bench.RunPixels().at(0, 0), 1, 2, 3, 4);
}

TEST(RenderState, LaterPassesBlendWithWhatEarlierOnesDrew) {
  EXPECT_RGBA(Draw("pass A { PixelShader = compile ps_2_0 Fill(0.5, 0.25, 1, 1); }"
                   "pass B { AlphaBlendEnable = true; SrcBlend = SrcAlpha; DestBlend = InvSrcAlpha;"
                   " PixelShader = compile ps_2_0 Fill(1, 0, 0, 0.25); }")
                  .at(0, 0),
              0.625f, 0.1875f, 0.75f, 0.8125f);
}

TEST(RenderState, EveryBlendFactor) {
  struct Case {
    const char* source;
    Rgba expected;   ///< source (0.5, 0.25, 1, 0.5) times its factor; the destination is (0.25, 0.5, 0.75, 0.25)
  };
  const Case cases[] = {{"Zero", {0, 0, 0, 0}},
                        {"One", {0.5f, 0.25f, 1, 0.5f}},
                        {"SrcColor", {0.25f, 0.0625f, 1, 0.25f}},
                        {"InvSrcColor", {0.25f, 0.1875f, 0, 0.25f}},
                        {"SrcAlpha", {0.25f, 0.125f, 0.5f, 0.25f}},
                        {"InvSrcAlpha", {0.25f, 0.125f, 0.5f, 0.25f}},
                        {"DestAlpha", {0.125f, 0.0625f, 0.25f, 0.125f}},
                        {"InvDestAlpha", {0.375f, 0.1875f, 0.75f, 0.375f}},
                        {"DestColor", {0.125f, 0.125f, 0.75f, 0.125f}},
                        {"InvDestColor", {0.375f, 0.125f, 0.25f, 0.375f}},
                        {"SrcAlphaSat", {0.25f, 0.125f, 0.5f, 0.5f}},
                        {"BlendFactor", {0.5f * 51 / 255, 0.25f * 102 / 255, 1.0f * 153 / 255, 0.5f * 204 / 255}},
                        {"InvBlendFactor", {0.5f * 204 / 255, 0.25f * 153 / 255, 1.0f * 102 / 255, 0.5f * 51 / 255}}};
  for (const Case& tested : cases) {
    const std::string passes = "pass A { PixelShader = compile ps_2_0 Fill(0.25, 0.5, 0.75, 0.25); }"
                               "pass B { AlphaBlendEnable = true; DestBlend = Zero; BlendFactor = 0xCC336699; SrcBlend = " +
                               std::string(tested.source) +
                               "; PixelShader = compile ps_2_0 Fill(0.5, 0.25, 1, 0.5); }";
    EXPECT_TRUE(Near(Draw(passes).at(0, 0), tested.expected, 1e-3f)) << tested.source;
  }
}

TEST(RenderState, EveryBlendOperation) {
  struct Case {
    const char* operation;
    Rgba expected;
  };
  for (const Case& tested : {Case{"Add", {0.75f, 0.75f, 1.75f, 0.75f}}, Case{"Subtract", {0.25f, -0.25f, 0.25f, 0.25f}},
                             Case{"RevSubtract", {-0.25f, 0.25f, -0.25f, -0.25f}}, Case{"Min", {0.25f, 0.25f, 0.75f, 0.25f}},
                             Case{"Max", {0.5f, 0.5f, 1, 0.5f}}}) {
    const std::string passes = "pass A { PixelShader = compile ps_2_0 Fill(0.25, 0.5, 0.75, 0.25); }"
                               "pass B { AlphaBlendEnable = true; SrcBlend = One; DestBlend = One; BlendOp = " +
                               std::string(tested.operation) +
                               "; PixelShader = compile ps_2_0 Fill(0.5, 0.25, 1, 0.5); }";
    EXPECT_TRUE(Near(Draw(passes).at(0, 0), tested.expected, 1e-6f)) << tested.operation;
  }
}

TEST(RenderState, AlphaBlendsApartWhenToldTo) {
  EXPECT_RGBA(Draw("pass A { PixelShader = compile ps_2_0 Fill(0.25, 0.5, 0.75, 0.25); }"
                   "pass B { AlphaBlendEnable = true; SrcBlend = One; DestBlend = Zero; SeparateAlphaBlendEnable = true;"
                   " SrcBlendAlpha = Zero; DestBlendAlpha = One; BlendOpAlpha = Add; PixelShader = compile ps_2_0 "
                   "Fill(1, 1, 1, 1); }")
                  .at(0, 0),
              1, 1, 1, 0.25f);
}

TEST(RenderState, ColorWriteEnableKeepsTheOthers) {
  EXPECT_RGBA(Draw("pass A { PixelShader = compile ps_2_0 Fill(0.1, 0.2, 0.3, 0.4); }"
                   "pass B { ColorWriteEnable = Red | Blue; PixelShader = compile ps_2_0 Fill(1, 1, 1, 1); }")
                  .at(0, 0),
              1, 0.2f, 1, 0.4f);
}

TEST(RenderState, StatesAreResetBeforeEveryPass) {
  EXPECT_RGBA(Draw("pass A { ColorWriteEnable = Red; AlphaBlendEnable = true; SrcBlend = Zero; CullMode = None;"
                   " AlphaTestEnable = true; AlphaFunc = Never; ZEnable = false; PixelShader = compile ps_2_0 Fill(1, 1, 1, 1); }"
                   "pass B { PixelShader = compile ps_2_0 Fill(0.1, 0.2, 0.3, 0.4); }")
                  .at(0, 0),
              0.1f, 0.2f, 0.3f, 0.4f);
}

TEST(RenderState, AlphaTestComparesWithTheReferenceOf255) {
  struct Case {
    const char* function;
    bool below, equal, above;   ///< whether alphas of 99, 100 and 101 of 255 pass against 100
  };
  for (const Case& tested :
       {Case{"Never", false, false, false}, Case{"Less", true, false, false}, Case{"Equal", false, true, false},
        Case{"LessEqual", true, true, false}, Case{"Greater", false, false, true}, Case{"NotEqual", true, false, true},
        Case{"GreaterEqual", false, true, true}, Case{"Always", true, true, true}}) {
    const auto passes_test = [&](int alpha) {
      const std::string passes = "pass A { AlphaTestEnable = true; AlphaRef = 100; AlphaFunc = " +
                                 std::string(tested.function) + "; PixelShader = compile ps_2_0 Fill(1, 1, 1, " +
                                 std::to_string(alpha) + " / 255.0); }";
      return Draw(passes).at(0, 0)[0] == 1.0f;
    };
    EXPECT_EQ(passes_test(99), tested.below) << tested.function;
    EXPECT_EQ(passes_test(100), tested.equal) << tested.function;
    EXPECT_EQ(passes_test(101), tested.above) << tested.function;
  }
}

TEST(RenderState, DepthIsTestedAgainstEarlierPasses) {
  const auto second = [](const std::string& depth, const std::string& states) {
    return Draw("pass A { VertexShader = compile vs_2_0 At(0.5); PixelShader = compile ps_2_0 Fill(1, 0, 0, 1); }"
                "pass B { " +
                states + " VertexShader = compile vs_2_0 At(" + depth + "); PixelShader = compile ps_2_0 Fill(0, 1, 0, 1); }")
        .at(0, 0)[1];
  };
  EXPECT_EQ(second("0.25", ""), 1);
  EXPECT_EQ(second("0.5", ""), 1);
  EXPECT_EQ(second("0.75", ""), 0);
  EXPECT_EQ(second("0.5", "ZFunc = Less;"), 0);
  EXPECT_EQ(second("0.75", "ZFunc = Greater;"), 1);
  EXPECT_EQ(second("0.75", "ZEnable = false;"), 1);
}

TEST(RenderState, DepthStartsAtOneAndZWriteEnableKeepsIt) {
  EXPECT_RGBA(Draw("pass A { ZWriteEnable = false; VertexShader = compile vs_2_0 At(0.25); PixelShader = compile ps_2_0 "
                   "Fill(1, 0, 0, 1); }"
                   "pass B { ZFunc = Less; VertexShader = compile vs_2_0 At(0.75); PixelShader = compile ps_2_0 "
                   "Fill(0, 1, 0, 1); }")
                  .at(0, 0),
              0, 1, 0, 1);
}

TEST(RenderState, DepthOutputsCount) {
  const std::string shader =
      "void Deep(out float4 c : COLOR, out float d : DEPTH, uniform float z) { c = float4(1, 0, 0, 1); d = z; }\n";
  const std::string later = "pass B { VertexShader = compile vs_2_0 At(0.5); PixelShader = compile ps_2_0 Fill(0, 1, 0, 1); }";
  EXPECT_RGBA(Draw("pass A { PixelShader = compile ps_2_0 Deep(0.25); }" + later, {}, shader).at(0, 0), 1, 0, 0, 1);
  EXPECT_RGBA(Draw("pass A { PixelShader = compile ps_2_0 Deep(0.75); }" + later, {}, shader).at(0, 0), 0, 1, 0, 1);
}

TEST(RenderState, StencilMarksWhatALaterPassKeeps) {
  const std::string passes =
      "pass Mark { StencilEnable = true; StencilRef = 5; StencilPass = Replace; ColorWriteEnable = 0; CullMode = None;"
      " VertexShader = compile vs_2_0 LeftHalf(0); PixelShader = compile ps_2_0 Fill(1, 1, 1, 1); }"
      "pass Draw { StencilEnable = true; StencilRef = 5; StencilFunc = Equal;"
      " PixelShader = compile ps_2_0 Fill(0, 1, 0, 1); }";
  const PixelMap frame = Draw(passes);
  EXPECT_RGBA(frame.at(0, 0), 0, 1, 0, 1);
  EXPECT_RGBA(frame.at(1, 0), 0, 0, 0, 0);
}

TEST(RenderState, StencilCountsAndMasks) {
  const auto test = [&](const std::string& states) {
    return Draw("pass A { StencilEnable = true; StencilPass = IncrSat; PixelShader = compile ps_2_0 Fill(0, 0, 0, 0); }"
                "pass B { StencilEnable = true; StencilPass = Incr; PixelShader = compile ps_2_0 Fill(0, 0, 0, 0); }"
                "pass C { StencilEnable = true; StencilPass = Incr; PixelShader = compile ps_2_0 Fill(0, 0, 0, 0); }"
                "pass D { StencilEnable = true; " +
                states + " PixelShader = compile ps_2_0 Fill(1, 1, 1, 1); }")
               .at(0, 0)[0] == 1.0f;
  };
  EXPECT_TRUE(test("StencilFunc = Equal; StencilRef = 3;"));
  EXPECT_FALSE(test("StencilFunc = Equal; StencilRef = 1;"));
  EXPECT_TRUE(test("StencilFunc = Equal; StencilRef = 1; StencilMask = 1;"));
  EXPECT_TRUE(test("StencilFunc = Greater; StencilRef = 4;"));   // the reference is greater than what is there
}

TEST(RenderState, StencilOfDepthFailures) {
  EXPECT_RGBA(Draw("pass A { VertexShader = compile vs_2_0 At(0.25); PixelShader = compile ps_2_0 Fill(0, 0, 0, 0); }"
                   "pass B { StencilEnable = true; StencilRef = 7; StencilZFail = Replace; VertexShader = compile vs_2_0 "
                   "At(0.5); PixelShader = compile ps_2_0 Fill(0, 0, 0, 0); }"
                   "pass C { StencilEnable = true; StencilRef = 7; StencilFunc = Equal; ZEnable = false; PixelShader = compile "
                   "ps_2_0 Fill(1, 0, 0, 1); }")
                  .at(0, 0),
              1, 0, 0, 1);
}

TEST(RenderState, TwoSidedStencilTakesTheCounterClockwiseStates) {
  const std::string passes =
      "pass A { StencilEnable = true; TwoSidedStencilMode = true; CullMode = None; StencilRef = 9; StencilPass = Zero;"
      " CCW_StencilPass = Replace; VertexShader = compile vs_2_0 Reversed(); PixelShader = compile ps_2_0 Fill(0, 0, 0, 0); }"
      "pass B { StencilEnable = true; StencilRef = 9; StencilFunc = Equal; PixelShader = compile ps_2_0 Fill(1, 0, 0, 1); }";
  EXPECT_RGBA(Draw(passes).at(0, 0), 1, 0, 0, 1);
}

// Drivers round the curve to a step of 8 bits.
constexpr float kSrgbStep = 1.0f / 255;

TEST(RenderState, SrgbWritesEncode) {
  const std::string text =
      "texture PASS0_A8R8G8B8; sampler s = sampler_state { Texture = <PASS0_A8R8G8B8>; };\n"
      "float4 Write() : COLOR { return float4(0.5, 0.2140411, 0, 0.5); }\n"
      "float4 Read(float2 uv : TEXCOORD0) : COLOR { return tex2D(s, uv); }\n"
      "technique T < string ColorSpace = \"linear\"; > { pass A { SRGBWriteEnable = true; PixelShader = compile ps_2_0 Write(); }"
      " pass B { PixelShader = compile ps_2_0 Read(); } }";
  EXPECT_TRUE(Near(RunText(text, 1, 1).at(0, 0), {0.735357f, 0.5f, 0, 0.5f}, kSrgbStep));
}

TEST(RenderState, SrgbTexturesDecode) {
  const std::string text =
      "texture PASS0_A8R8G8B8; sampler s = sampler_state { Texture = <PASS0_A8R8G8B8>; SRGBTexture = true; };\n"
      "float4 Write() : COLOR { return float4(188.0 / 255, 0, 1, 0.5); }\n"
      "float4 Read(float2 uv : TEXCOORD0) : COLOR { return tex2D(s, uv); }\n"
      "technique T < string ColorSpace = \"linear\"; > { pass A { PixelShader = compile ps_2_0 Write(); }"
      " pass B { PixelShader = compile ps_2_0 Read(); } }";
  EXPECT_TRUE(Near(RunText(text, 1, 1).at(0, 0), {0.502886f, 0, 1, 0.5f}, kSrgbStep));
}

TEST(RenderState, ExpressionsOverParametersAreEvaluated) {
  const std::string passes =
      "pass A { ColorWriteEnable = <mask>; AlphaBlendEnable = (amount > 1); SrcBlend = Zero; PixelShader = compile ps_2_0 "
      "Fill(1, 1, 1, 1); }";
  const std::string globals = "int mask = 15; float amount = 0;\n";
  EXPECT_RGBA(Draw(passes, {}, globals).at(0, 0), 1, 1, 1, 1);
  EXPECT_RGBA(Draw(passes, {{"mask", "5"}}, globals).at(0, 0), 1, 0, 1, 0);
  EXPECT_RGBA(Draw(passes, {{"amount", "2"}}, globals).at(0, 0), 0, 0, 0, 0);
}

TEST(RenderState, ScissorIsIgnoredWithAWarning) {
  Bench bench(CompileText(Technique("pass A { ScissorTestEnable = true; PixelShader = compile ps_2_0 Fill(1, 1, 1, 1); }")), 1,
              1);
  EXPECT_RGBA(bench.RunPixels().at(0, 0), 1, 1, 1, 1);
  ASSERT_TRUE(bench.runner);
  ASSERT_EQ(bench.runner->warnings().size(), 1u);
  EXPECT_EQ(bench.runner->warnings()[0],
            "test.fx: technique 'T', pass 'A': ScissorTestEnable is ignored: there is no scissor rectangle");
}

TEST(RenderState, WireframeDrawsEdgesOnly) {
  const std::string text =
      Technique("pass A { FillMode = Wireframe; PixelShader = compile ps_2_0 Fill(1, 1, 1, 1); }");
  const PixelMap frame = RunText(text, 16, 16);
  int drawn = 0;
  for (const Rgba& pixel : frame.pixels) drawn += pixel[0] == 1.0f;
  EXPECT_GT(drawn, 0);
  EXPECT_LT(drawn, 16 * 16 / 2);
}

}  // namespace
}  // namespace burin::effect
