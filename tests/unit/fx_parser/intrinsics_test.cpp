// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/intrinsics.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/unit/fx_parser/compile_effect.h"

namespace burin::fx {
namespace {

Type F(int columns) { return columns == 1 ? ScalarType(Scalar::kFloat) : VectorType(Scalar::kFloat, columns); }
Type Matrix(int rows, int columns) { return MatrixType(Scalar::kFloat, rows, columns); }

Type ResultOf(const char* name, const std::vector<Type>& arguments) {
  const int index = FindIntrinsic(name, arguments);
  if (index < 0) return Type{};
  return ResolveIntrinsic(Intrinsics()[static_cast<std::size_t>(index)], arguments)->result;
}

TEST(Intrinsics, CoverShaderModels1To3) {
  // learn.microsoft.com, "Intrinsic Functions (DirectX HLSL)", those whose minimum shader model is 1, 2 or 3.
  for (const char* name :
       {"abs",         "acos",        "all",         "any",         "asin",      "atan",      "atan2",
        "ceil",        "clamp",       "clip",        "cos",         "cosh",      "cross",     "D3DCOLORtoUBYTE4",
        "ddx",         "ddy",         "degrees",     "determinant", "distance",  "dot",       "exp",
        "exp2",        "faceforward", "floor",       "fmod",        "frac",      "frexp",     "fwidth",
        "isfinite",    "isinf",       "isnan",       "ldexp",       "length",    "lerp",      "lit",
        "log",         "log10",       "log2",        "max",         "min",       "modf",      "mul",
        "noise",       "normalize",   "pow",         "radians",     "reflect",   "refract",   "round",
        "rsqrt",       "saturate",    "sign",        "sin",         "sincos",    "sinh",      "smoothstep",
        "sqrt",        "step",        "tan",         "tanh",        "tex1D",     "tex1Dbias", "tex1Dgrad",
        "tex1Dlod",    "tex1Dproj",   "tex2D",       "tex2Dbias",   "tex2Dgrad", "tex2Dlod",  "tex2Dproj",
        "tex3D",       "tex3Dbias",   "tex3Dgrad",   "tex3Dlod",    "tex3Dproj", "texCUBE",   "texCUBEbias",
        "texCUBEgrad", "texCUBElod",  "texCUBEproj", "transpose",   "trunc"}) {
    EXPECT_TRUE(IsIntrinsic(name)) << name;
  }
  EXPECT_FALSE(IsIntrinsic("Tex2D")) << "names of functions have case";
}

TEST(Intrinsics, MulTakesAllItsShapes) {
  EXPECT_EQ(ResultOf("mul", {F(1), F(1)}), F(1));
  EXPECT_EQ(ResultOf("mul", {F(1), F(3)}), F(3));
  EXPECT_EQ(ResultOf("mul", {Matrix(2, 3), F(1)}), Matrix(2, 3));
  EXPECT_EQ(ResultOf("mul", {F(3), F(3)}), F(1));
  EXPECT_EQ(ResultOf("mul", {F(4), Matrix(4, 3)}), F(3));
  EXPECT_EQ(ResultOf("mul", {Matrix(3, 4), F(4)}), F(3));
  EXPECT_EQ(ResultOf("mul", {Matrix(2, 3), Matrix(3, 4)}), Matrix(2, 4));
  // The inner size is the smaller one: a float3 takes the first three rows of a float4x4.
  EXPECT_EQ(ResultOf("mul", {F(3), Matrix(4, 4)}), F(4));
}

TEST(Intrinsics, ShrinkToTheSmallestOperand) {
  EXPECT_EQ(ResultOf("lerp", {F(4), F(3), F(1)}), F(3));
  EXPECT_EQ(ResultOf("max", {VectorType(Scalar::kInt, 3), ScalarType(Scalar::kInt)}), VectorType(Scalar::kInt, 3));
  EXPECT_EQ(ResultOf("saturate", {ScalarType(Scalar::kInt)}), F(1));
  EXPECT_EQ(ResultOf("sign", {F(3)}), VectorType(Scalar::kInt, 3));
  EXPECT_EQ(ResultOf("isnan", {F(2)}), VectorType(Scalar::kBool, 2));
  EXPECT_EQ(ResultOf("transpose", {Matrix(2, 4)}), Matrix(4, 2));
  EXPECT_EQ(ResultOf("abs", {Matrix(3, 3)}), Matrix(3, 3));
}

TEST(Intrinsics, RefuseWhatDoesNotFit) {
  EXPECT_EQ(FindIntrinsic("cross", std::vector{F(2), F(3)}), -1);
  EXPECT_EQ(FindIntrinsic("dot", std::vector{Matrix(2, 2), F(4)}), -1);
  EXPECT_EQ(FindIntrinsic("determinant", std::vector{Matrix(2, 3)}), -1);
  EXPECT_EQ(FindIntrinsic("tex2D", std::vector{F(2), F(2)}), -1);
  EXPECT_EQ(FindIntrinsic("sin", std::vector{F(2), F(2)}), -1);
}

TEST(Intrinsics, EveryRowIsUsedByTheCorpus) {
  std::ifstream file(test::DataFile("intrinsics.fx"));
  std::stringstream text;
  text << file.rdbuf();
  for (const Intrinsic& intrinsic : Intrinsics()) {
    if (intrinsic.name == "sincos" || intrinsic.name == "modf" || intrinsic.name == "frexp" || intrinsic.name == "mul")
      continue;  // language.fx
    EXPECT_NE(text.str().find(std::string(intrinsic.name) + "("), std::string::npos) << intrinsic.name;
  }
}

TEST(Intrinsics, DescribeThemselves) {
  const int tex2d = FindIntrinsic("tex2Dlod", std::vector{[] {
                                                            Type sampler;
                                                            sampler.kind = TypeKind::kSampler;
                                                            return sampler;
                                                          }(),
                                                          F(4)});
  ASSERT_GE(tex2d, 0);
  EXPECT_EQ(DescribeIntrinsic(Intrinsics()[static_cast<std::size_t>(tex2d)]), "float4 tex2Dlod(sampler2D, float4)");
}

}  // namespace
}  // namespace burin::fx
