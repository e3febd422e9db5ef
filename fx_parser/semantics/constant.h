// SPDX-License-Identifier: Apache-2.0
#pragma once
// Evaluates checked expressions: array sizes, parameter defaults, annotations, state values, const initialisers.

#include <functional>
#include <optional>

#include "fx_parser/effect/value.h"
#include "fx_parser/syntax/ast.h"

namespace burin::fx {

/// The value of a variable that is no constant, or null; the pointer must stay valid until the evaluation returns.
using VariableLookup = std::function<const Value*(const ast::Variable&)>;

/// Needs Expression::type filled in. Const variables with initialisers are constants. Empty for what no constant is:
/// texture look-ups, calls of user functions, variables that `lookup` does not know. Bounded work.
[[nodiscard]] std::optional<Value> Evaluate(const ast::Expression& expression, const VariableLookup& lookup = {});

/// The same, converted to `type`; initialiser lists too, which have no type of their own.
[[nodiscard]] std::optional<Value> EvaluateAs(const ast::Expression& expression, const Type& type,
                                              const VariableLookup& lookup = {});

/// Conversion by HLSL's rules (truncation towards zero, splats, component lists); empty when there is none.
[[nodiscard]] std::optional<Value> ConvertValue(const Value& value, const Type& type);

/// All components zero, all strings empty.
[[nodiscard]] Value ZeroValue(const Type& type);

/// One number rounded as a variable of this scalar type holds it.
[[nodiscard]] double RoundToScalar(double number, Scalar scalar);

/// A componentwise or geometric intrinsic over constants; empty when it has no constant value.
[[nodiscard]] std::optional<Value> EvaluateIntrinsic(int intrinsic, const std::vector<Value>& arguments,
                                                     const Type& result);

}  // namespace burin::fx
