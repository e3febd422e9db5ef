// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/conversion.h"

#include <algorithm>

#include "fx_parser/syntax/ast.h"

namespace burin::fx {
namespace {

constexpr int kScalarRankCost = 1;
constexpr int kScalarKindCost = 4;
constexpr int kNarrowingCost = 8;
constexpr int kSplatCost = 64;
constexpr int kReshapeCost = 128;
constexpr int kTruncationCost = 1024;

int ScalarCost(Scalar from, Scalar to) {
  if (from == to) return 0;
  if (IsFloating(from) && IsFloating(to)) return kScalarRankCost + (to < from ? 1 : 0);
  if (IsFloating(from)) return kNarrowingCost + (to == Scalar::kBool ? 1 : 0);
  if (to == Scalar::kBool) return kNarrowingCost;
  if (IsFloating(to)) return kScalarKindCost + (to == Scalar::kFloat ? 0 : 1);
  return kScalarRankCost;
}

std::optional<Conversion> NumericConversion(const Type& from, const Type& to) {
  Conversion result{ScalarCost(from.scalar, to.scalar), false};
  const int from_count = from.components();
  const int to_count = to.components();
  if (from.is_matrix && to.is_matrix) {
    if (to.rows > from.rows || to.columns > from.columns) {
      if (from_count != 1) return std::nullopt;
      result.cost += kSplatCost;
    } else if (to_count < from_count) {
      result.truncates = true;
    }
  } else if (from_count == 1) {
    if (to_count > 1)
      result.cost += kSplatCost;
    else if (from.is_vector != to.is_vector || from.is_matrix != to.is_matrix)
      result.cost += kScalarRankCost;
  } else if (from.is_matrix || to.is_matrix) {
    // A vector and a matrix convert when they hold the same number of components; a matrix also truncates to a scalar,
    // and a matrix of one row or column behaves as a vector.
    const bool is_line = from.is_matrix ? (from.rows == 1 || from.columns == 1) : (to.rows == 1 || to.columns == 1);
    if (from_count == to_count)
      result.cost += kReshapeCost;
    else if (to_count < from_count && (to_count == 1 || is_line))
      result.truncates = true;
    else
      return std::nullopt;
  } else if (to_count > from_count) {
    return std::nullopt;
  } else {
    result.truncates = to_count < from_count;
  }
  if (result.truncates) result.cost += kTruncationCost + from_count - to_count;
  return result;
}

/// As the checker has counted them, or counted now.
long ComponentsOf(const ast::Struct& structure) {
  if (structure.components != ast::Struct::kNotCounted) return structure.components;
  long count = 0;
  for (const auto& member : structure.members) {
    const long inner = FlatComponents(member->type);
    if (inner < 0) return -1;
    count += inner;
  }
  return count;
}

Scalar Promoted(Scalar scalar) { return scalar == Scalar::kBool ? Scalar::kInt : scalar; }

}  // namespace

bool IsFloating(Scalar scalar) {
  return scalar == Scalar::kHalf || scalar == Scalar::kFloat || scalar == Scalar::kDouble;
}
bool IsIntegral(Scalar scalar) { return scalar == Scalar::kInt || scalar == Scalar::kUint; }

Scalar CommonScalar(Scalar a, Scalar b) { return std::max(Promoted(a), Promoted(b)); }

Type WithScalar(Type type, Scalar scalar) {
  type.scalar = scalar;
  return type;
}

bool SameType(const Type& a, const Type& b) {
  if (a.row_major == b.row_major) return a == b;
  Type copy = a;
  copy.row_major = b.row_major;
  return copy == b;
}

std::optional<Conversion> ImplicitConversion(const Type& from, const Type& to) {
  if (from.kind == TypeKind::kError || to.kind == TypeKind::kError) return Conversion{};
  if (SameType(from, to)) return Conversion{};
  if (from.is_numeric() && to.is_numeric()) return NumericConversion(from, to);
  if (from.kind != to.kind || from.array != to.array) {
    // An array of one element, or a struct of one scalar, still needs a cast; an array of the same components does not.
    if (from.kind == TypeKind::kNumeric && to.kind == TypeKind::kNumeric && !from.is_matrix && !to.is_matrix &&
        FlatComponents(from) == FlatComponents(to) && from.scalar == to.scalar) {
      return Conversion{kReshapeCost, false};
    }
    return std::nullopt;
  }
  switch (from.kind) {
    case TypeKind::kNumeric: {
      Type from_element = from;
      Type to_element = to;
      from_element.array.clear();
      to_element.array.clear();
      const auto result = NumericConversion(from_element, to_element);
      if (!result || result->truncates || result->cost >= kSplatCost) return std::nullopt;
      return result;
    }
    case TypeKind::kSampler:
    case TypeKind::kTexture:
      if (from.dimension == Dimension::kUnknown || to.dimension == Dimension::kUnknown)
        return Conversion{kScalarRankCost, false};
      return std::nullopt;
    case TypeKind::kStruct:  // Cg: a struct is what its interface is
      if (to.structure != nullptr && to.structure->is_interface) return Conversion{kScalarRankCost, false};
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

bool ExplicitlyConvertible(const Type& from, const Type& to) {
  if (ImplicitConversion(from, to)) return true;
  const long from_count = FlatComponents(from);
  const long to_count = FlatComponents(to);
  if (from_count < 1 || to_count < 0) return false;
  if (from.is_numeric() && from_count == 1) return true;
  if (from.is_numeric() && to.is_numeric()) return from_count == to_count;
  return from_count >= to_count;
}

std::optional<Type> CommonType(const Type& a, const Type& b, Scalar minimum) {
  if (!a.is_numeric() || !b.is_numeric()) return std::nullopt;
  const Scalar scalar = std::max(CommonScalar(a.scalar, b.scalar), minimum);
  if (a.components() == 1 || b.components() == 1) {
    if (a.components() == 1 && b.components() == 1) {
      if (a.is_matrix || b.is_matrix) return MatrixType(scalar, 1, 1);
      return a.is_vector || b.is_vector ? VectorType(scalar, 1) : ScalarType(scalar);
    }
    Type wide = a.components() == 1 ? b : a;
    wide.row_major = false;
    return WithScalar(wide, scalar);
  }
  if (a.is_matrix && b.is_matrix) {
    const bool a_fits = a.rows <= b.rows && a.columns <= b.columns;
    const bool b_fits = b.rows <= a.rows && b.columns <= a.columns;
    if (!a_fits && !b_fits) return std::nullopt;
    return MatrixType(scalar, std::min(a.rows, b.rows), std::min(a.columns, b.columns));
  }
  if (a.is_matrix || b.is_matrix) {
    if (a.components() != b.components()) return std::nullopt;
    return VectorType(scalar, a.is_matrix ? b.columns : a.columns);
  }
  return VectorType(scalar, std::min(a.columns, b.columns));
}

std::optional<Type> ElementType(const Type& type) {
  if (type.is_array()) {
    Type element = type;
    element.array.erase(element.array.begin());
    return element;
  }
  if (type.kind != TypeKind::kNumeric) return std::nullopt;
  if (type.is_matrix) return VectorType(type.scalar, type.columns);
  if (type.is_vector) return ScalarType(type.scalar);
  return std::nullopt;
}

std::uint32_t ElementCount(const Type& type) {
  if (type.is_array()) return type.array.front();
  return type.is_matrix ? type.rows : type.columns;
}

long FlatComponents(const Type& type) {
  // The product of array sizes is bounded by the checker (kMaxArrayComponents), so it cannot overflow.
  long count = 0;
  if (type.kind == TypeKind::kNumeric) {
    count = type.rows * type.columns;
  } else if (type.kind == TypeKind::kStruct && type.structure != nullptr) {
    count = ComponentsOf(*type.structure);
    if (count < 0) return -1;
  } else {
    return -1;
  }
  for (const std::uint32_t size : type.array) count *= size;
  return count;
}

void AppendFlatScalars(const Type& type, std::vector<Scalar>& scalars) {
  if (type.is_array()) {
    const Type element = *ElementType(type);
    for (std::uint32_t i = 0; i < type.array.front(); ++i) AppendFlatScalars(element, scalars);
  } else if (type.kind == TypeKind::kStruct && type.structure != nullptr) {
    for (const auto& member : type.structure->members) AppendFlatScalars(member->type, scalars);
  } else if (type.kind == TypeKind::kNumeric) {
    scalars.insert(scalars.end(), static_cast<std::size_t>(type.components()), type.scalar);
  }
}

}  // namespace burin::fx
