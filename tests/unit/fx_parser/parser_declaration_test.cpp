// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

TEST(ParserDeclaration, TakesSeveralDeclaratorsWithTheirOwnSizesAndValues) {
  EXPECT_EQ(DumpText("float a = 1, b[2], c[2][3] = { 1 };"), "[float a = 1]\n[float b[2]]\n[float c[2][3] = { 1 }]");
}

TEST(ParserDeclaration, TakesArraysSizedByTheirInitialiser) {
  EXPECT_EQ(DumpText("static const float k[] = { 1, 2 };"), "[static const float k[] = { 1 2 }]");
}

TEST(ParserDeclaration, KeepsQualifiersInAnyOrder) {
  EXPECT_EQ(DumpText("const static uniform float x; shared extern volatile float y; float const z = 1;"),
            "[static const uniform float x]\n[extern shared volatile float y]\n[const float z = 1]");
}

TEST(ParserDeclaration, TakesSemanticsRegistersAnnotationsAndValueTogether) {
  EXPECT_EQ(
      DumpText(
          "float4 c : DIFFUSE : register(vs, c4) < string UIName = \"Colour\"; float UIMin = 0; > = { 1, 1, 1, 1 };"),
      "[float4 c : DIFFUSE : (vs, c4) <string UIName=\"Colour\"; float UIMin=0> = { 1 1 1 1 }]");
  EXPECT_EQ(DumpText("sampler s : register(s0);"), "[sampler s : (s0)]");
  EXPECT_EQ(DumpText("float x : packoffset(c0.y);"), "[float x : (c0.y)]");
}

TEST(ParserDeclaration, SplitsTheAngleFromTheEqualsSign) {
  EXPECT_EQ(DumpText("float x < float a = 1; >= 2;"), "[float x <float a=1> = 2]");
}

TEST(ParserDeclaration, TakesAnnotationsWithoutLastSemicolonOrTypes) {
  EXPECT_EQ(DumpText("float x < float a = 1; string b = \"c\" > = 2;"), "[float x <float a=1; string b=\"c\"> = 2]");
  EXPECT_EQ(DumpText("uniform float x < ui_min = 0.5; ui_label = \"X\"; > = 1;"),
            "[uniform float x <? ui_min=0.5f; ? ui_label=\"X\"> = 1]");
  EXPECT_EQ(DumpText("float x <>;"), "[float x]");
}

TEST(ParserDeclaration, ComparesInsideAnnotationsOnlyWithinParentheses) {
  EXPECT_EQ(DumpText("float x < bool a = (1 > 0); float b = 1 < 2; > = 3;"),
            "[float x <bool a=(> 1 0); float b=(< 1 2)> = 3]");
}

TEST(ParserDeclaration, ReadsAnnotationArrays) {
  EXPECT_EQ(DumpText("texture t < float2 r = { 1.0, 0.5 }; string l[2] = { \"a\", \"b\" }; >;"),
            "[texture t <float2 r={ 1f 0.5f }; string l[2]={ \"a\" \"b\" }>]");
}

TEST(ParserDeclaration, TakesObjectTypesInAnyCase) {
  EXPECT_EQ(DumpText("Texture GBAintensity_A8R8G8B8; TEXTURE b; texture2D c; TextureCube d; SAMPLER2D e; String f;"),
            "[Texture GBAintensity_A8R8G8B8]\n[TEXTURE b]\n[texture2D c]\n[TextureCube d]\n[SAMPLER2D e]\n[String f]");
}

TEST(ParserDeclaration, ResolvesBuiltInTypes) {
  const auto type = [](const std::string& text) {
    const auto parsed = ParseText(text);
    EXPECT_EQ(parsed->Messages(), "") << text;
    return std::get<std::unique_ptr<ast::Variable>>(parsed->module.declarations.at(0))->type_name.type;
  };
  Type float3x4;
  float3x4.kind = TypeKind::kNumeric;
  float3x4.rows = 3;
  float3x4.columns = 4;
  float3x4.is_matrix = true;
  EXPECT_EQ(type("float3x4 x;"), float3x4);
  EXPECT_EQ(type("matrix<float, 3, 4> x;"), float3x4);
  float3x4.row_major = true;
  EXPECT_EQ(type("row_major float3x4 x;"), float3x4);

  Type half2;
  half2.kind = TypeKind::kNumeric;
  half2.scalar = Scalar::kHalf;
  half2.columns = 2;
  half2.is_vector = true;
  EXPECT_EQ(type("half2 x;"), half2);
  EXPECT_EQ(type("vector<half, 2> x;"), half2);
  EXPECT_EQ(type("fixed2 x;"), half2);

  Type scalar;
  scalar.kind = TypeKind::kNumeric;
  scalar.scalar = Scalar::kUint;
  EXPECT_EQ(type("unsigned int x;"), scalar);
  EXPECT_EQ(type("DWORD x;"), scalar);
  EXPECT_EQ(type("unsigned x;"), scalar);

  Type float1;
  float1.kind = TypeKind::kNumeric;
  float1.is_vector = true;
  EXPECT_EQ(type("float1 x;"), float1);

  EXPECT_EQ(type("samplerCUBE s;").kind, TypeKind::kSampler);
  EXPECT_EQ(type("samplerCUBE s;").dimension, Dimension::kCube);
  EXPECT_EQ(type("sampler s;").dimension, Dimension::kUnknown);
  EXPECT_EQ(type("matrix m;").rows, 4);
  EXPECT_EQ(type("vector v;").columns, 4);
}

TEST(ParserDeclaration, PacksMatricesAsThePragmaSays) {
  const auto parsed = ParseText(
      "float4x4 a;\n#pragma pack_matrix(row_major)\nfloat4x4 b; column_major float4x4 c; float4 v;\n"
      "#pragma pack_matrix(column_major)\nfloat4x4 d;");
  EXPECT_EQ(parsed->Messages(), "");
  EXPECT_EQ(Dump(parsed->module),
            "[float4x4 a]\n[row_major float4x4 b]\n[column_major float4x4 c]\n[float4 v]\n[float4x4 d]");
}

TEST(ParserDeclaration, ReadsSamplerStates) {
  EXPECT_EQ(DumpText("sampler s = sampler_state { Texture = <t>; MinFilter = LINEAR; AddressU = (u); BorderColor = "
                     "float4(0,0,0,1); };"),
            "[sampler s = (states Texture=<t> MinFilter=LINEAR AddressU=(u) BorderColor=(new float4 0 0 0 1))]");
  EXPECT_EQ(DumpText("sampler2D s { Texture = t; };"), "[sampler2D s = (states Texture=t)]");
  EXPECT_EQ(DumpText("sampler s[2] = { sampler_state { Texture = <a>; }, SAMPLER_STATE { Texture = <b>; } };"),
            "[sampler s[2] = { (states Texture=<a>) (states Texture=<b>) }]");
  EXPECT_EQ(DumpText("texture t : COLOR { Width = 4; };"), "[texture t : COLOR = (states Width=4)]");
}

TEST(ParserDeclaration, ReadsTypedefs) {
  EXPECT_EQ(DumpText("typedef float3x3 rotation; typedef float row[4]; rotation r = (rotation)0;"),
            "(typedef float3x3 rotation)\n(typedef float row[4])\n[rotation r = (cast rotation 0)]");
  EXPECT_EQ(DumpText("typedef struct { float x; } S; S s;"), "(struct [float x])\n(typedef ? S)\n[S s]");
}

TEST(ParserDeclaration, ReadsStructsWithVariables) {
  EXPECT_EQ(DumpText("struct Light { float3 dir : DIRECTION, color; row_major float4x4 m; } a, b[2];"),
            "(struct Light [float3 dir : DIRECTION] [float3 color] [row_major float4x4 m])\n[Light a]\n[Light b[2]]");
  EXPECT_EQ(DumpText("struct Light { float x; }; struct Light l;"), "(struct Light [float x])\n[Light l]");
}

TEST(ParserDeclaration, LinksVariablesOfAnAnonymousStruct) {
  const auto parsed = ParseText("struct { float x; } a;");
  const auto& structure = std::get<std::unique_ptr<ast::Struct>>(parsed->module.declarations.at(0));
  const auto& variable = std::get<std::unique_ptr<ast::Variable>>(parsed->module.declarations.at(1));
  EXPECT_EQ(variable->type_name.type.structure, structure.get());
}

TEST(ParserDeclaration, TakesConstantBuffersAsGlobals) {
  EXPECT_EQ(DumpText("cbuffer Frame : register(b0) { float4 a; float b = 2; };"), "[float4 a]\n[float b = 2]");
}

TEST(ParserDeclaration, MarksGlobals) {
  const auto parsed = ParseText("float a;");
  EXPECT_TRUE(std::get<std::unique_ptr<ast::Variable>>(parsed->module.declarations.at(0))->is_global);
}

TEST(ParserDeclaration, SuggestsANearTypeName) {
  EXPECT_EQ(DumpText("flaot3 x;"), "1:1 error: unknown type 'flaot3'; did you mean 'float3'? [X3000]\n");
  EXPECT_EQ(DumpText("struct Light { float x; };\nLihgt l;"),
            "2:1 error: unknown type 'Lihgt'; did you mean 'Light'? [X3000]\n");
  EXPECT_EQ(DumpText("zebra x;"), "1:1 error: unknown type 'zebra' [X3000]\n");
}

TEST(ParserDeclaration, PutsAMissingSemicolonWhereItBelongs) {
  EXPECT_EQ(DumpText("float a = 1\nfloat b;"), "1:12 error: expected ';' after declaration of 'a' [X3000]\n");
  EXPECT_EQ(DumpText("struct S { float x; }\nfloat b;"), "1:22 error: expected ';' after struct 'S' [X3000]\n");
  EXPECT_EQ(DumpText("struct S { float x }; float b;"), "1:19 error: expected ';' after member 'x' [X3000]\n");
}

TEST(ParserDeclaration, ReportsWhatCannotStandInAStruct) {
  EXPECT_EQ(DumpText("struct S { struct T { float x; } t; };"),
            "1:19 error: a struct cannot be defined inside a struct [X3000]\n");
}

TEST(ParserDeclaration, ReportsAMissingBraceOfAStructAtTheNextFunction) {
  const auto parsed = ParseText("struct S {\n  float x;\nfloat f(S s) { return s.x; }\nfloat y;");
  EXPECT_EQ(parsed->Messages(),
            "3:1 error: expected '}' to end struct 'S', found 'float' [X3000]\n  1:10 to match this\n");
  EXPECT_EQ(Dump(parsed->module), "(struct S [float x])\n(function float f [S s] { (return (. s x)) })\n[float y]");
}

TEST(ParserDeclaration, ReportsAVectorOfAWrongSize) {
  EXPECT_EQ(DumpText("vector<float, 5> x;"),
            "1:15 error: the size of a vector is a number from 1 to 4, not '5' [X3052]\n");
  EXPECT_EQ(DumpText("vector<foo, 3> x;"), "1:8 error: expected a scalar type in vector<...>, found 'foo' [X3000]\n");
}

TEST(ParserDeclaration, ReportsAMissingName) {
  EXPECT_EQ(DumpText("float = 1;"), "1:7 error: expected a name after type 'float', found '=' [X3000]\n");
  EXPECT_EQ(DumpText("float 3;"), "1:7 error: expected a name after type 'float', found '3' [X3000]\n");
}

TEST(ParserDeclaration, ReportsAStrayBraceAndAStrayPass) {
  EXPECT_EQ(DumpText("float a; }\nfloat b;"), "1:10 error: '}' without '{' [X3000]\n");
  EXPECT_EQ(DumpText("pass P0 { ZEnable = true; }"), "1:1 error: a pass stands inside a technique [X3000]\n");
}

TEST(ParserDeclaration, TakesNamesOfNamespacesWhole) {
  EXPECT_EQ(DumpText("float y; namespace A { float x; namespace B { float z = x + y; } }; float w = A::B::z + ::y;"),
            "[float y]\n[float A::x]\n[float A::B::z = (+ A::x y)]\n[float w = (+ A::B::z y)]");
  EXPECT_EQ(
      DumpText("namespace A { struct S { float x; }; S s; float f(float x, S s) { S x; return s.x; } } A::S t;"),
      "(struct A::S [float x])\n[A::S A::s]\n(function float A::f [float x] [A::S s] { (var [A::S x]) (return (. s "
      "x)) })\n[A::S t]");
  EXPECT_EQ(DumpText("namespace A { float x;"),
            "1:23 error: expected '}' to end the namespace, found end of file [X3000]\n  1:13 to match this\n");
}

TEST(ParserDeclaration, ReadsTheHeadsOfStructsFunctions) {
  EXPECT_EQ(DumpText("interface L { float f(float x); }; struct S : L { float f(float x) { return x; } float y; };"),
            "(struct L)\n(struct S [float y])");
}

}  // namespace
}  // namespace burin::fx::test
