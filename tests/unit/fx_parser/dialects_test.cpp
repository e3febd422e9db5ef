// SPDX-License-Identifier: Apache-2.0
// Small effects in the style of Direct3D 9's samples, FX Composer's library and CgFX, and what those dialects differ
// in.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "fx_parser/source/legacy_encoding.h"
#include "tests/unit/fx_parser/compile_effect.h"

namespace burin::fx {
namespace {

using test::Messages;

TEST(Dialects, FilesCompileToValidGlsl) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(test::DataFile("dialects")))
    paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  EXPECT_GE(paths.size(), 22u);
  Options options;
  options.attributes = test::Attributes();
  for (const std::string& path : paths) {
    const CompileResult result = CompileEffect(path, DiskFileSystem(), options);
    ASSERT_TRUE(result.effect) << path << "\n" << Messages(result);
    for (const Technique& technique : result.effect->techniques) {
      EXPECT_TRUE(technique.unsupported.empty()) << path;
      for (const Pass& pass : technique.passes) {
        if (test::HasGlslang()) EXPECT_EQ(test::GlslLog(pass.program), "") << path;
      }
    }
  }
}

TEST(Dialects, CgsLookUpsSayWhatTheyReturn) {
  const CompileResult result = test::Compile(test::PixelEffect(
      "return float4(f1tex2D(s, t.xy), h3tex2D(s, t.xy)) + f4tex2D(s, t.xy) + texRECT(r, t.xy) + tex2Dproj(s, t.xyz);",
      "sampler2D s; samplerRECT r;"));
  EXPECT_EQ(Messages(result), "");
  ASSERT_TRUE(result.effect);
  const ShaderProgram& program = result.effect->techniques[0].passes[0].program;
  EXPECT_NE(program.fragment_glsl.find("textureSize(burin_s_r, 0)"), std::string::npos);
  if (test::HasGlslang()) EXPECT_EQ(test::GlslLog(program), "");
}

TEST(Dialects, InterfacesCostOnlyTheTechniquesThatCallThem) {
  const CompileResult result = test::Compile(
      "interface Light { float3 Shine(float3 p); };\n"
      "struct Lamp : Light { float3 at; float3 Shine(float3 p) { return at - p; } };\n"
      "Lamp lamp = { 1, 2, 3 }; Light one = lamp;\nLight lights[];\n"
      "float4 Lit(float3 p : TEXCOORD0) : COLOR { float3 sum = 0;\n"
      "  for (int i = 0; i < lights.length; i++) sum += lights[i].Shine(p); return float4(sum, 1); }\n"
      "float4 Plain() : COLOR { return float4(lamp.at, 1); }\n"
      "technique A { pass P { PixelShader = compile ps_2_0 Lit(); } }\n"
      "technique B { pass P { PixelShader = compile ps_2_0 Plain(); } }");
  EXPECT_EQ(
      Messages(result),
      "4:1: warning: an array without a size gets it from a host, which this one has no means to choose: it has one "
      "element [B1025]\n"
      "8:11: warning: technique 'A' cannot run here: pass 'P': function 'Lit' calls a struct's function 'Shine' "
      "[B1026]\n");
  ASSERT_TRUE(result.effect);
  EXPECT_TRUE(result.effect->techniques[1].unsupported.empty());
  EXPECT_EQ(Messages("struct S { float f(float x); }; S s; float4 PS() : COLOR { return s.g(1); }"),
            "1:69: error: 'S' has no function 'g' that takes (int) [X3018]\n");
}

TEST(Dialects, AsmInAFunctionCostsOnlyTheTechniquesThatRunIt) {
  const CompileResult result = test::Compile(
      "sampler s; float4 Fetch(float2 t) { float4 r; asm { tfetch2D r, t, s, OffsetX=-0.5 }; [isolate] { r += 1; } "
      "return r; }\n"
      "float4 A(float2 t : TEXCOORD0) : COLOR { return Fetch(t); } float4 B() : COLOR { return 1; }\n"
      "technique A { pass { PixelShader = compile ps_3_0 A(); } } technique B { pass { PixelShader = compile ps_3_0 "
      "B(); "
      "} }");
  EXPECT_EQ(Messages(result),
            "3:11: warning: technique 'A' cannot run here: pass 0: asm in function 'Fetch' [B1026]\n");
  ASSERT_TRUE(result.effect);
  EXPECT_TRUE(result.effect->techniques[1].unsupported.empty());
}

TEST(Dialects, FragmentsAndObjectsOfOtherModelsOnlyCheck) {
  EXPECT_EQ(Messages("float4 F(float4 c : COLOR0) : COLOR0 { return c; }\n"
                     "pixelfragment f = compile_fragment ps_2_0 F();\nTexture2DArray a; RWTexture2D<float4> w;\n"
                     "Texture2DMS<float4, 4> m; GeometryShader g = CompileShader(gs_4_0, G());\n"
                     "float4 S(SamplerState s) { return a.Sample(s, float3(1, 2, 3)) + m.Load(int2(1, 2), 0); }\n"
                     "float buffer; float4 Buffers() { return buffer; }"),
            "");
}

TEST(Dialects, LookUpsByTextureAndSamplerArePairs) {
  const CompileResult result = test::Compile(
      "Texture2D a; Texture2D<float2> b; TextureCube c;\n"
      "SamplerState s { AddressU = Clamp; }; SamplerState t[2];\n"
      "float4 Look(Texture2D x, SamplerState y, float2 uv) { return x.SampleLevel(y, uv, 1); }\n"
      "float4 VS(float4 p : POSITION) : POSITION { return p + a.Sample(s, p.xy); }\n"
      "float4 PS(float4 uv : TEXCOORD0) : COLOR { return a.Sample(s, uv) + b.Sample(s, uv.xy).yyxx + "
      "c.SampleBias(t[1], uv.xyz, 1) + Look(a, s, uv.xy) + a.SampleGrad(s, uv.xy, uv.zw, 0); }\n"
      "technique T { pass { VertexShader = compile vs_4_0_level_9_1 VS(); PixelShader = compile ps_4_0 PS(); } }");
  ASSERT_TRUE(result.effect) << Messages(result);
  const ShaderProgram& program = result.effect->techniques[0].passes[0].program;
  std::vector<std::string> pairs;
  for (const std::size_t index : program.samplers) {
    const Sampler& sampler = result.effect->samplers[index];
    pairs.push_back(sampler.name + " " + (sampler.texture ? result.effect->textures[*sampler.texture].name : "none"));
  }
  EXPECT_EQ(pairs, (std::vector<std::string>{"a_with_s a", "b_with_s b", "c_with_t_1 c"}));
  EXPECT_EQ(result.effect->samplers[program.samplers[0]].states.size(), 1u);
  EXPECT_EQ(result.effect->samplers[program.samplers[2]].dimension, Dimension::kCube);
  if (test::HasGlslang()) EXPECT_EQ(test::GlslLog(program), "");
  EXPECT_EQ(Messages("Texture2D a; float4 f() { return a.Sampel(1); }"),
            "1:36: error: 'texture2D' has no function 'Sampel' that takes (int) [X3018]\n");
}

TEST(Dialects, NamespacesKeepNamesApart) {
  const CompileResult result = test::Compile(
      "namespace A { uniform float level = 2; texture t; sampler s { Texture = t; };\n"
      "  float4 Look(float2 uv) { return tex2D(s, uv) * level; }\n"
      "  float4 PS(float2 uv : TEXCOORD0) : COLOR { return Look(uv); } }\n"
      "namespace B { float level = 3; float4 Look(float2 uv) { return A::Look(uv) * level * A::level; }\n"
      "  float4 PS(float2 uv : TEXCOORD0) : COLOR { return Look(uv); }\n"
      "  technique T { pass { PixelShader = compile ps_3_0 PS(); } } }");
  EXPECT_EQ(Messages(result), "");
  ASSERT_TRUE(result.effect);
  EXPECT_EQ(result.effect->parameters[0].name, "A_level");
  EXPECT_EQ(result.effect->parameters[1].name, "B_level");
  EXPECT_EQ(result.effect->samplers[0].name, "A_s");
  const ShaderProgram& program = result.effect->techniques[0].passes[0].program;
  EXPECT_EQ(program.parameters.size(), 2u);
  if (test::HasGlslang()) EXPECT_EQ(test::GlslLog(program), "");
}

TEST(Dialects, SamplerArraysTakeIndicesOfTheCompileExpression) {
  const std::string declarations =
      "sampler s[3]; float4 PS(float2 t : TEXCOORD0, uniform int i) : COLOR { return tex2D(s[i + 1], t); }\n";
  const CompileResult result =
      test::Compile(declarations + "technique T { pass P { PixelShader = compile ps_2_0 PS(1); } }");
  EXPECT_EQ(Messages(result), "");
  ASSERT_TRUE(result.effect);
  ASSERT_EQ(result.effect->techniques[0].passes[0].program.samplers.size(), 1u);
  EXPECT_EQ(result.effect->samplers[result.effect->techniques[0].passes[0].program.samplers[0]].name, "s[2]");
  EXPECT_EQ(Messages(declarations + "technique T { pass P { PixelShader = compile ps_2_0 PS(2); } }"),
            "1:87: error: index out of bounds: 's' is a sampler[3] [X3504]\n");
}

TEST(Dialects, WithoutAPixelShaderTheDiffuseColourIsDrawn) {
  const std::string vertex = "float4 VS(float4 p : POSITION, out float4 c : COLOR0) : POSITION { c = p; return p; }\n";
  for (const char* states : {"PixelShader = NULL;", "",
                             "ColorOp[0] = SelectArg1; ColorArg1[0] = Diffuse; ColorOp[1] = "
                             "Disable; Texture[0] = NULL; MinFilter[0] = Linear;"}) {
    const CompileResult result =
        test::Compile(vertex + "technique T { pass P { VertexShader = compile vs_2_0 VS(); " + states + " } }");
    ASSERT_TRUE(result.effect) << Messages(result);
    const Technique& technique = result.effect->techniques[0];
    EXPECT_TRUE(technique.unsupported.empty());
    EXPECT_EQ(technique.passes[0].program.targets, 1);
    if (test::HasGlslang()) EXPECT_EQ(test::GlslLog(technique.passes[0].program), "");
  }
  const CompileResult textured =
      test::Compile("texture t; " + vertex +
                    "technique T { pass P { VertexShader = compile vs_2_0 VS(); Texture[0] = <t>; "
                    "ColorOp[0] = Modulate; } }");
  ASSERT_TRUE(textured.effect);
  const Pass& pass = textured.effect->techniques[0].passes[0];
  ASSERT_EQ(pass.program.samplers.size(), 1u);
  EXPECT_EQ(textured.effect->samplers[pass.program.samplers[0]].texture, 0u);
  EXPECT_TRUE(pass.fixed && pass.fixed->is_pixel && !pass.fixed->is_vertex);
  if (test::HasGlslang()) {
    EXPECT_EQ(test::GlslLog(pass.program), "");
  }
}

TEST(ProceduralTextures, NeedAFunctionWithSemantics) {
  const std::string use =
      "float4 PS() : COLOR { return 1; } technique T { pass { PixelShader = compile ps_2_0 PS(); } }";
  EXPECT_EQ(
      Messages("texture t < string function = \"Mak\"; >; float4 Make(float2 p : POSITION) : COLOR { return 1; }" +
               use),
      "1:9: warning: texture 't': there is no function 'Mak' to fill it; did you mean 'Make'? [B1022]\n");
  EXPECT_EQ(Messages("texture t < string function = \"Make\"; >; float4 Make(float2 p) : COLOR { return 1; }" + use),
            "1:9: warning: texture 't': 'Make' cannot fill it: its parameters and result need semantics [B1022]\n");
}

TEST(LegacyEncoding, TellsJapaneseFromEuropeanBytes) {
  EXPECT_TRUE(IsUtf8("caf\xC3\xA9 \xE8\xA1\xA8"));
  EXPECT_FALSE(IsUtf8("caf\xE9"));
  EXPECT_TRUE(LooksLikeCp932("// \x95\x5C\x8E\xA6"));
  EXPECT_FALSE(LooksLikeCp932("// caf\xE9 \xA9 f\xFCr"));
  EXPECT_FALSE(LooksLikeCp932("// \x93quoted\x94 text"));
  EXPECT_EQ(Utf8FromCp932("\x95\x5C\x8E\xA6"), "\xE8\xA1\xA8\xE7\xA4\xBA");
}

// The second byte of the first character is a backslash, at the end of a line and before a quotation mark.
TEST(LegacyEncoding, BackslashesInsideCharactersAreNone) {
  const CompileResult result = test::Compile("// \x95\x5C\nfloat a < string UIName = \"\x83\x5C\"; > = 1;\n");
  EXPECT_EQ(Messages(result), "");
  ASSERT_TRUE(result.effect);
  EXPECT_EQ(result.effect->parameters.at(0).annotations.at(0).value.strings.at(0), "\xE3\x82\xBD");
}

TEST(LegacyEncoding, TheEndMarkOfDosEndsTheText) { EXPECT_EQ(Messages("float a;\n\x1A\x1A@@"), ""); }

}  // namespace
}  // namespace burin::fx
