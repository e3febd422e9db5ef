// SPDX-License-Identifier: Apache-2.0
// Direct3D 9's arithmetic (shader models 1 to 3) where it is not GLSL's. The operands are parameters, so that they reach the
// device and are not folded away.
#include <cmath>
#include <limits>

#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

const std::string kGlobals = "float4 a; float4 b; float4 c; int4 i; int4 j; bool4 p; bool4 q;\n";

Rgba Compute(const std::string& expression, const Settings& parameters) {
  return Evaluate(expression, kGlobals, parameters);
}

TEST(Arithmetic, PowTakesTheBaseWithoutItsSign) {
  EXPECT_RGBA(Compute("pow(a, b)", {{"a", "-2,2,-3,0"}, {"b", "3,3,2,2"}}), 8, 8, 9, 0);
}

TEST(Arithmetic, RootsAndLogarithmsTakeTheArgumentWithoutItsSign) {
  EXPECT_RGBA(Compute("float4(sqrt(a.x), rsqrt(a.x), log2(a.x), log(a.y))", {{"a", "-16,-2.7182818,0,0"}}), 4, 0.25f, 4,
              1);
}

TEST(Arithmetic, NormalizeOfNothingIsNothing) {
  EXPECT_RGBA(Compute("float4(normalize(a.xyz), 1)", {{"a", "0,0,0,0"}}), 0, 0, 0, 1);
  EXPECT_RGBA(Compute("float4(normalize(a.xyz), 1)", {{"a", "0,3,4,0"}}), 0, 0.6f, 0.8f, 1);
}

TEST(Arithmetic, ModuloKeepsTheSignOfTheFirstOperand) {
  EXPECT_RGBA(Compute("a % b", {{"a", "-5.5,5.5,-5.5,5"}, {"b", "2,-2,-2,3"}}), -1.5f, 1.5f, -1.5f, 2);
  EXPECT_RGBA(Compute("fmod(a, b)", {{"a", "-5.5,5.5,-5.5,5"}, {"b", "2,-2,-2,3"}}), -1.5f, 1.5f, -1.5f, 2);
}

TEST(Arithmetic, IntegerDivisionTruncates) {
  EXPECT_RGBA(Compute("i / j", {{"i", "7,-7,7,-7"}, {"j", "2,2,-2,-2"}}), 3, -3, -3, 3);
}

TEST(Arithmetic, IntegerModuloKeepsTheSignOfTheFirstOperand) {
  EXPECT_RGBA(Compute("i % j", {{"i", "7,-7,7,-7"}, {"j", "3,3,-3,-3"}}), 1, -1, 1, -1);
}

TEST(Arithmetic, RoundGoesUpAtTheHalf) {
  EXPECT_RGBA(Compute("round(a)", {{"a", "0.5,1.5,-0.5,2.4"}}), 1, 2, 0, 2);
}

TEST(Arithmetic, StepIsOneAtTheEdge) {
  EXPECT_RGBA(Compute("step(a, b)", {{"a", "1,1,1,-1"}, {"b", "0.999,1,1.001,-2"}}), 0, 1, 1, 0);
}

TEST(Arithmetic, SignOfZeroIsZero) {
  EXPECT_RGBA(Compute("sign(a)", {{"a", "-3,0,5,0"}}), -1, 0, 1, 0);
}

TEST(Arithmetic, FracOfNegativesIsPositive) {
  EXPECT_RGBA(Compute("frac(a)", {{"a", "-1.25,1.25,0,2"}}), 0.75f, 0.25f, 0, 0);
}

TEST(Arithmetic, DivisionByZeroIsLargeAndNoTrap) {
  const Rgba result = Compute("float4(a.x / b.x, 1, 2, 3)", {{"a", "1,0,0,0"}, {"b", "0,0,0,0"}});
  EXPECT_GT(result[0], 1e30f);
  EXPECT_EQ(result[3], 3);
}

TEST(Arithmetic, SaturateOfNoNumberIsZero) {
  EXPECT_RGBA(Compute("saturate(float4(a.x / b.x, a.y, a.z, a.w))", {{"a", "0,-1,2,0.5"}, {"b", "0,0,0,0"}}), 0, 0, 1,
              0.5f);
}

TEST(Arithmetic, LogicalOperatorsWorkByComponent) {
  EXPECT_RGBA(Compute("p && q", {{"p", "1,1,0,0"}, {"q", "1,0,1,0"}}), 1, 0, 0, 0);
  EXPECT_RGBA(Compute("p || q", {{"p", "1,1,0,0"}, {"q", "1,0,1,0"}}), 1, 1, 1, 0);
  EXPECT_RGBA(Compute("!p", {{"p", "1,1,0,0"}}), 0, 0, 1, 1);
}

TEST(Arithmetic, ConditionalsChooseByComponent) {
  EXPECT_RGBA(Compute("a > 0.5 ? b : c", {{"a", "0,1,0,1"}, {"b", "1,2,3,4"}, {"c", "5,6,7,8"}}), 5, 2, 7, 4);
}

TEST(Arithmetic, ComparisonsGiveOnesAndZeros) {
  EXPECT_RGBA(Compute("(a == b) + 2 * (a < b)", {{"a", "1,2,3,4"}, {"b", "1,3,2,4"}}), 1, 2, 0, 1);
}

TEST(Arithmetic, LitAsDocumented) {
  EXPECT_RGBA(Compute("lit(a.x, a.y, a.z)", {{"a", "0.5,0.5,2,0"}}), 1, 0.5f, 0.25f, 1);
  EXPECT_RGBA(Compute("lit(a.x, a.y, a.z)", {{"a", "-0.5,0.5,2,0"}}), 1, 0, 0, 1);
  EXPECT_RGBA(Compute("lit(a.x, a.y, a.z)", {{"a", "0.5,-0.5,2,0"}}), 1, 0.5f, 0, 1);
}

TEST(Arithmetic, D3dcolorToUbyte4SwapsAndScales) {
  EXPECT_RGBA(Compute("D3DCOLORtoUBYTE4(a)", {{"a", "1,0.5,0,0.2"}}), 0, 127, 255, 51);
}

TEST(Arithmetic, IntrinsicsAsDocumented) {
  EXPECT_RGBA(Compute("dst(a, b)", {{"a", "9,2,3,9"}, {"b", "9,5,9,7"}}), 1, 10, 3, 7);
  EXPECT_RGBA(Compute("smoothstep(a, b, c)", {{"a", "0,0,0,0"}, {"b", "1,1,1,2"}, {"c", "-1,0.5,2,0.5"}}), 0, 0.5f, 1,
              0.15625f);
  EXPECT_RGBA(Compute("float4(faceforward(a.xyz, b.xyz, c.xyz), 0)",
                      {{"a", "1,2,3,0"}, {"b", "0,0,1,0"}, {"c", "0,0,1,0"}}),
              -1, -2, -3, 0);
  EXPECT_RGBA(Compute("float4(refract(a.xyz, b.xyz, 0.5), 0)", {{"a", "0,-1,0,0"}, {"b", "0,1,0,0"}}), 0, -1, 0, 0);
  EXPECT_RGBA(Compute("float4(reflect(a.xyz, b.xyz), 0)", {{"a", "1,-1,0,0"}, {"b", "0,1,0,0"}}), 1, 1, 0, 0);
  EXPECT_RGBA(Compute("float4(cross(a.xyz, b.xyz), 0)", {{"a", "1,0,0,0"}, {"b", "0,1,0,0"}}), 0, 0, 1, 0);
  EXPECT_RGBA(Compute("float4(ldexp(a.x, a.y), exp2(a.y), degrees(a.z), radians(a.w))",
                      {{"a", "3,4,3.14159265,180"}}),
              48, 16, 180, 3.14159265f);
}

TEST(Arithmetic, ClampWithEndsInTheWrongOrderTakesTheUpperEnd) {
  EXPECT_RGBA(Compute("clamp(a, 2, 1)", {{"a", "0,1.5,3,1"}}), 1, 1, 1, 1);
}

TEST(Arithmetic, ScalarsTakeSwizzlesAndSpread) {
  EXPECT_RGBA(Compute("a.x.xxxx + b.w", {{"a", "3,0,0,0"}, {"b", "0,0,0,4"}}), 7, 7, 7, 7);
}

TEST(Arithmetic, AssignmentsTruncate) {
  EXPECT_RGBA(Evaluate("Truncated()", "float4 a; float4 Truncated() { float2 t = a; float s = a.zw; return float4(t, s, 0); }",
                       {{"a", "1,2,3,4"}}),
              1, 2, 3, 0);
}

TEST(Arithmetic, WhatWasNeverWrittenIsZero) {
  EXPECT_RGBA(Evaluate("Unwritten()", "float4 Unwritten() { float4 v; v.x = 5; return v; }"), 5, 0, 0, 0);
}

TEST(Arithmetic, PlainGlobalsMayBeWritten) {
  EXPECT_RGBA(Evaluate("Count() + Count()", "float n = 1; float4 Count() { n += 1; return n; }"), 5, 5, 5, 5);
}

TEST(Arithmetic, StaticGlobalsBelongToTheInvocation) {
  EXPECT_RGBA(Evaluate("Count() + Count()", "static float n = 1; float4 Count() { n += 1; return n; }"), 5, 5, 5, 5);
}

TEST(Arithmetic, BothSidesOfAConditionAreEvaluated) {
  EXPECT_RGBA(Evaluate("Both()",
                       "static float n = 0; bool Next() { n += 1; return true; }\n"
                       "float4 a; float4 Both() { bool t = (a.x > 0) && Next(); return float4(n, t, 0, 0); }",
                       {{"a", "-1,0,0,0"}}),
              1, 0, 0, 0);
}

TEST(Arithmetic, LoopsCount) {
  EXPECT_RGBA(Evaluate("Sum()",
                       "int n = 5; float4 Sum() { float s = 0; for (int k = 1; k <= n; ++k) { if (k == 3) continue; s += k; } "
                       "int w = 0; while (w < 4) { w++; } do { w--; } while (w > 2); return float4(s, w, 0, 0); }"),
              12, 2, 0, 0);
}

TEST(Arithmetic, NoiseIsInRangeAndRepeats) {
  const Rgba one = Compute("float4(noise(a.x), noise(a.xy), noise(a.xyz), noise(a.xyz + 0.37))", {{"a", "1.3,2.7,3.1,0"}});
  const Rgba two = Compute("float4(noise(a.x), noise(a.xy), noise(a.xyz), noise(a.xyz + 0.37))", {{"a", "1.3,2.7,3.1,0"}});
  EXPECT_EQ(one, two);
  for (const float value : one) {
    EXPECT_GE(value, -1);
    EXPECT_LE(value, 1);
  }
}

TEST(Arithmetic, IsFiniteAndModf) {
  EXPECT_RGBA(Evaluate("Parts()", "float4 a; float4 Parts() { float whole; float part = modf(a.x, whole); "
                                  "float s, k; sincos(a.y, s, k); return float4(whole, part, s, k); }",
                       {{"a", "-2.75,0,0,0"}}),
              -2, -0.75f, 0, 1);
}

}  // namespace
}  // namespace burin::effect
