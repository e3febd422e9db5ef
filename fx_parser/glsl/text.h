// SPDX-License-Identifier: Apache-2.0
#pragma once
// Types and constants as GLSL text.

#include <string>

#include "fx_parser/semantics/type.h"

namespace burin::fx {

/// How a numeric type without arrays is held. Half and double are float. Matrices are of floats, whatever their scalar;
/// those of one row or column are vectors, of their own scalar, and float1 and float1x1 are scalars.
struct Storage {
  Scalar scalar = Scalar::kFloat;  ///< kBool, kInt, kUint or kFloat
  int columns = 1;                 ///< GLSL columns: 1 for scalars and vectors, HLSL's rows for matrices
  int size = 1;                    ///< components of a scalar or vector, or of each column
  bool operator==(const Storage&) const = default;
  [[nodiscard]] bool is_matrix() const { return columns > 1; }
};

[[nodiscard]] Storage StorageOf(const Type& numeric);
/// "vec3", "ivec2", "mat3x4".
[[nodiscard]] std::string StorageText(const Storage& storage);

/// A literal that reads back as the same 32-bit number.
[[nodiscard]] std::string NumberText(double number, Scalar scalar);

/// True for identifiers, literals and constant paths ("a.b[1].x"), which cost nothing to write twice.
[[nodiscard]] bool IsSimpleText(const std::string& text);

}  // namespace burin::fx
