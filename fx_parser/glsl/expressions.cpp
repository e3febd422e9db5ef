// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/glsl/function_writer.h"
#include "fx_parser/glsl/interface.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/conversion.h"
#include "fx_parser/semantics/walk.h"

namespace burin::fx {

bool NeedsEveryInvocation(const ast::Expression& e) {
  bool needs = false;
  ForEachExpression(e, [&](const ast::Expression& inner) {
    if (std::holds_alternative<ast::Assign>(inner.node)) needs = true;
    if (const auto* unary = std::get_if<ast::Unary>(&inner.node))
      needs = needs || unary->op >= ast::UnaryOperator::kPreIncrement;
    const auto* call = std::get_if<ast::Call>(&inner.node);
    if (call == nullptr) return;
    constexpr unsigned kTraits = kImplicitDerivatives | kHasEffect;
    // A user's function may do either.
    needs = needs || call->function != nullptr ||
            (call->intrinsic >= 0 && (Intrinsics()[static_cast<std::size_t>(call->intrinsic)].traits & kTraits) != 0);
  });
  return needs;
}

std::string FunctionWriter::Expression(const ast::Expression& e) {
  if (stage_.failed()) return "0";
  return std::visit([&](const auto& node) { return Emit(e, node); }, e.node);
}

std::string FunctionWriter::Emit(const ast::Expression&, const ast::BoolLiteral& n) {
  return n.value ? "true" : "false";
}
std::string FunctionWriter::Emit(const ast::Expression& e, const ast::IntLiteral& n) {
  return NumberText(RoundToScalar(static_cast<double>(n.value), e.type.scalar), e.type.scalar);
}
std::string FunctionWriter::Emit(const ast::Expression&, const ast::FloatLiteral& n) {
  return NumberText(n.value, Scalar::kFloat);
}
std::string FunctionWriter::Emit(const ast::Expression& e, const ast::StringLiteral&) {
  stage_.Error(e.range, "X3017", "a string cannot be used in a shader");
  return "0";
}

std::string FunctionWriter::Emit(const ast::Expression& e, const ast::Name& n) {
  if (n.variable == nullptr) return "0";
  if (FlatComponents(n.variable->type) < 0) {
    stage_.Error(e.range, "X3017",
                 "'" + n.name + "' is a " + ToString(n.variable->type) + ", which has no value in a shader");
    return "0";
  }
  return stage_.VariableName(*n.variable);
}

std::string FunctionWriter::Emit(const ast::Expression& e, const ast::Assign& n) {
  if (const auto* parts = std::get_if<ast::Construct>(&n.target->node)) {
    const std::string value = n.op ? CompoundValue(n, e.type, Expression(*n.target)) : ExpressionAs(*n.value, e.type);
    return Distribute(*parts, e.type, value);
  }
  const Lvalue target = Target(*n.target);
  if (!n.op) return Store(target, Expression(*n.value), n.value->type);
  const Type& value_type = n.value->type;
  const auto common = CommonType(e.type, value_type);
  if (!common) return "0";
  using enum ast::BinaryOperator;
  const bool plain = *n.op == kAdd || *n.op == kSub || (*n.op == kMul && !e.type.is_matrix);
  if (plain && IsFloating(e.type.scalar) && IsDirect(target, *common)) {
    const Type wanted = value_type.components() == 1 ? ScalarType(e.type.scalar) : e.type;
    return "(" + target.text +
           (*n.op == kAdd   ? " += "
            : *n.op == kSub ? " -= "
                            : " *= ") +
           ExpressionAs(*n.value, wanted) + ")";
  }
  return Store(target, CompoundValue(n, *common, Read(target)), *common);
}

/// What `target op= value` assigns, as a `result`.
std::string FunctionWriter::CompoundValue(const ast::Assign& n, const Type& result, const std::string& target) {
  const auto constant = Evaluate(*n.value);
  bool safe = constant.has_value();
  for (const double x : constant ? constant->numbers : std::vector<double>{}) safe = safe && x != 0;
  return Arithmetic(*n.op, result, target, n.target->type, Expression(*n.value), n.value->type, safe);
}

/// A value of vector or matrix type to the parts of a constructor, in order.
std::string FunctionWriter::Distribute(const ast::Construct& parts, const Type& type, const std::string& value) {
  const std::string whole = NewTemporary(type);
  std::string text = whole + " = " + value;
  std::vector<std::string> components;
  Components(whole, type, components);
  std::size_t next = 0;
  for (const auto& part : parts.arguments) {
    const std::vector<Scalar> scalars(components.size(), StorageOf(type).is_matrix() ? Scalar::kFloat : type.scalar);
    const std::string piece = FromComponents(part->type, components, scalars, next);
    text += ", " + Store(Target(*part), piece, part->type);
  }
  return "(" + text + ", " + whole + ")";
}

std::string FunctionWriter::Emit(const ast::Expression& e, const ast::Conditional& n) {
  const Type& condition = n.condition->type;
  const std::string if_true = ExpressionAs(*n.if_true, e.type);
  const std::string if_false = ExpressionAs(*n.if_false, e.type);
  const bool everywhere = NeedsEveryInvocation(*n.if_true) || NeedsEveryInvocation(*n.if_false);
  if (condition.components() == 1) {
    const std::string test = ExpressionAs(*n.condition, ScalarType(Scalar::kBool));
    if (everywhere && e.type.is_numeric()) {
      return stage_.PreludeName("burin_select", stage_.TypeText(e.type)) + "(" + test + ", " + if_true + ", " +
             if_false + ")";
    }
    return "(" + test + " ? " + if_true + " : " + if_false + ")";
  }
  // A vector may choose among a matrix's components and the other way round.
  const std::string test = ExpressionAs(*n.condition, WithScalar(e.type, Scalar::kBool));
  if (StorageOf(e.type).is_matrix()) return MatrixSelect(e.type, test, if_true, if_false);
  return Prelude("burin_mix", StorageOf(e.type)) + "(" + test + ", " + if_true + ", " + if_false + ")";
}

std::string FunctionWriter::Emit(const ast::Expression& e, const ast::Construct& n) {
  if (n.arguments.size() == 1) return ExpressionAs(*n.arguments[0], e.type);
  // GLSL's own constructors do for vectors; a matrix takes components row by row in both languages.
  if (e.type.is_matrix || StorageOf(e.type).size == 1) return List(n.arguments, e.type);
  std::string list;
  for (const auto& argument : n.arguments) {
    Type wanted = WithScalar(argument->type, e.type.scalar);
    if (argument->type.is_array() || argument->type.kind == TypeKind::kStruct || StorageOf(wanted).is_matrix())
      return List(n.arguments, e.type);
    list += (list.empty() ? "" : ", ") + ExpressionAs(*argument, wanted);
  }
  return StorageText(StorageOf(e.type)) + "(" + list + ")";
}

std::string FunctionWriter::Emit(const ast::Expression& e, const ast::Cast& n) {
  return ExpressionAs(*n.operand, e.type);
}

std::string FunctionWriter::Emit(const ast::Expression&, const ast::Member& n) {
  const Type& type = n.operand->type;
  if (type.is_array()) return std::to_string(type.array.front());  // .length
  const std::string operand = Expression(*n.operand);
  if (type.kind == TypeKind::kStruct) return operand + "." + GlslMemberName(n.name);
  const auto swizzle = ParseSwizzle(type, n.name);
  return swizzle ? SwizzleText(operand, type, *swizzle) : operand;
}

std::string FunctionWriter::Emit(const ast::Expression& e, const ast::Index& n) {
  const Type& type = n.operand->type;
  const std::string operand = Expression(*n.operand);
  const std::string element = ElementText(operand, type, IndexText(*n.index, ElementCount(type)));
  if (type.is_array() || !type.is_matrix) return element;
  Storage held = StorageOf(type);
  held.columns = 1;
  held.size = type.columns;
  return FromStorage(element, held, e.type);
}

std::string FunctionWriter::Emit(const ast::Expression& e, const ast::InitializerList& n) {
  return List(n.elements, e.type);
}
std::string FunctionWriter::Emit(const ast::Expression&, const ast::Compile&) { return "0"; }
std::string FunctionWriter::Emit(const ast::Expression&, const ast::AsmBlock&) { return "0"; }
std::string FunctionWriter::Emit(const ast::Expression&, const ast::StateBlockExpression&) { return "0"; }

}  // namespace burin::fx
