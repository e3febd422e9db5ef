// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

TEST(ParserTechnique, ReadsPassesAndAnnotations) {
  EXPECT_EQ(DumpText("technique T0 < string Script = \"Pass=P0;\"; > {\n pass P0 < bool b = true; > { ZEnable = true; "
                     "}\n pass { }\n}"),
            "(technique T0 <string Script=\"Pass=P0;\"> (pass P0 <bool b=true> ZEnable=true) (pass))");
}

TEST(ParserTechnique, TakesItsWordsInAnyCase) {
  EXPECT_EQ(DumpText("TECHNIQUE A { Pass P { } }; Technique10 B { PASS P { } };technique11 { }"),
            "(technique A (pass P))\n(technique10 B (pass P))\n(technique11)");
}

TEST(ParserTechnique, ReadsStateValuesAsWritten) {
  EXPECT_EQ(DumpText("technique T { pass P { CullMode = None; FillMode = <fill>; AlphaRef = (ref + 1); ZBias = 0x10; "
                     "ColorWriteEnable = RED | GREEN|blue; TextureFactor = { 1, 0.5 }; Lighting = FALSE; } }"),
            "(technique T (pass P CullMode=None FillMode=<fill> AlphaRef=((+ ref 1)) ZBias=16 "
            "ColorWriteEnable=(| (| RED GREEN) blue) TextureFactor={ 1 0.5f } Lighting=false))");
}

TEST(ParserTechnique, TellsAParenthesisedValueFromOneThatOnlyBeginsSo) {
  EXPECT_EQ(DumpText("technique T { pass P { A = (a) + (b); B = (float)c; C = ((d)); D = (e)\n} }"),
            "1:71 error: expected ';' after render state [X3000]\n");
  EXPECT_EQ(DumpText("technique T { pass P { A = (a) + (b); B = (float)c; C = ((d)); } }"),
            "(technique T (pass P A=(+ a b) B=(cast float c) C=(d)))");
}

TEST(ParserTechnique, ReadsIndexedStates) {
  EXPECT_EQ(DumpText("technique T { pass P { ColorOp[0] = SelectArg1; Texture[n + 1] = <t>; Sampler[0] = (s); "
                     "ColorArg1[0] = Texture; } }"),
            "(technique T (pass P ColorOp[0]=SelectArg1 Texture[(+ n 1)]=<t> Sampler[0]=(s) ColorArg1[0]=Texture))");
}

TEST(ParserTechnique, ReadsShaderStates) {
  EXPECT_EQ(
      DumpText("technique T { pass P { VertexShader = compile vs_1_1 V(); PIXELSHADER = COMPILE ps_2_0 F(1, t); } "
               "pass Q { VertexShader = NULL; PixelShader = (shaders[i]); } "
               "pass R { PixelShader = asm { ps_1_1 tex t0 }; } }"),
      "(technique T (pass P VertexShader=(compile vs_1_1 V) PIXELSHADER=(compile ps_2_0 F 1 t)) "
      "(pass Q VertexShader=NULL PixelShader=(([] shaders i))) (pass R PixelShader=(asm 'ps_1_1 tex t0')))");
}

TEST(ParserTechnique, ReadsDirect3D10Calls) {
  EXPECT_EQ(DumpText("technique10 T { pass P { SetVertexShader(CompileShader(vs_4_0, V())); SetGeometryShader(NULL); "
                     "SetBlendState(b, float4(0,0,0,0), 0xFF); } }"),
            "(technique10 T (pass P SetVertexShader((compile vs_4_0 V)) SetGeometryShader(NULL) "
            "SetBlendState(b (new float4 0 0 0 0) 255)))");
}

TEST(ParserTechnique, ToleratesExtraSemicolons) {
  EXPECT_EQ(DumpText("technique T { pass P { ; ZEnable = true;; }; };;"), "(technique T (pass P ZEnable=true))");
}

TEST(ParserTechnique, PutsAMissingSemicolonAfterItsState) {
  EXPECT_EQ(DumpText("technique T {\n pass P {\n  ZEnable = true\n  CullMode = None;\n } }"),
            "3:17 error: expected ';' after render state [X3000]\n");
}

TEST(ParserTechnique, ReportsEachFaultyStateAndKeepsTheOthers) {
  const auto parsed =
      ParseText("technique T { pass P { ZEnable true; CullMode = ; AlphaRef = 3; 7 = 8; ZFunc = Less; } pass Q { } }");
  EXPECT_EQ(parsed->Messages(),
            "1:32 error: expected '=' after render state 'ZEnable', found 'true' [X3000]\n"
            "1:49 error: expected an expression, found ';' [X3000]\n"
            "1:65 error: expected a render state or '}', found '7' [X3000]\n");
  EXPECT_EQ(Dump(parsed->module), "(technique T (pass P AlphaRef=3 ZFunc=Less) (pass Q))");
}

TEST(ParserTechnique, ReportsAnUnclosedAngle) {
  EXPECT_EQ(DumpText("sampler s = sampler_state { Texture = <t; };"),
            "1:41 error: expected '>' after the value, found ';' [X3000]\n  1:39 to match this\n");
}

TEST(ParserTechnique, ReportsAFaultInASamplerStateBlock) {
  EXPECT_EQ(DumpText("sampler s = sampler_state {\n  Texture = <t>\n  MinFilter = LINEAR;\n};\nfloat x"),
            "2:16 error: expected ';' after sampler state [X3000]\n5:8 error: expected ';' after declaration of 'x' "
            "[X3000]\n");
}

TEST(ParserTechnique, ReportsWhatIsNoPass) {
  EXPECT_EQ(
      DumpText("technique T { ZEnable = true; pass P { } }"),
      "1:15 error: expected 'pass' or '}' in technique 'T' (states stand inside a pass), found 'ZEnable' [X3000]\n");
  EXPECT_EQ(DumpText("technique T < string a = \"x\"; > ;"),
            "1:33 error: expected '{' to begin technique 'T', found ';' [X3000]\n");
}

TEST(ParserTechnique, ReportsAMissingBraceOfAPassAtTheNextPass) {
  EXPECT_EQ(DumpText("technique T {\n pass P {\n  ZEnable = true;\n pass Q { }\n}"),
            "4:2 error: expected '}' to end pass 'P', found 'pass' [X3000]\n  2:9 to match this\n");
}

TEST(ParserTechnique, ReportsAMissingBraceAtTheNextTechnique) {
  EXPECT_EQ(DumpText("technique T {\n pass P { }\ntechnique U { pass P { } }"),
            "3:1 error: expected '}' to end technique 'T', found 'technique' [X3000]\n  1:13 to match this\n");
}

TEST(ParserTechnique, ReportsABrokenCompileExpression) {
  EXPECT_EQ(DumpText("technique T { pass P { PixelShader = compile ps_2_0; } }"),
            "1:52 error: expected the name of a function to compile for 'ps_2_0', found ';' [X3000]\n");
}

}  // namespace
}  // namespace burin::fx::test
