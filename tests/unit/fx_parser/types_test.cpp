// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fx_parser/semantics/conversion.h"
#include "fx_parser/semantics/swizzle.h"
#include "fx_parser/syntax/ast.h"

namespace burin::fx {
namespace {

const Type kFloat1 = VectorType(Scalar::kFloat, 1);
const Type kFloat2 = VectorType(Scalar::kFloat, 2);
const Type kFloat3 = VectorType(Scalar::kFloat, 3);
const Type kFloat4 = VectorType(Scalar::kFloat, 4);
const Type kFloat = ScalarType(Scalar::kFloat);
const Type kInt = ScalarType(Scalar::kInt);
const Type kBool = ScalarType(Scalar::kBool);
const Type kFloat4x4 = MatrixType(Scalar::kFloat, 4, 4);

Type Array(Type element, std::vector<std::uint32_t> sizes) {
  element.array = std::move(sizes);
  return element;
}

TEST(Type, IsWrittenAsInHlsl) {
  EXPECT_EQ(ToString(kFloat), "float");
  EXPECT_EQ(ToString(kFloat1), "float1");
  EXPECT_EQ(ToString(VectorType(Scalar::kHalf, 3)), "half3");
  EXPECT_EQ(ToString(MatrixType(Scalar::kInt, 2, 3)), "int2x3");
  EXPECT_EQ(ToString(Array(kFloat4, {3, 2})), "float4[3][2]");
  Type sampler;
  sampler.kind = TypeKind::kSampler;
  EXPECT_EQ(ToString(sampler), "sampler");
  sampler.dimension = Dimension::kCube;
  EXPECT_EQ(ToString(sampler), "samplerCUBE");
}

TEST(ImplicitConversion, SplatsScalars) {
  for (const Type& to : {kFloat2, kFloat4, kFloat4x4, VectorType(Scalar::kInt, 3)}) {
    const auto conversion = ImplicitConversion(kFloat, to);
    ASSERT_TRUE(conversion) << ToString(to);
    EXPECT_FALSE(conversion->truncates);
  }
  EXPECT_TRUE(ImplicitConversion(kFloat1, kFloat3));
}

TEST(ImplicitConversion, TruncatesVectorsAndMatrices) {
  for (const auto& [from, to] :
       {std::pair(kFloat4, kFloat3), std::pair(kFloat4, kFloat), std::pair(kFloat4x4, MatrixType(Scalar::kFloat, 3, 3)),
        std::pair(kFloat4x4, kFloat)}) {
    const auto conversion = ImplicitConversion(from, to);
    ASSERT_TRUE(conversion) << ToString(from) << " to " << ToString(to);
    EXPECT_TRUE(conversion->truncates) << ToString(from) << " to " << ToString(to);
  }
}

TEST(ImplicitConversion, NeverInventsComponents) {
  EXPECT_FALSE(ImplicitConversion(kFloat2, kFloat4));
  EXPECT_FALSE(ImplicitConversion(kFloat4x4, kFloat3));
  EXPECT_FALSE(ImplicitConversion(MatrixType(Scalar::kFloat, 3, 3), kFloat4x4));
  EXPECT_FALSE(ImplicitConversion(Array(kFloat, {2}), Array(kFloat, {3})));
  EXPECT_FALSE(ImplicitConversion(kFloat, Array(kFloat, {3})));
}

TEST(ImplicitConversion, PrefersTheNearestType) {
  const auto cost = [](const Type& from, const Type& to) { return ImplicitConversion(from, to)->cost; };
  EXPECT_EQ(cost(kFloat, kFloat), 0);
  EXPECT_LT(cost(kInt, ScalarType(Scalar::kUint)), cost(kInt, kFloat));
  EXPECT_LT(cost(kInt, kFloat), cost(kFloat, kInt));
  EXPECT_LT(cost(kFloat, kInt), cost(kFloat, kFloat4));
  EXPECT_LT(cost(kFloat, kFloat4), cost(kFloat4, kFloat));
  EXPECT_LT(cost(kFloat4, kFloat3), cost(kFloat4, kFloat));
}

TEST(ExplicitConversion, TakesWhatRunsOutFarEnough) {
  ast::Struct pair;
  pair.members.push_back(std::make_unique<ast::Variable>());
  pair.members.push_back(std::make_unique<ast::Variable>());
  pair.members[0]->type = kFloat3;
  pair.members[1]->type = kFloat;
  Type structure;
  structure.kind = TypeKind::kStruct;
  structure.structure = &pair;
  EXPECT_EQ(FlatComponents(structure), 4);
  EXPECT_TRUE(ExplicitlyConvertible(kInt, structure));
  EXPECT_TRUE(ExplicitlyConvertible(structure, kFloat4));
  EXPECT_TRUE(ExplicitlyConvertible(kFloat4, structure));
  EXPECT_FALSE(ExplicitlyConvertible(kFloat3, structure));
  EXPECT_FALSE(ImplicitConversion(kFloat4, structure));
  EXPECT_TRUE(ExplicitlyConvertible(kFloat4, Array(kFloat, {4})));
  EXPECT_FALSE(ExplicitlyConvertible(kFloat3, kFloat4));
}

TEST(CommonType, TakesTheSmallerShapeAndTheLargerScalar) {
  EXPECT_EQ(*CommonType(kFloat4, kFloat2), kFloat2);
  EXPECT_EQ(*CommonType(kInt, kFloat3), kFloat3);
  EXPECT_EQ(*CommonType(VectorType(Scalar::kInt, 3), kFloat), kFloat3);
  EXPECT_EQ(*CommonType(kBool, kBool), kInt) << "arithmetic on bools is on ints";
  EXPECT_EQ(*CommonType(kFloat4x4, MatrixType(Scalar::kFloat, 3, 4)), MatrixType(Scalar::kFloat, 3, 4));
  EXPECT_EQ(*CommonType(kFloat4, MatrixType(Scalar::kFloat, 2, 2)), kFloat4);
  EXPECT_FALSE(CommonType(kFloat4, kFloat4x4));
  EXPECT_FALSE(CommonType(MatrixType(Scalar::kFloat, 2, 3), MatrixType(Scalar::kFloat, 3, 2)));
  EXPECT_FALSE(CommonType(Array(kFloat, {2}), kFloat));
}

TEST(Swizzle, TakesVectorsAndScalars) {
  using C = SwizzleComponent;
  EXPECT_THAT(*ParseSwizzle(kFloat4, "wzyx"), testing::ElementsAre(C{0, 3}, C{0, 2}, C{0, 1}, C{0, 0}));
  EXPECT_THAT(*ParseSwizzle(kFloat4, "bgr"), testing::ElementsAre(C{0, 2}, C{0, 1}, C{0, 0}));
  EXPECT_THAT(*ParseSwizzle(kFloat, "xxx"), testing::SizeIs(3));
  for (const char* wrong : {"xr", "xyzwx", "", "q", "_m00"}) EXPECT_FALSE(ParseSwizzle(kFloat4, wrong)) << wrong;
  EXPECT_FALSE(ParseSwizzle(kFloat2, "z"));
}

TEST(Swizzle, TakesMatricesCountedFromZeroAndFromOne) {
  using C = SwizzleComponent;
  EXPECT_THAT(*ParseSwizzle(kFloat4x4, "_m00_m31"), testing::ElementsAre(C{0, 0}, C{3, 1}));
  EXPECT_THAT(*ParseSwizzle(kFloat4x4, "_11_42"), testing::ElementsAre(C{0, 0}, C{3, 1}));
  for (const char* wrong : {"_m04", "_01", "_m00_11", "_11_m00", "x", "_m0", "_15"})
    EXPECT_FALSE(ParseSwizzle(kFloat4x4, wrong)) << wrong;
  EXPECT_EQ(SwizzleType(kFloat4x4, 1), kFloat);
  EXPECT_EQ(SwizzleType(kFloat4x4, 3), kFloat3);
  EXPECT_TRUE(HasDuplicates(*ParseSwizzle(kFloat4, "xyx")));
}

TEST(ElementType, PeelsArraysThenRowsThenComponents) {
  EXPECT_EQ(*ElementType(Array(kFloat4, {3, 2})), Array(kFloat4, {2}));
  EXPECT_EQ(*ElementType(MatrixType(Scalar::kFloat, 2, 3)), kFloat3);
  EXPECT_EQ(*ElementType(kFloat3), kFloat);
  EXPECT_FALSE(ElementType(kFloat));
}

}  // namespace
}  // namespace burin::fx
