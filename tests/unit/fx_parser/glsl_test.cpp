// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fx_parser/glsl/interface.h"
#include "fx_parser/glsl/names.h"
#include "fx_parser/glsl/prelude.h"
#include "fx_parser/glsl/semantic.h"
#include "fx_parser/glsl/text.h"
#include "tests/unit/fx_parser/compile_effect.h"

namespace burin::fx {
namespace {

using test::Compile;
using test::Messages;

void ExpectValid(const CompileResult& result, const std::string& what) {
  ASSERT_TRUE(result.effect) << what << "\n" << Messages(result);
  if (!test::HasGlslang()) GTEST_SKIP() << "glslangValidator is not installed";
  for (const Technique& technique : result.effect->techniques) {
    for (const Pass& pass : technique.passes) {
      if (!technique.unsupported.empty()) continue;
      EXPECT_EQ(test::GlslLog(pass.program), "") << what;
    }
  }
}

/// The pixel shader's text for a body.
std::string Fragment(const std::string& body, const std::string& declarations = "") {
  const CompileResult result = Compile(test::PixelEffect(body, declarations));
  EXPECT_TRUE(result.effect) << Messages(result);
  if (!result.effect) return "";
  const ShaderProgram& program = result.effect->techniques[0].passes[0].program;
  if (test::HasGlslang()) {
    EXPECT_EQ(test::GlslLog(program), "") << body;
  }
  return program.fragment_glsl;
}

class Corpus : public testing::TestWithParam<const char*> {};

TEST_P(Corpus, GivesValidGlsl) {
  DiskFileSystem files;
  Options options;
  options.attributes = test::Attributes();
  ExpectValid(CompileEffect(test::DataFile(GetParam()), files, options), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Files, Corpus,
                         testing::Values("figure2.fx", "language.fx", "intrinsics.fx", "stages.fx", "specialise.fx",
                                         "names.fx", "branches.fx"),
                         [](const auto& file) {
                           const std::string name = file.param;
                           return name.substr(0, name.find('.'));
                         });

TEST(Glsl, VertexInputLocationsAreThoseOfTheHost) {
  EXPECT_EQ(VertexInputLocation("POSITION0"), 0);
  EXPECT_EQ(VertexInputLocation("POSITION"), 0);
  EXPECT_EQ(VertexInputLocation("BLENDINDICES0"), 7);
  EXPECT_EQ(VertexInputLocation("TEXCOORD0"), 8);
  EXPECT_EQ(VertexInputLocation("TEXCOORD7"), 15);
  EXPECT_EQ(VertexInputLocation("TEXCOORD8"), std::nullopt);
  EXPECT_EQ(VertexInputLocation("POSITION1"), std::nullopt);
  EXPECT_EQ(VertexInputLocation("SOMETHING"), std::nullopt);
}

TEST(Glsl, SemanticsHaveIndicesAndAliases) {
  EXPECT_EQ(ParseSemantic("texcoord3"), (Semantic{"TEXCOORD", 3}));
  EXPECT_EQ(ParseSemantic("Color"), (Semantic{"COLOR", 0}));
  EXPECT_EQ(ParseSemantic("SV_Target2"), (Semantic{"COLOR", 2}));
  EXPECT_EQ(ParseSemantic("SV_Position"), (Semantic{"POSITION", 0}));
  EXPECT_EQ(ParseSemantic("HPOS"), (Semantic{"POSITION", 0}));
  EXPECT_EQ(ParseSemantic("TEXCOORD99999999999"), (Semantic{"TEXCOORD", 9999}));
}

TEST(Glsl, NumbersReadBackExactly) {
  EXPECT_EQ(NumberText(1, Scalar::kFloat), "1.0");
  EXPECT_EQ(NumberText(-0.5, Scalar::kFloat), "(-0.5)");
  EXPECT_EQ(NumberText(1e30, Scalar::kFloat), "1e+30");
  EXPECT_EQ(NumberText(1e300, Scalar::kFloat), "3.40282347e+38");
  EXPECT_EQ(NumberText(-2147483648.0, Scalar::kInt), "(-2147483647 - 1)");
  EXPECT_EQ(NumberText(4294967295.0, Scalar::kUint), "4294967295u");
  EXPECT_EQ(NumberText(2, Scalar::kBool), "true");
}

TEST(Glsl, NamesNeverCollide) {
  NameTable names;
  EXPECT_EQ(names.Unique("l_", "x"), "l_x");
  EXPECT_EQ(names.Unique("l_", "x"), "l_x_1");
  EXPECT_EQ(names.Unique("l_", "a__b"), "l_a_b");
  EXPECT_EQ(names.Unique("l_", "ns::f"), "l_ns_f");
  EXPECT_EQ(GlslMemberName("sample"), "m_sample");
  EXPECT_EQ(GlslMemberName("color"), "color");
}

TEST(Glsl, LiteralsOfEntryArgumentsReachTheCall) {
  const CompileResult result = Compile(
      "texture a; texture b;\nsampler sa = sampler_state { Texture = <a>; }; sampler sb = sampler_state { Texture = "
      "<b>; };\n"
      "float k;\nfloat4 PS(float2 t : TEXCOORD0, uniform sampler2D s, uniform float n, uniform bool on) : COLOR { "
      "return on ? tex2D(s, t) * n : 0; }\n"
      "technique T { pass A { PixelShader = compile ps_2_0 PS(sa, 2, true); } pass B { PixelShader = compile ps_2_0 "
      "PS(sb, k * 2, false); } }");
  ASSERT_TRUE(result.effect) << Messages(result);
  const auto& passes = result.effect->techniques[0].passes;
  EXPECT_NE(passes[0].program.fragment_glsl.find("f_PS(a_t, 2.0, true)"), std::string::npos)
      << passes[0].program.fragment_glsl;
  EXPECT_NE(passes[0].program.fragment_glsl.find("texture(burin_s_sa, l_t)"), std::string::npos);
  EXPECT_EQ(passes[0].program.samplers, std::vector<std::size_t>{0});
  EXPECT_TRUE(passes[0].program.parameters.empty());
  EXPECT_NE(passes[1].program.fragment_glsl.find("f_PS(a_t, (burin_p_k * 2.0), false)"), std::string::npos);
  EXPECT_EQ(passes[1].program.samplers, std::vector<std::size_t>{1});
  EXPECT_EQ(passes[1].program.parameters, std::vector<std::size_t>{0});
}

TEST(Glsl, MatricesAreRowsInGlslsColumns) {
  const std::string text = Fragment("return mul(t, m) + mul(m, t) + m[1] + m._m23;", "float4x4 m; float2x3 n;");
  EXPECT_NE(text.find("uniform mat4x4 burin_p_m;"), std::string::npos) << text;
  EXPECT_NE(text.find("(burin_p_m * l_t)"), std::string::npos) << text;
  EXPECT_NE(text.find("(l_t * burin_p_m)"), std::string::npos) << text;
  EXPECT_NE(text.find("burin_p_m[2].w"), std::string::npos) << text;
  EXPECT_NE(Fragment("return mul(t.xy, n).xyzz;", "float2x3 n;").find("uniform mat2x3 burin_p_n;"), std::string::npos);
}

TEST(Glsl, OnlyReachableThingsAreWritten) {
  const std::string text = Fragment(
      "return Used(t);",
      "float unusedParameter; float4 Unused() { return unusedParameter; } float4 Used(float4 v) { return v; }");
  EXPECT_EQ(text.find("nused"), std::string::npos) << text;
}

TEST(Glsl, UnwrittenVariablesReadAsZero) {
  EXPECT_NE(Fragment("float4 v; return v;").find("vec4 l_v = vec4(0.0);"), std::string::npos);
}

TEST(Glsl, ArithmeticThatGlslLeavesUndefinedGoesThroughHelpers) {
  EXPECT_NE(Fragment("return t / t.x;").find("burin_div("), std::string::npos);
  EXPECT_NE(Fragment("return t / 2;").find("(l_t / 2.0)"), std::string::npos);
  EXPECT_NE(Fragment("return pow(t, 2);").find("burin_pow("), std::string::npos);
  EXPECT_NE(Fragment("return sqrt(t);").find("burin_sqrt("), std::string::npos);
  EXPECT_NE(Fragment("return normalize(t);").find("burin_normalize("), std::string::npos);
  EXPECT_NE(Fragment("int i = t.x; return i % 3;").find("burin_imod("), std::string::npos);
  EXPECT_NE(Fragment("float a[3] = { 1, 2, 3 }; return a[(int)t.x];").find("clamp(int(l_t.x), 0, 2)"),
            std::string::npos);
}

TEST(Glsl, LogicEvaluatesBothSides) {
  const std::string declarations = "static int n = 0; bool F() { n++; return true; }";
  EXPECT_NE(Fragment("bool b = t.x > 0 && F(); return b + n;", declarations).find("burin_and("), std::string::npos);
  EXPECT_NE(Fragment("bool b = t.x > 0 && t.y > 0; return b;").find(" && "), std::string::npos);
  EXPECT_NE(Fragment("return t.x > 0 ? tex2D(s, t.xy) : 1;", "sampler s;").find("burin_select("), std::string::npos);
}

TEST(Glsl, VertexColoursAreClampedBeforeShaderModel3) {
  const auto vertex = [](const std::string& profile) {
    const CompileResult result = Compile(
        "float4 VS(float4 p : POSITION, out float4 c : COLOR0) : POSITION { c = p * 3; return p; }\nfloat4 PS(float4 c "
        ": COLOR0) : COLOR { return c; }\n"
        "technique T { pass P { VertexShader = compile " +
        profile + " VS(); PixelShader = compile ps_2_0 PS(); } }");
    return result.effect ? result.effect->techniques[0].passes[0].program.vertex_glsl : Messages(result);
  };
  EXPECT_NE(vertex("vs_2_0").find("burin_v_COLOR0 = burin_saturate(a_c);"), std::string::npos) << vertex("vs_2_0");
  EXPECT_NE(vertex("vs_3_0").find("burin_v_COLOR0 = a_c;"), std::string::npos);
}

TEST(Glsl, StagesLinkThroughWhatThePixelShaderReads) {
  const CompileResult result = Compile(
      "struct O { float4 p : POSITION; float2 a : TEXCOORD0; float3 b : TEXCOORD5; };\nO VS(float4 p : POSITION) { O "
      "o; o.p = p; o.a = 1; o.b = 2; return o; }\n"
      "float4 PS(float3 b : TEXCOORD5, float4 c : TEXCOORD7) : COLOR { return c + b.x; }\n"
      "technique T { pass P { VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(); } }");
  ExpectValid(result, "link");
  const std::string& text = result.effect->techniques[0].passes[0].program.vertex_glsl;
  EXPECT_NE(text.find("layout(location = 0) out vec4 burin_v_TEXCOORD5;"), std::string::npos) << text;
  EXPECT_NE(text.find("burin_v_TEXCOORD7 = vec4(0.0);"), std::string::npos) << text;
  EXPECT_EQ(text.find("burin_v_TEXCOORD0"), std::string::npos) << text;
}

TEST(Glsl, MissingStagesAreFilledIn) {
  const CompileResult result = Compile(
      "float4 PS(float2 t : TEXCOORD3, float4 c : COLOR0) : COLOR { return c + t.x; }\ntechnique T { pass P { "
      "PixelShader = compile ps_2_0 PS(); } pass Q { } }");
  ExpectValid(result, "missing stages");
  const auto& passes = result.effect->techniques[0].passes;
  EXPECT_EQ(passes[0].program.vertex_inputs, (std::vector<std::string>{"POSITION0", "TEXCOORD3"}));
  EXPECT_NE(passes[0].program.vertex_glsl.find("burin_v_TEXCOORD3 = burin_in_TEXCOORD3;"), std::string::npos);
  EXPECT_NE(passes[0].program.vertex_glsl.find("burin_v_COLOR0 = vec4(1.0);"), std::string::npos);
  EXPECT_EQ(passes[1].program.targets, 1);  // the fixed pipeline's
}

TEST(Glsl, AlphaTestIsWrittenWhenTheStatesSwitchItOn) {
  const auto program = [](const std::string& states) {
    const CompileResult result = Compile(
        "bool on;\nfloat4 PS() : COLOR { return 1; }\ntechnique T { pass P { PixelShader = compile ps_2_0 PS(); " +
        states + " } }");
    EXPECT_TRUE(result.effect) << Messages(result);
    return result.effect->techniques[0].passes[0].program;
  };
  EXPECT_FALSE(program("").alpha_test);
  EXPECT_FALSE(program("AlphaTestEnable = false; AlphaRef = 3;").alpha_test);
  EXPECT_TRUE(program("AlphaTestEnable = true;").alpha_test);
  EXPECT_TRUE(program("AlphaTestEnable = <on>;").alpha_test) << "the host decides at each pass";
  EXPECT_NE(program("AlphaTestEnable = true;").fragment_glsl.find("uniform vec2 burin_alpha_test;"), std::string::npos);
}

TEST(Glsl, BranchesWithLookUpsRunOnBothSides) {
  const std::string flat = Fragment("float4 r = 0; if (t.x > 0) r = tex2D(s, t.xy); return r;", "sampler s;");
  EXPECT_EQ(flat.find("if (l_t.x > 0.0"), std::string::npos) << flat;
  EXPECT_NE(flat.find("l_r = texture(burin_s_s, l_t.xy);"), std::string::npos) << flat;
  EXPECT_NE(Fragment("float4 r = 0; if (k > 0) r = tex2D(s, t.xy); return r;", "sampler s; float k;")
                .find("if (burin_p_k > 0.0) {"),
            std::string::npos);
  EXPECT_NE(Fragment("if (t.x > 0) return tex2D(s, t.xy); return 1;", "sampler s;").find("if ("), std::string::npos);
}

TEST(Glsl, TwoRunsGiveOneText) {
  const std::string body =
      "float4 a = t, b = t, c = t; if (t.x > 0) { a = tex2D(s, t.xy); b = a * k; c = b + j; } return a + b + c;";
  EXPECT_EQ(Fragment(body, "sampler s; float k; float j;"), Fragment(body, "sampler s; float k; float j;"));
}

TEST(Glsl, GrowthIsBounded) {
  // Each function calls the next with two samplers: 2^30 instances if nobody stopped.
  std::string text =
      "sampler a; sampler b;\nfloat4 F0(sampler s, sampler r, float2 t) { return tex2D(s, t) + tex2D(r, t); }\n";
  for (int i = 1; i <= 30; ++i) {
    const std::string before = "F" + std::to_string(i - 1);
    text += "float4 F" + std::to_string(i) + "(sampler s, sampler r, float2 t) { return " + before + "(s, r, t) + " +
            before + "(r, s, t); }\n";
  }
  text +=
      "float4 PS(float2 t : TEXCOORD0) : COLOR { return F30(a, b, t); }\ntechnique T { pass P { PixelShader = compile "
      "ps_3_0 PS(); } }";
  EXPECT_TRUE(Compile(text).effect) << "two instances a function are enough";
  std::string deep = "float4 F0(float4 v) { return v; }\n";
  for (int i = 1; i <= 2000; ++i)
    deep += "float4 F" + std::to_string(i) + "(float4 v) { return F" + std::to_string(i - 1) + "(v); }\n";
  deep +=
      "float4 PS(float4 t : TEXCOORD0) : COLOR { return F2000(t); }\ntechnique T { pass P { PixelShader = compile "
      "ps_3_0 PS(); } }";
  EXPECT_NE(Messages(deep).find("calls nested too deeply [B1013]"), std::string::npos);
}

}  // namespace
}  // namespace burin::fx
