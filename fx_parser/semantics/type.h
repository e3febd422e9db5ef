// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace burin::fx {

namespace ast {
struct Struct;
}

enum class TypeKind : std::uint8_t {
  kError,  ///< of an expression that already has a diagnostic; converts to everything silently
  kVoid,
  kNumeric,
  kString,
  kStruct,
  kTexture,
  kSampler,
  kVertexShader,
  kPixelShader,
  kStateBlock,
  kObject  ///< what shader models 1 to 3 have not: Texture2DArray, StructuredBuffer, GeometryShader ...
};
enum class Scalar : std::uint8_t { kBool, kInt, kUint, kHalf, kFloat, kDouble };
/// kUnknown: an untyped `sampler` or `texture`, whose dimension follows from its texture or its use.
enum class Dimension : std::uint8_t { kUnknown, k1D, k2D, k3D, kCube };

/// A complete HLSL type. Scalars are 1x1 with is_vector false; float1 is 1x1 with is_vector true; vectors have rows ==
/// 1 and columns == n; float3x4 has rows 3, columns 4. A texture with is_vector has elements of `columns` components.
struct Type {
  TypeKind kind = TypeKind::kError;
  Scalar scalar = Scalar::kFloat;
  std::uint8_t rows = 1;
  std::uint8_t columns = 1;
  bool is_vector = false;
  bool is_matrix = false;
  bool row_major = false;
  Dimension dimension = Dimension::kUnknown;
  const ast::Struct* structure = nullptr;
  std::vector<std::uint32_t> array;  ///< outermost first; empty: not an array

  bool operator==(const Type&) const = default;

  [[nodiscard]] bool is_array() const { return !array.empty(); }
  [[nodiscard]] bool is_numeric() const { return kind == TypeKind::kNumeric && array.empty(); }
  [[nodiscard]] bool is_scalar() const { return is_numeric() && !is_vector && !is_matrix; }
  [[nodiscard]] int components() const { return rows * columns; }
};

[[nodiscard]] Type ScalarType(Scalar scalar);
[[nodiscard]] Type VectorType(Scalar scalar, int columns);
[[nodiscard]] Type MatrixType(Scalar scalar, int rows, int columns);

/// As HLSL writes it: "float4x4", "sampler2D", "Light[3]".
[[nodiscard]] std::string ToString(const Type& type);

}  // namespace burin::fx
