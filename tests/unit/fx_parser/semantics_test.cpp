// SPDX-License-Identifier: Apache-2.0
// The exact text and place of every message about names, types and flow.
#include <gtest/gtest.h>

#include <functional>

#include "tests/unit/fx_parser/compile_effect.h"

namespace burin::fx {
namespace {

using test::Messages;

/// The messages about statements in a function `float4 F(float4 v)`, whose body starts in line 2.
std::string InFunction(const std::string& body, const std::string& declarations = "") {
  return Messages(declarations + "float4 F(float4 v) {\n" + body + "\nreturn v; }");
}

TEST(Names, UndeclaredOnesSuggestTheNearest) {
  EXPECT_EQ(InFunction("float weight = 1; v *= wieght;"),
            "2:24: error: undeclared identifier 'wieght'; did you mean 'weight'? [X3004]\n");
  EXPECT_EQ(InFunction("v = qqqqqqq;"), "2:5: error: undeclared identifier 'qqqqqqq' [X3004]\n");
  EXPECT_EQ(InFunction("v = satturate(v);"),
            "2:5: error: undeclared identifier 'satturate'; did you mean 'saturate'? [X3004]\n");
}

TEST(Names, AreOnlyKnownAfterTheirDeclaration) {
  EXPECT_EQ(Messages("float F() { return G(); }\nfloat G() { return 1; }"),
            "1:20: error: undeclared identifier 'G' [X3004]\n  2:7: note: 'G' is declared here, after its use\n");
  EXPECT_EQ(Messages("float G();\nfloat F() { return G(); }\nfloat G() { return 1; }"), "");
  EXPECT_EQ(Messages("float x = x;"), "1:11: error: undeclared identifier 'x' [X3004]\n");
}

TEST(Names, RedefinitionsPointBack) {
  EXPECT_EQ(Messages("float a;\nfloat4 a;"),
            "2:8: error: redefinition of 'a' [X3003]\n  1:7: note: 'a' was defined here\n");
  EXPECT_EQ(InFunction("float a; float a;"),
            "2:16: error: redefinition of 'a' [X3003]\n  2:7: note: 'a' was defined here\n");
  EXPECT_EQ(InFunction("float a; { float a; }"), "");
  EXPECT_EQ(Messages("struct S { float a; float a; };"),
            "1:27: error: redefinition of 'a' [X3003]\n  1:18: note: 'a' was defined here\n");
  EXPECT_EQ(Messages("float F(float a) { return a; }\nfloat F(float b) { return b; }"),
            "2:7: error: redefinition of 'F' [X3003]\n  1:7: note: 'F' was defined here\n");
  EXPECT_EQ(Messages("float F(float a) { return a; }\nfloat F(float2 b) { return b.x; }"), "");
}

TEST(Names, LoopVariablesOutliveTheirLoops) {
  EXPECT_EQ(InFunction("for (int i = 0; i < 2; i++) v += i; for (int i = 0; i < 3; i++) v -= i; v.x = i;"), "");
}

TEST(Names, TypesAndFunctionsAreNoVariables) {
  EXPECT_EQ(InFunction("v = F;"), "2:5: error: identifier 'F' represents a function, not a variable [X3005]\n");
}

TEST(Types, TruncationIsAWarning) {
  EXPECT_EQ(InFunction("float a = v;"),
            "2:11: warning: implicit truncation of vector type from 'float4' to 'float' [X3206]\n");
  EXPECT_EQ(InFunction("float3 a = v.xy;"),
            "2:12: error: cannot implicitly convert from 'float2' to 'float3' [X3017]\n");
  EXPECT_EQ(InFunction("v.xy += v;"),
            "2:9: warning: implicit truncation of vector type from 'float4' to 'float2' [X3206]\n");
  EXPECT_EQ(InFunction("v.xyz = v.xyz * v;"),
            "2:17: warning: implicit truncation of vector type from 'float4' to 'float3' [X3206]\n");
  EXPECT_EQ(InFunction("float4x4 m = 0; float3x3 n = m; v = (float4)v;"),
            "2:30: warning: implicit truncation of matrix type from 'float4x4' to 'float3x3' [X3206]\n");
  EXPECT_EQ(InFunction("float3 a = (float3)v;"), "") << "a cast says that it is meant";
}

TEST(Types, MismatchesNameBoth) {
  EXPECT_EQ(InFunction("float4x4 m = 0; v = v * m;"), "2:21: error: type mismatch: 'float4' and 'float4x4' [X3020]\n");
  EXPECT_EQ(InFunction("float a[2]; v += a;"),
            "2:18: error: scalar, vector, or matrix expected, found 'float[2]' [X3022]\n");
  EXPECT_EQ(InFunction("v = v ? float4x4(v, v, v, v) : 1;"),
            "2:5: error: dimension of conditional does not match value: 'float4' and 'float4x4' [X3020]\n");
  EXPECT_EQ(InFunction("v = v & 1;"), "2:5: error: int or unsigned int type required [X3082]\n");
  EXPECT_EQ(InFunction("v = (float4)v.xy;"), "2:5: error: cannot convert from 'float2' to 'float4' [X3017]\n");
  EXPECT_EQ(InFunction("v = float4(v.xy, 1);"),
            "2:5: error: incorrect number of arguments to numeric-type constructor: 'float4' takes 4 components, found "
            "3 [X3014]\n");
  EXPECT_EQ(InFunction("v = s;", "sampler s;\n"),
            "3:5: error: cannot implicitly convert from 'sampler' to 'float4' [X3017]\n");
}

TEST(Types, MembersAndElementsAreChecked) {
  EXPECT_EQ(InFunction("v.x = v.q;"),
            "2:9: error: invalid subscript 'q' of 'float4': its components are x, y, z, w or r, g, b, a [X3018]\n");
  EXPECT_EQ(InFunction("v.x = v.xy.z;"),
            "2:12: error: invalid subscript 'z' of 'float2': its components are x, y or r, g [X3018]\n");
  EXPECT_EQ(InFunction("S s; v.x = s.colour;", "struct S { float color; };\n"),
            "3:14: error: invalid subscript 'colour': struct 'S' has no such member; did you mean 'color'? [X3018]\n");
  EXPECT_EQ(InFunction("v.x = v[4];"), "2:9: error: index out of bounds: 'float4' has 4 elements [X3504]\n");
  EXPECT_EQ(InFunction("v.x = v.x[0];"),
            "2:7: error: array, matrix, vector, or indexable object type expected in index expression, found 'float' "
            "[X3121]\n");
  EXPECT_EQ(InFunction("v.x = v[v];"),
            "2:9: error: invalid type for index: index must be a scalar, found 'float4' [X3120]\n");
}

TEST(Types, ArraysHavePositiveConstantSizes) {
  EXPECT_EQ(Messages("float a[0];"), "1:9: error: array dimension must be between 1 and 65536 [X3059]\n");
  EXPECT_EQ(Messages("float n; float a[n];"),
            "1:18: error: array dimensions must be literal scalar expressions [X3058]\n");
  EXPECT_EQ(Messages("static const int n = 2; float a[n * 2] = { 1, 2, 3, 4 };"), "");
  EXPECT_EQ(Messages("float a[];"), "1:1: error: array dimensions must be explicit [X3058]\n");
  EXPECT_EQ(Messages("float4x4 a[65536][65536];"), "1:1: error: array has more than 1048576 components [X3059]\n");
}

TEST(Initialisers, MustHaveAllComponents) {
  EXPECT_EQ(Messages("float2 a = { 1, 2, 3 };"),
            "1:12: error: 'a': initializer does not match type: 'float2' takes 2 values, found 3 [X3017]\n");
  EXPECT_EQ(Messages("static const float a;"), "1:20: error: 'a': missing initial value [X3012]\n");
  EXPECT_EQ(Messages("struct S { float2 a; float b; }; S s = { 1, 2 };"),
            "1:40: error: 's': initializer does not match type: 'S' takes 3 values, found 2 [X3017]\n");
}

TEST(Calls, WithoutAFittingFunctionListThem) {
  EXPECT_EQ(Messages("float G(float2 a) { return a.x; }\nfloat F(float b) { return G(b, b); }"),
            "2:27: error: 'G': no matching 2 parameter function for (float, float) [X3013]\n"
            "  1:7: note: candidate: float G(float2)\n");
  EXPECT_EQ(InFunction("v = cross(v.xy, v);"),
            "2:5: error: 'cross': no matching 2 parameter intrinsic function for (float2, float4) [X3013]\n"
            "  0:0: note: candidate: float3 cross(float3, float3)\n");
  EXPECT_EQ(Messages("float G(float a, int b) { return a; }\nfloat G(int a, float b) { return a; }\nfloat F() { return "
                     "G(1, 1); }"),
            "3:20: error: 'G': ambiguous function call [X3067]\n"
            "  1:7: note: candidate: float G(float, int)\n"
            "  2:7: note: candidate: float G(int, float)\n");
}

TEST(Calls, ChooseTheNearestOverload) {
  const auto result = test::Compile(
      "float G(float a) { return 1; } float G(float2 a) { return 2; } float G(int a) { return 3; }\n"
      "float lerp(float a, float b) { return 4; }\n"
      "float4 PS(float4 t : TEXCOORD0) : COLOR { int i = 1; return float4(G(t.x), G(t.xy), G(i), lerp(1, 2)) + lerp(t, "
      "t, 0.5); }\n"
      "technique T { pass P { PixelShader = compile ps_3_0 PS(); } }");
  ASSERT_TRUE(result.effect) << Messages(result);
  EXPECT_NE(result.effect->techniques[0].passes[0].program.fragment_glsl.find(
                "vec4(f_G(l_t.x), f_G_1(l_t.xy), f_G_2(l_i), f_lerp("),
            std::string::npos)
      << result.effect->techniques[0].passes[0].program.fragment_glsl;
}

TEST(Calls, RecursionIsRefused) {
  EXPECT_EQ(Messages("float F(float a) { return F(a - 1); }"),
            "1:7: error: 'F': recursive functions are not allowed [X3500]\n  1:7: note: 'F' calls 'F'\n");
  EXPECT_EQ(Messages("float G(float a);\nfloat F(float a) { return G(a); }\nfloat G(float a) { return F(a); }"),
            "2:7: error: 'F': recursive functions are not allowed [X3500]\n  2:7: note: 'F' calls 'G'\n  3:7: note: "
            "'G' calls 'F'\n");
}

TEST(Assignment, NeedsSomethingToAssignTo) {
  EXPECT_EQ(InFunction("k = 2;", "static const float k = 1;\n"),
            "3:1: error: l-value specifies const object 'k' [X3025]\n  1:20: note: 'k' was declared here\n");
  EXPECT_EQ(InFunction("v.xx = 1;"),
            "2:3: error: swizzle 'xx' names a component twice, so it cannot be assigned to [X3025]\n");
  EXPECT_EQ(InFunction("v + 1 = v;"), "2:1: error: an assignable variable was expected here [X3025]\n");
  EXPECT_EQ(InFunction("sincos(v, v, 1);"), "2:14: error: an assignable variable was expected here [X3025]\n");
  EXPECT_EQ(InFunction("p = 2;", "float p;\n"), "") << "Direct3D 9 lets a shader write to its parameters";
}

TEST(Flow, EveryPathReturns) {
  EXPECT_EQ(Messages("float F(float a) { if (a > 0) return 1; }"),
            "1:7: error: 'F': not all control paths return a value [X3507]\n");
  EXPECT_EQ(Messages("float F(float a) { a = 1; }"), "1:7: error: 'F': function must return a value [X3080]\n");
  EXPECT_EQ(Messages("float F(float a) { if (a > 0) return 1; else { return 2; } }"), "");
  EXPECT_EQ(Messages("float F(float a) { switch ((int)a) { case 0: return 1; default: return 2; } }"), "");
  EXPECT_EQ(Messages("float F(float a) { for (int i = 0; i < 3; i++) return 1; }"),
            "1:7: error: 'F': not all control paths return a value [X3507]\n");
  EXPECT_EQ(Messages("void F() { return 1; }"), "1:19: error: 'F': void functions cannot return a value [X3079]\n");
  EXPECT_EQ(Messages("float F() { return; }"), "1:13: error: 'F': function must return a value [X3080]\n");
}

TEST(Flow, ConditionsAreScalars) {
  EXPECT_EQ(InFunction("if (v) v = 1;"),
            "2:5: error: if statement conditional expressions must evaluate to a scalar, not 'float4'; any() or all() "
            "makes one of it [X3019]\n");
  EXPECT_EQ(InFunction("while (v > 0) v -= 1;"),
            "2:8: error: loop conditional expressions must evaluate to a scalar, not 'bool4'; any() or all() makes one "
            "of it [X3019]\n");
  EXPECT_EQ(InFunction("break;"), "2:1: error: break must be inside a loop or switch [X3518]\n");
  EXPECT_EQ(InFunction("continue;"), "2:1: error: continue must be inside a loop [X3519]\n");
  EXPECT_EQ(InFunction("switch (1) { case 1: break; case 1: break; }"),
            "2:34: error: duplicate case in switch statement [X3532]\n");
}

TEST(Checks, ReachUnusedFunctionsAndReportSeveralErrors) {
  EXPECT_EQ(Messages("float F() { return a; }\nfloat G() { return b; }\ntexture GBAnothing_L8;"),
            "1:20: error: undeclared identifier 'a' [X3004]\n"
            "2:20: error: undeclared identifier 'b' [X3004]\n"
            "3:9: error: texture 'GBAnothing_L8': unknown attribute 'nothing' [B1001]\n");
}

TEST(Checks, StopAfterTwentyErrors) {
  std::string text;
  for (int i = 0; i < 40; ++i) text += "float a" + std::to_string(i) + " = undeclared" + std::to_string(i) + ";\n";
  EXPECT_EQ(test::Compile(text).diagnostics.size(), 20u);
}

TEST(Checks, AfterASyntaxErrorUnknownNamesAreNotBlamed) {
  EXPECT_EQ(Messages("float a = ;\nfloat F() { return a + 1; }\nfloat4 G() { float3 w = 1; return w; }").find("X3004"),
            std::string::npos);
}

TEST(Names, OfGlslAreTranslated) {
  EXPECT_EQ(InFunction("v = mix(v, vec4(1), 2);"),
            "2:12: error: undeclared identifier 'vec4'; did you mean 'float4'? [X3004]\n"
            "2:5: error: undeclared identifier 'mix'; did you mean 'lerp'? [X3004]\n");
  EXPECT_EQ(Messages("vec3 x;"), "1:1: error: unknown type 'vec3'; did you mean 'float3'? [X3000]\n");
  EXPECT_EQ(InFunction("v = flaot4(1, 2, 3, 4);"),
            "2:5: error: undeclared identifier 'flaot4'; did you mean 'float4'? [X3004]\n");
}

TEST(Names, OfFunctionsAreReportedBesideTheirArguments) {
  EXPECT_EQ(InFunction("v = tex2d(nothing, v);"),
            "2:11: error: undeclared identifier 'nothing' [X3004]\n"
            "2:5: error: undeclared identifier 'tex2d'; did you mean 'tex2D'? [X3004]\n");
}

std::string Chain(int links, const std::function<std::string(int)>& link) {
  std::string text;
  for (int i = 0; i < links; ++i) text += link(i);
  return text;
}

// Longer than a stack is deep, were they followed by recursion; the names sort against the calls.
TEST(Limits, ChainsAsLongAsAFileAreNoDeeperThanOthers) {
  constexpr int kLinks = 30000;
  const auto n = [](int i) { return std::to_string(100000 - i); };
  const std::string use =
      "float4 PS(float2 t : TEXCOORD0) : COLOR { float4 r = 0; if (t.x > 0.5) r = @; return r; }\n"
      "technique T { pass { PixelShader = compile ps_3_0 PS(); } }";
  const auto codes = [&](const std::string& chain, const std::string& last) {
    std::string text = chain + use;
    text.replace(text.find('@'), 1, last);
    std::string list;
    for (const Diagnostic& d : test::Compile(text).diagnostics) list += d.code + " ";
    return list;
  };
  EXPECT_EQ(codes("float f100001() { return 1; }\n" +
                      Chain(kLinks, [&](int i) { return "float f" + n(i) + "() { return f" + n(i - 1) + "(); }\n"; }),
                  "f" + n(kLinks - 1) + "()"),
            "B1013 ");
  EXPECT_EQ(codes("static float g100001 = 1;\n" +
                      Chain(kLinks, [&](int i) { return "static float g" + n(i) + " = g" + n(i - 1) + " + 1;\n"; }),
                  "g" + n(kLinks - 1)),
            "B1013 ");
  const std::string structs = Messages("struct S100001 { float x; };\n" + Chain(70, [&](int i) {
                                         return "struct S" + n(i) + " { S" + n(i - 1) + " a; };\n";
                                       }));
  EXPECT_EQ(structs, "65:8: error: structs are nested more than 64 levels deep [B1201]\n");
  // Two empty structs in each of the next: 2 to the 40 of them.
  EXPECT_EQ(Messages("struct S100001 { };\n" +
                     Chain(21, [&](int i) { return "struct S" + n(i) + " { S" + n(i - 1) + " a, b; };\n"; })),
            "22:8: error: struct has more than 1048576 components [X3059]\n");
}

}  // namespace
}  // namespace burin::fx
