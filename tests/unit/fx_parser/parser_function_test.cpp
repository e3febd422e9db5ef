// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

TEST(ParserFunction, ReadsParametersOfEveryKind) {
  EXPECT_EQ(
      DumpText("float4 main(in float2 uv : TEXCOORD0, out float d : DEPTH, inout float3 n, uniform sampler2D s, "
               "uniform bool b = true, float w[3]) : COLOR0 { return 0; }"),
      "(function float4 main [in float2 uv : TEXCOORD0] [out float d : DEPTH] [in out float3 n] [uniform sampler2D s] "
      "[uniform bool b = true] [float w[3]] : COLOR0 { (return 0) })");
}

TEST(ParserFunction, ReadsPrototypesAndUnnamedParameters) {
  EXPECT_EQ(DumpText("float f(float, float2 x[2]); void g(void); inline float h();"),
            "(function float f [float] [float2 x[2]])\n(function void g)\n(function inline float h)");
}

TEST(ParserFunction, ReadsAnnotations) {
  EXPECT_EQ(DumpText("float4 f() : COLOR < string a = \"b\"; > { return 0; }"),
            "(function float4 f : COLOR <string a=\"b\"> { (return 0) })");
}

TEST(ParserFunction, IgnoresInterpolationWordsAndKeepsThemAsNames) {
  EXPECT_EQ(DumpText("float f(linear float point, noperspective float line) { return point; }"),
            "(function float f [float point] [float line] { (return point) })");
}

TEST(ParserFunction, ToleratesASemicolonAfterTheBody) {
  EXPECT_EQ(DumpText("void f() { };\nfloat x;"), "(function void f { })\n[float x]");
}

TEST(ParserFunction, ReportsAFaultyParameterList) {
  EXPECT_EQ(DumpText("float f(float a float b) { return a; }\nfloat x;"),
            "1:17 error: expected ',' or ')' in the parameters of 'f', found 'float' [X3000]\n  1:8 to match this\n");
  EXPECT_EQ(DumpText("float f(float a,) { return a; }"),
            "1:17 error: expected a parameter of 'f', found ')' [X3000]\n");
}

TEST(ParserFunction, ReportsAMissingBody) {
  EXPECT_EQ(DumpText("float f() return 1;\nfloat x;"),
            "1:11 error: expected '{' or ';' after the parameters of 'f', found 'return' [X3000]\n");
}

TEST(ParserFunction, ReportsAMissingBraceAtTheNextFunction) {
  EXPECT_EQ(DumpText("void f() {\n  if (a) { b = 1;\n}\nfloat g(float x) { return x; }\ntechnique T { }"),
            "4:1 error: expected '}' to end function 'f' before this declaration [X3000]\n  1:10 to match this\n");
}

TEST(ParserFunction, GoesOnAfterAMissingBrace) {
  const auto parsed = ParseText("void f() {\ntechnique T { pass P { } }\nfloat x;");
  EXPECT_EQ(parsed->Messages(),
            "2:1 error: expected '}' to end function 'f' before this declaration [X3000]\n  1:10 to match this\n");
  EXPECT_EQ(Dump(parsed->module), "(function void f { ; })\n(technique T (pass P))\n[float x]");
}

TEST(ParserFunction, RefusesAPrototypeInsideAFunction) {
  EXPECT_EQ(DumpBody("float g(float x);"), "2:7 error: a function cannot be declared inside a function [X3000]\n");
}

TEST(ParserFunction, ReportsTheEndOfTheFileWithTheOpenBrace) {
  EXPECT_EQ(DumpText("void f() {\n  a = 1;\n"),
            "3:1 error: expected '}', found end of file [X3000]\n  1:10 to match this\n");
}

}  // namespace
}  // namespace burin::fx::test
