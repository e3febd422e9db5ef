// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/constant.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/fx_parser/compile_effect.h"

namespace burin::fx {
namespace {

/// Single precision, as the values are held.
constexpr double kTolerance = 1e-6;

void ExpectDefault(const std::string& declaration, const std::vector<double>& expected) {
  const CompileResult result = test::Compile(declaration);
  ASSERT_TRUE(result.effect) << declaration << "\n" << test::Messages(result);
  const Parameter& last = result.effect->parameters.back();
  EXPECT_TRUE(last.has_default);
  ASSERT_EQ(last.default_value.numbers.size(), expected.size()) << declaration;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(last.default_value.numbers[i], expected[i], kTolerance * std::max(1.0, std::fabs(expected[i])))
        << declaration << " [" << i << "]";
  }
}

TEST(Constant, ParameterDefaultsTakeEveryInitialiser) {
  ExpectDefault("float x = 0.5;", {0.5});
  ExpectDefault("float4 x = { 1, 2, 3, 4 };", {1, 2, 3, 4});
  ExpectDefault("float4 x = 2;", {2, 2, 2, 2});
  ExpectDefault("float3 x = float3(1, float2(2, 3));", {1, 2, 3});
  ExpectDefault("float2x2 x = { 1, 2, { 3, 4 } };", {1, 2, 3, 4});
  ExpectDefault("float x[2][2] = { { 1, 2 }, { 3, 4 } };", {1, 2, 3, 4});
  ExpectDefault("float x[] = { 1, 2, 3 };", {1, 2, 3});
  ExpectDefault("bool x = 2.5;", {1});
  ExpectDefault("int x = -2.9;", {-2});
  ExpectDefault("struct S { float2 a; int b; }; S x = { 1, 2, 3.7 };", {1, 2, 3});
  ExpectDefault("static const float k = 3; static const float l = k * 2; float x = l + k;", {9});
}

TEST(Constant, ArithmeticIsThatOfTheShader) {
  ExpectDefault("float x = 7 / 2;", {3});
  ExpectDefault("float x = -7 / 2;", {-3});
  ExpectDefault("float x = 7 / 2.0;", {3.5});
  ExpectDefault("float x = -7 % 3;", {-1});
  ExpectDefault("float x = -5.5 % 2;", {-1.5});
  ExpectDefault("float x = 1 << 4 | 3;", {19});
  ExpectDefault("float x = ~0;", {-1});
  ExpectDefault("float x = 1 ? 2 : 3;", {2});
  ExpectDefault("float3 x = float3(1, 5, 3) > 2 ? 1 : float3(7, 8, 9);", {7, 1, 1});
  ExpectDefault("float x = !0.0 && 0.3;", {1});
  ExpectDefault("float x = 1.0 / 0;", {3.402823466e38});
  ExpectDefault("float x = 1 / 0;", {0});
  ExpectDefault("int x = 2147483647 + 1;", {-2147483648.0});
  ExpectDefault("float x = (int)3.9 + (bool)0.2;", {4});
}

TEST(Constant, MembersElementsAndSwizzles) {
  ExpectDefault("float2 x = float4(1, 2, 3, 4).wx;", {4, 1});
  ExpectDefault("float3 x = 5 .xxx;", {5, 5, 5});
  ExpectDefault("static const float k[3] = { 5, 6, 7 }; float x = k[1 + 1];", {7});
  ExpectDefault("float2 x = float2x2(1, 2, 3, 4)._m10_m01;", {3, 2});
  ExpectDefault("float2 x = float2x2(1, 2, 3, 4)[1];", {3, 4});
  ExpectDefault("struct S { float2 a; float b; }; static const S s = { 1, 2, 3 }; float x = s.b;", {3});
}

TEST(Constant, IntrinsicsFollowDirect3D9) {
  ExpectDefault("float x = sqrt(-4);", {2});
  ExpectDefault("float x = pow(-2, 3);", {8});
  ExpectDefault("float2 x = pow(0, float2(0, 1));", {1, 0});
  ExpectDefault("float x = log2(-8);", {3});
  ExpectDefault("float x = rsqrt(-4);", {0.5});
  ExpectDefault("float3 x = normalize(float3(0, 0, 0));", {0, 0, 0});
  ExpectDefault("float2 x = normalize(float2(3, 4));", {0.6, 0.8});
  ExpectDefault("float4 x = round(float4(0.5, -0.5, 1.5, 2.4));", {1, 0, 2, 2});
  ExpectDefault("float2 x = step(0.5, float2(0.5, 0.4));", {1, 0});
  ExpectDefault("float3 x = sign(float3(-3, 0, 2));", {-1, 0, 1});
  ExpectDefault("float4 x = lit(0.5, 0.5, 2);", {1, 0.5, 0.25, 1});
  ExpectDefault("float4 x = lit(-1, 0.5, 2);", {1, 0, 0, 1});
  ExpectDefault("int4 x = D3DCOLORtoUBYTE4(float4(0.1, 0.2, 0.3, 1));", {76, 51, 25, 255});
  ExpectDefault("float4 x = dst(float4(1, 2, 3, 4), float4(5, 6, 7, 8));", {1, 12, 3, 8});
  ExpectDefault("float x = smoothstep(0, 2, 0.5);", {0.15625});
  ExpectDefault("float3 x = cross(float3(1, 0, 0), float3(0, 1, 0));", {0, 0, 1});
  ExpectDefault("float2 x = reflect(float2(1, -1), float2(0, 1));", {1, 1});
  ExpectDefault("float x = determinant(float3x3(2, 0, 1, 1, 3, 2, 1, 1, 1));", {0});
  ExpectDefault("float2x2 x = transpose(float2x2(1, 2, 3, 4));", {1, 3, 2, 4});
}

TEST(Constant, MulKeepsRowsAndColumnsApart) {
  // Row vector times matrix, and matrix times column vector, worked out by hand.
  ExpectDefault("float3 x = mul(float2(1, 2), float2x3(1, 2, 3, 4, 5, 6));", {9, 12, 15});
  ExpectDefault("float2 x = mul(float2x3(1, 2, 3, 4, 5, 6), float3(1, 2, 3));", {14, 32});
  ExpectDefault("float2x2 x = mul(float2x3(1, 2, 3, 4, 5, 6), float3x2(1, 2, 3, 4, 5, 6));", {22, 28, 49, 64});
}

TEST(Constant, DefaultsMustBeConstant) {
  EXPECT_EQ(test::Messages("float a;\nfloat b = a * 2;"),
            "2:11: warning: 'b': the initial value is no literal expression, so shaders compute it and it is no "
            "parameter [X3011]\n");
}

TEST(Constant, ValueConversionTruncatesMatricesByRowsAndColumns) {
  const Value matrix{MatrixType(Scalar::kFloat, 3, 3), {1, 2, 3, 4, 5, 6, 7, 8, 9}, {}};
  EXPECT_EQ(ConvertValue(matrix, MatrixType(Scalar::kFloat, 2, 2))->numbers, (std::vector<double>{1, 2, 4, 5}));
  EXPECT_FALSE(ConvertValue(Value{VectorType(Scalar::kFloat, 2), {1, 2}, {}}, VectorType(Scalar::kFloat, 3)));
}

TEST(EvaluateExpression, ReadsParametersAsTheHostHasThem) {
  const CompileResult result = test::Compile(
      "int count = 2; float4 tint = 1; float4 PS() : COLOR { return tint; }\n"
      "technique T { pass P { StencilRef = (count * 2 + 1); AlphaRef = <count>; BlendFactor = (tint * 0.5); "
      "PixelShader = compile ps_2_0 PS(); } }");
  ASSERT_TRUE(result.effect) << test::Messages(result);
  const auto& states = result.effect->techniques[0].passes[0].states;
  ASSERT_EQ(states.size(), 3u);
  std::vector<Value> values = {result.effect->parameters[0].default_value, result.effect->parameters[1].default_value};
  const ParameterLookup lookup = [&](std::size_t i) -> const Value& { return values[i]; };
  const auto evaluate = [&](std::size_t i) {
    return EvaluateExpression(*result.effect, *std::get<const ast::Expression*>(states[i].value), lookup);
  };
  EXPECT_EQ(evaluate(0)->numbers, std::vector<double>{5});
  values[0].numbers = {10};
  EXPECT_EQ(evaluate(0)->numbers, std::vector<double>{21});
  EXPECT_EQ(evaluate(1)->numbers, std::vector<double>{10});
  EXPECT_EQ(evaluate(2)->numbers, (std::vector<double>{0.5, 0.5, 0.5, 0.5}));
}

}  // namespace
}  // namespace burin::fx
