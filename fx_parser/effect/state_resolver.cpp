// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "fx_parser/effect/builder.h"
#include "fx_parser/effect/case.h"
#include "fx_parser/effect/state_table.h"
#include "fx_parser/semantics/constant.h"

namespace burin::fx {
namespace {

Value IntegerValue(double number) { return Value{ScalarType(Scalar::kInt), {number}, {}}; }

/// D3DCOLOR of float components r, g, b, a.
double PackColor(const std::vector<double>& color) {
  const auto byte = [&](std::size_t i, double missing) {
    const double x = i < color.size() ? color[i] : missing;
    return static_cast<std::uint32_t>(std::lround(std::clamp(x, 0.0, 1.0) * 255));
  };
  return static_cast<double>(byte(3, 1) << 24 | byte(0, 0) << 16 | byte(1, 0) << 8 | byte(2, 0));
}

Value StateConstant(const Value& value, StateKind kind) {
  if (kind == StateKind::kColor && value.numbers.size() > 1)
    return Value{ScalarType(Scalar::kUint), {PackColor(value.numbers)}, {}};
  if (kind == StateKind::kFloat) return Value{ScalarType(Scalar::kFloat), {value.numbers[0]}, {}};
  // States are DWORDs: 0xffffffff is an int literal of value -1.
  if (kind == StateKind::kColor || value.type.scalar == Scalar::kUint || value.numbers[0] < 0) {
    return Value{ScalarType(Scalar::kUint), {RoundToScalar(value.numbers[0], Scalar::kUint)}, {}};
  }
  return IntegerValue(std::trunc(value.numbers[0]));
}

std::string Choices(std::span<const Enumerant> values) {
  std::string text;
  for (const Enumerant& value : values) text += (text.empty() ? "" : ", ") + std::string(value.name);
  return text;
}

}  // namespace

/// Names and OR-lists of names; empty when anything else stands there.
std::optional<int> EffectBuilder::EnumerantValue(const ast::Expression& value, std::span<const Enumerant> values) {
  if (const auto* name = std::get_if<ast::Name>(&value.node)) return FindEnumerant(values, name->name);
  if (const auto* literal = std::get_if<ast::IntLiteral>(&value.node)) {
    return literal->value <= 0x7fffffffu ? std::optional(static_cast<int>(literal->value)) : std::nullopt;
  }
  const auto* binary = std::get_if<ast::Binary>(&value.node);
  if (binary == nullptr || binary->op != ast::BinaryOperator::kBitOr) return std::nullopt;
  const auto left = EnumerantValue(*binary->left, values);
  const auto right = left ? EnumerantValue(*binary->right, values) : std::nullopt;
  return right ? std::optional(*left | *right) : std::nullopt;
}

Type EffectBuilder::CheckStateValue(ast::Expression& value) {
  const auto* list = std::get_if<ast::InitializerList>(&value.node);
  if (list == nullptr || list->elements.empty() || list->elements.size() > 4) return checker_.CheckExpression(value);
  const Type type = VectorType(Scalar::kFloat, static_cast<int>(list->elements.size()));
  const int errors = diagnostics_.error_count();
  checker_.CheckInitializer(value, type, "the value");
  return diagnostics_.error_count() == errors ? type : Type{};
}

std::optional<StateValue> EffectBuilder::ResolveState(ast::Expression& value, const std::string& state, int kind,
                                                      std::span<const Enumerant> values,
                                                      ast::StateAssignment::Form form) {
  const auto state_kind = static_cast<StateKind>(kind);
  // `<name>` is always a parameter; elsewhere a value's name goes before a parameter's, as in Direct3D.
  if (form != ast::StateAssignment::Form::kAngled) {
    if (const auto number = EnumerantValue(value, values)) {
      return state_kind == StateKind::kFloat ? Value{ScalarType(Scalar::kFloat), {static_cast<double>(*number)}, {}}
                                             : IntegerValue(*number);
    }
  }
  if (const auto* name = std::get_if<ast::Name>(&value.node);
      name != nullptr && checker_.FindGlobal(name->name) == nullptr) {
    std::vector<std::string> names;
    for (const Enumerant& enumerant : values) names.emplace_back(enumerant.name);
    const std::string near = NearestName(name->name, names);
    diagnostics_.Error(value.range, "X3004",
                       "undeclared identifier '" + name->name + "' as value of " + state +
                           (near.empty() ? ": expected a number, a parameter or one of true, false, " + Choices(values)
                                         : "; did you mean '" + near + "'?"));
    return std::nullopt;
  }
  // A list has no type of its own: `BorderColor = { 0, 0, 0, 1 }`.
  const Type type = CheckStateValue(value);
  if (type.kind == TypeKind::kError) return std::nullopt;
  const bool is_color = state_kind == StateKind::kColor && type.is_numeric();
  if (!type.is_numeric() || (type.components() != 1 && !is_color)) {
    diagnostics_.Error(value.range, "X3020", state + " takes a number, found '" + ToString(type) + "'");
    return std::nullopt;
  }
  if (const auto constant = EvaluateAs(value, type)) return StateConstant(*constant, state_kind);
  return static_cast<const ast::Expression*>(&value);
}

}  // namespace burin::fx
