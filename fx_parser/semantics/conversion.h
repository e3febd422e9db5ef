// SPDX-License-Identifier: Apache-2.0
#pragma once
// HLSL's conversions between types: what is implicit, what needs a cast, and what an operator makes of two operands.

#include <optional>
#include <vector>

#include "fx_parser/semantics/type.h"

namespace burin::fx {

/// `cost` orders overloads: scalar promotions cost least, then changes of scalar kind, splats, truncations.
struct Conversion {
  int cost = 0;
  bool truncates = false;  ///< X3206
};

/// Empty when `from` does not convert to `to` without a cast.
[[nodiscard]] std::optional<Conversion> ImplicitConversion(const Type& from, const Type& to);

/// What `(to)from` allows: the implicit conversions, and anything whose components run out into `to`'s in order.
[[nodiscard]] bool ExplicitlyConvertible(const Type& from, const Type& to);

/// The type of `a + b`, whose scalar is at least `minimum`; empty on a type mismatch.
[[nodiscard]] std::optional<Type> CommonType(const Type& a, const Type& b, Scalar minimum = Scalar::kBool);

/// Bool promotes to int in arithmetic.
[[nodiscard]] Scalar CommonScalar(Scalar a, Scalar b);
[[nodiscard]] bool IsFloating(Scalar scalar);
[[nodiscard]] bool IsIntegral(Scalar scalar);

/// `type` with another scalar; numeric, not an array.
[[nodiscard]] Type WithScalar(Type type, Scalar scalar);

/// Equality without the storage order of matrices, which is no part of a value's type.
[[nodiscard]] bool SameType(const Type& a, const Type& b);

/// The type of `x[i]`; empty when `type` cannot be indexed.
[[nodiscard]] std::optional<Type> ElementType(const Type& type);

/// How many things `x[i]` chooses from.
[[nodiscard]] std::uint32_t ElementCount(const Type& type);

/// Number of numeric components of arrays, structs and all they hold; -1 when something in it is not numeric.
[[nodiscard]] long FlatComponents(const Type& type);

/// The scalars, in order, that `type` runs out into; all of FlatComponents().
void AppendFlatScalars(const Type& type, std::vector<Scalar>& scalars);

}  // namespace burin::fx
