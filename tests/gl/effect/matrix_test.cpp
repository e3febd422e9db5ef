// SPDX-License-Identifier: Apache-2.0
// Matrices as HLSL has them: rows first, whatever the packing.
#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

const std::string kMatrix = "float4x4 m; float4 v;\n";
const Settings kValues = {{"m", "11,12,13,14,21,22,23,24,31,32,33,34,41,42,43,44"}, {"v", "1,2,3,4"}};

TEST(Matrix, ElementsAreNamedByRowAndColumn) {
  EXPECT_RGBA(Evaluate("float4(m[0][1], m[1][0], m._12, m._m10)", kMatrix, kValues), 12, 21, 12, 21);
  EXPECT_RGBA(Evaluate("m[2]", kMatrix, kValues), 31, 32, 33, 34);
}

TEST(Matrix, SwizzlesPickElements) {
  EXPECT_RGBA(Evaluate("m._m00_m11_m22_m33", kMatrix, kValues), 11, 22, 33, 44);
  EXPECT_RGBA(Evaluate("m._11_21_31_41", kMatrix, kValues), 11, 21, 31, 41);
}

TEST(Matrix, SwizzlesAreAssignable) {
  EXPECT_RGBA(Evaluate("Changed()",
                       kMatrix + "float4 Changed() { float4x4 n = m; n._m00_m01 = float2(5, 6); n[1] = v; n[2].yz = 9;"
                                 " return float4(n._11, n._12, n._24, n._32); }",
                       kValues),
              5, 6, 4, 9);
}

TEST(Matrix, RowVectorTimesMatrix) {
  // Sum over the rows: 1*11 + 2*21 + 3*31 + 4*41 ...
  EXPECT_RGBA(Evaluate("mul(v, m)", kMatrix, kValues), 310, 320, 330, 340);
}

TEST(Matrix, MatrixTimesColumnVector) { EXPECT_RGBA(Evaluate("mul(m, v)", kMatrix, kValues), 130, 230, 330, 430); }

TEST(Matrix, MatrixTimesMatrix) {
  // The first row of m * transpose(m).
  EXPECT_RGBA(Evaluate("mul(m, transpose(m))[0]", kMatrix, kValues), 630, 1130, 1630, 2130);
}

TEST(Matrix, TheStarMultipliesElementByElement) {
  EXPECT_RGBA(Evaluate("(m * m)[1]", kMatrix, kValues), 441, 484, 529, 576);
}

TEST(Matrix, ConstructorsAndCastsGoByRows) {
  EXPECT_RGBA(Evaluate("float4(((float3x3)m)[2], float2x2(v)[1][0])", kMatrix, kValues), 31, 32, 33, 3);
  EXPECT_RGBA(Evaluate("float4x4(v, v + 4, v + 8, v + 12)[3]", kMatrix, kValues), 13, 14, 15, 16);
}

TEST(Matrix, NarrowOnesKeepTheirShape) {
  const std::string globals = "float4x3 m; float3x4 n; float2x3 o; float4 v;\n";
  const Settings values = {{"m", "1,2,3,4,5,6,7,8,9,10,11,12"},
                           {"n", "1,2,3,4,5,6,7,8,9,10,11,12"},
                           {"o", "1,2,3,4,5,6"},
                           {"v", "1,1,1,1"}};
  EXPECT_RGBA(Evaluate("float4(mul(v, m), 0)", globals, values), 22, 26, 30, 0);
  EXPECT_RGBA(Evaluate("float4(mul(n, v), 0)", globals, values), 10, 26, 42, 0);
  EXPECT_RGBA(Evaluate("mul(v.xyz, n)", globals, values), 15, 18, 21, 24);
  EXPECT_RGBA(Evaluate("float4(mul(o, v.xyz), o[1].yz)", globals, values), 6, 15, 5, 6);
}

TEST(Matrix, PackingDoesNotShow) {
  const std::string globals = "row_major float4x4 m; column_major float4x4 n; float4 v;\n";
  const Settings values = {{"m", kValues[0].second}, {"n", kValues[0].second}, {"v", "1,2,3,4"}};
  EXPECT_RGBA(Evaluate("mul(v, m)", globals, values), 310, 320, 330, 340);
  EXPECT_RGBA(Evaluate("mul(v, n)", globals, values), 310, 320, 330, 340);
}

TEST(Matrix, DeterminantAndDefaults) {
  EXPECT_RGBA(Evaluate("float4(determinant(m), m[0][1], m[1][0], 0)", "float2x2 m = {1, 2, 3, 4};"), -2, 2, 3, 0);
}

TEST(Matrix, ArraysOfMatricesAndStructs) {
  const std::string globals =
      "float2x2 m[2]; struct Light { float3 color; float2 range; }; Light lights[2] = {{{1,2,3},{4,5}},{{6,7,8},{9,10}}};\n"
      "float weights[5] = {1, 2, 3, 4, 5}; int at = 1;\n";
  EXPECT_RGBA(Evaluate("float4(m[1][0], m[0][1].y, m[at][1][0])", globals, {{"m", "1,2,3,4,5,6,7,8"}}), 5, 6, 4, 7);
  EXPECT_RGBA(Evaluate("float4(lights[1].color.y, lights[0].range.y, lights[at].range.x, weights[at + 2])", globals), 7, 5,
              9, 4);
}

TEST(Matrix, IntegersAndBoolsAreUploadedAsWritten) {
  EXPECT_RGBA(Evaluate("float4(i.x, i.y, flag ? 3 : 4, flags[1] ? 5 : 6)", "int2 i; bool flag; bool flags[2];",
                       {{"i", "-7,100000"}, {"flag", "true"}, {"flags", "0,1"}}),
              -7, 100000, 3, 5);
}

}  // namespace
}  // namespace burin::effect
