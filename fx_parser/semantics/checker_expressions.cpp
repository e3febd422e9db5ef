// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fx_parser/semantics/checker.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/conversion.h"
#include "fx_parser/semantics/swizzle.h"
#include "fx_parser/semantics/walk.h"

namespace burin::fx {
namespace {

Type StringType() {
  Type type;
  type.kind = TypeKind::kString;
  return type;
}

bool IsComparison(ast::BinaryOperator op) {
  return op >= ast::BinaryOperator::kLess && op <= ast::BinaryOperator::kNotEqual;
}
bool IsLogic(ast::BinaryOperator op) { return op == ast::BinaryOperator::kAnd || op == ast::BinaryOperator::kOr; }
bool IsBitwise(ast::BinaryOperator op) {
  using enum ast::BinaryOperator;
  return op == kShl || op == kShr || op == kBitAnd || op == kBitXor || op == kBitOr;
}

std::string SuggestionText(const std::string& near) { return near.empty() ? "" : "; did you mean '" + near + "'?"; }

}  // namespace

Type Checker::CheckExpression(ast::ExpressionPtr& expression) {
  if (expression == nullptr) {  // what did not parse; a nameless name is an error nobody reports twice
    expression = std::make_unique<ast::Expression>();
    expression->node = ast::Name{};
  }
  return CheckExpression(*expression);
}

Type Checker::CheckExpression(ast::Expression& expression) {
  if (diagnostics_.exhausted()) return Type{};
  expression.type = std::visit([&](auto& node) { return Check(expression, node); }, expression.node);
  expression.type.row_major = false;
  return expression.type;
}

bool Checker::RequireNumeric(const ast::Expression& operand) {
  if (operand.type.kind == TypeKind::kError) return false;
  if (operand.type.is_numeric()) return true;
  diagnostics_.Error(operand.range, "X3022",
                     "scalar, vector, or matrix expected, found '" + ToString(operand.type) + "'");
  return false;
}

void Checker::WarnTruncation(const ast::Expression& operand, const Type& to) {
  const auto conversion = ImplicitConversion(operand.type, to);
  if (!conversion || !conversion->truncates) return;
  diagnostics_.Warning(operand.range, "X3206",
                       "implicit truncation of " + std::string(operand.type.is_matrix ? "matrix" : "vector") +
                           " type from '" + ToString(operand.type) + "' to '" + ToString(to) + "'");
}

bool Checker::RequireConversion(const ast::Expression& expression, const Type& to) {
  if (expression.type.kind == TypeKind::kError || to.kind == TypeKind::kError) return false;
  if (!ImplicitConversion(expression.type, to)) {
    diagnostics_.Error(expression.range, "X3017",
                       "cannot implicitly convert from '" + ToString(expression.type) + "' to '" + ToString(to) + "'");
    return false;
  }
  WarnTruncation(expression, to);
  return true;
}

bool Checker::RequireLvalue(const ast::Expression& target) {
  if (target.type.kind == TypeKind::kError) return false;
  // `float4(a, b.xyz) = v` assigns to the parts.
  if (const auto* parts = std::get_if<ast::Construct>(&target.node); parts != nullptr && parts->arguments.size() > 1) {
    return std::ranges::all_of(parts->arguments,
                               [&](const auto& part) { return RequireNumeric(*part) && RequireLvalue(*part); });
  }
  const ast::Variable* root = RootVariable(target);
  if (root == nullptr) {
    diagnostics_.Error(target.range, "X3025", "an assignable variable was expected here");
    return false;
  }
  if ((root->qualifiers & ast::kConst) != 0) {
    diagnostics_.Error(target.range, "X3025", "l-value specifies const object '" + root->name + "'")
        .notes.push_back({root->range, "'" + root->name + "' was declared here"});
    return false;
  }
  if (FlatComponents(target.type) < 0) {
    diagnostics_.Error(target.range, "X3025",
                       "'" + root->name + "': a " + ToString(target.type) + " cannot be assigned to");
    return false;
  }
  for (const ast::Expression* e = &target; e != nullptr;) {
    if (const auto* member = std::get_if<ast::Member>(&e->node)) {
      const auto swizzle = ParseSwizzle(member->operand->type, member->name);
      if (swizzle && HasDuplicates(*swizzle)) {
        diagnostics_.Error(member->name_range, "X3025",
                           "swizzle '" + member->name + "' names a component twice, so it cannot be assigned to");
        return false;
      }
      e = member->operand.get();
    } else if (const auto* index = std::get_if<ast::Index>(&e->node)) {
      e = index->operand.get();
    } else {
      e = nullptr;
    }
  }
  return true;
}

Type Checker::Check(ast::Expression&, ast::BoolLiteral&) { return ScalarType(Scalar::kBool); }
Type Checker::Check(ast::Expression&, ast::IntLiteral& n) {
  return ScalarType(n.is_unsigned ? Scalar::kUint : Scalar::kInt);
}
Type Checker::Check(ast::Expression&, ast::FloatLiteral& n) {
  return ScalarType(n.is_half ? Scalar::kHalf : Scalar::kFloat);
}
Type Checker::Check(ast::Expression&, ast::StringLiteral&) { return StringType(); }

Type Checker::Check(ast::Expression& e, ast::Name& n) {
  const Symbol* symbol = scopes_.Find(n.name);
  if (symbol != nullptr && symbol->variable != nullptr) {
    n.variable = symbol->variable;
    return symbol->variable->type;
  }
  if (symbol != nullptr) {
    diagnostics_.Error(e.range, "X3005", "identifier '" + n.name + "' represents a type, not a variable");
  } else if (functions_.contains(n.name)) {
    diagnostics_.Error(e.range, "X3005", "identifier '" + n.name + "' represents a function, not a variable");
  } else if (!after_syntax_errors_) {
    ReportUndeclared(n.name, e.range, NearestName(n.name, scopes_.VariableNames()));
  }
  return Type{};
}

Type Checker::Check(ast::Expression& e, ast::Unary& n) {
  const Type type = CheckExpression(n.operand);
  if (!RequireNumeric(*n.operand)) return Type{};
  switch (n.op) {
    case ast::UnaryOperator::kNot:
      return WithScalar(type, Scalar::kBool);
    case ast::UnaryOperator::kPlus:
    case ast::UnaryOperator::kNegate:
      return type.scalar == Scalar::kBool ? WithScalar(type, Scalar::kInt) : type;
    case ast::UnaryOperator::kBitNot:
      if (IsFloating(type.scalar)) {
        diagnostics_.Error(e.range, "X3082", "int or unsigned int type required");
        return Type{};
      }
      return type.scalar == Scalar::kBool ? WithScalar(type, Scalar::kInt) : type;
    default:
      return RequireLvalue(*n.operand) ? type : Type{};
  }
}

Type Checker::Check(ast::Expression& e, ast::Binary& n) {
  CheckExpression(n.left);
  CheckExpression(n.right);
  if (n.op == ast::BinaryOperator::kComma) return n.right->type;
  const bool left_numeric = RequireNumeric(*n.left);
  if (!RequireNumeric(*n.right) || !left_numeric) return Type{};
  const auto common = CommonType(n.left->type, n.right->type);
  if (!common) {
    diagnostics_.Error(e.range, "X3020",
                       "type mismatch: '" + ToString(n.left->type) + "' and '" + ToString(n.right->type) + "'");
    return Type{};
  }
  if (IsBitwise(n.op) && IsFloating(common->scalar)) {
    diagnostics_.Error(e.range, "X3082", "int or unsigned int type required");
    return Type{};
  }
  WarnTruncation(*n.left, WithScalar(*common, n.left->type.scalar));
  WarnTruncation(*n.right, WithScalar(*common, n.right->type.scalar));
  return IsComparison(n.op) || IsLogic(n.op) ? WithScalar(*common, Scalar::kBool) : *common;
}

Type Checker::Check(ast::Expression& e, ast::Assign& n) {
  const Type target = CheckExpression(n.target);
  CheckExpression(n.value);
  if (!RequireLvalue(*n.target)) return Type{};
  if (n.op) {
    const bool target_numeric = RequireNumeric(*n.target);
    if (!RequireNumeric(*n.value) || !target_numeric) return Type{};
    const auto common = CommonType(target, n.value->type);
    if (!common || !ImplicitConversion(WithScalar(*common, target.scalar), target)) {
      diagnostics_.Error(e.range, "X3020",
                         "type mismatch: '" + ToString(target) + "' and '" + ToString(n.value->type) + "'");
      return Type{};
    }
    if (IsBitwise(*n.op) && IsFloating(common->scalar)) {
      diagnostics_.Error(e.range, "X3082", "int or unsigned int type required");
      return Type{};
    }
    WarnTruncation(*n.value, WithScalar(*common, n.value->type.scalar));
    return target;
  }
  RequireConversion(*n.value, target);
  return target;
}

Type Checker::Check(ast::Expression& e, ast::Conditional& n) {
  const Type condition = CheckExpression(n.condition);
  const Type if_true = CheckExpression(n.if_true);
  const Type if_false = CheckExpression(n.if_false);
  if (!RequireNumeric(*n.condition) || if_true.kind == TypeKind::kError || if_false.kind == TypeKind::kError)
    return Type{};
  if (!if_true.is_numeric() || !if_false.is_numeric()) {
    if (SameType(if_true, if_false) && condition.components() == 1) return if_true;
    diagnostics_.Error(
        e.range, "X3020",
        "type mismatch between conditional values: '" + ToString(if_true) + "' and '" + ToString(if_false) + "'");
    return Type{};
  }
  auto common = CommonType(if_true, if_false);
  if (common && if_true.scalar == Scalar::kBool && if_false.scalar == Scalar::kBool) common->scalar = Scalar::kBool;
  if (!common) {
    diagnostics_.Error(
        e.range, "X3020",
        "type mismatch between conditional values: '" + ToString(if_true) + "' and '" + ToString(if_false) + "'");
    return Type{};
  }
  WarnTruncation(*n.if_true, WithScalar(*common, if_true.scalar));
  WarnTruncation(*n.if_false, WithScalar(*common, if_false.scalar));
  if (condition.components() == 1) return *common;
  // A vector condition chooses by component, and splats scalar values.
  if (common->components() == 1) return WithScalar(condition, common->scalar);
  if (common->components() != condition.components()) {
    diagnostics_.Error(
        n.condition->range, "X3020",
        "dimension of conditional does not match value: '" + ToString(condition) + "' and '" + ToString(*common) + "'");
    return Type{};
  }
  return *common;
}

Type Checker::Check(ast::Expression& e, ast::Construct& n) {
  const Type type = ResolveType(n.type);
  bool failed = type.kind == TypeKind::kError;
  long count = 0;
  for (auto& argument : n.arguments) {
    const Type argument_type = CheckExpression(argument);
    if (argument_type.kind == TypeKind::kError) {
      failed = true;
      continue;
    }
    const long components = FlatComponents(argument_type);
    if (components < 0) {
      diagnostics_.Error(argument->range, "X3022",
                         "scalar, vector, or matrix expected, found '" + ToString(argument_type) + "'");
      failed = true;
    }
    count += components;
  }
  if (failed) return Type{};
  if (!type.is_numeric()) {
    diagnostics_.Error(e.range, "X3037", "constructors only defined for numeric base types");
    return Type{};
  }
  // Lone scalars splat and lone larger vectors truncate, as a cast would.
  if (n.arguments.size() == 1 && ExplicitlyConvertible(n.arguments[0]->type, type)) {
    WarnTruncation(*n.arguments[0], type);
    return type;
  }
  if (count != type.components()) {
    diagnostics_.Error(e.range, "X3014",
                       "incorrect number of arguments to numeric-type constructor: '" + ToString(type) + "' takes " +
                           std::to_string(type.components()) + " components, found " + std::to_string(count));
    return Type{};
  }
  return type;
}

Type Checker::Check(ast::Expression& e, ast::Cast& n) {
  const Type type = ResolveArrayType(n.type, n.array_sizes, nullptr);
  const Type operand = CheckExpression(n.operand);
  if (type.kind == TypeKind::kError || operand.kind == TypeKind::kError) return Type{};
  if (!ExplicitlyConvertible(operand, type)) {
    diagnostics_.Error(e.range, "X3017", "cannot convert from '" + ToString(operand) + "' to '" + ToString(type) + "'");
    return Type{};
  }
  return type;
}

Type Checker::Check(ast::Expression&, ast::Member& n) {
  const Type operand = CheckExpression(n.operand);
  if (operand.kind == TypeKind::kError) return Type{};
  if (operand.kind == TypeKind::kStruct && !operand.is_array() && operand.structure != nullptr) {
    std::vector<std::string> names;
    for (const auto& member : operand.structure->members) {
      if (member->name == n.name) return member->type;
      names.push_back(member->name);
    }
    diagnostics_.Error(n.name_range, "X3018",
                       "invalid subscript '" + n.name + "': struct '" + ToString(operand) + "' has no such member" +
                           SuggestionText(NearestName(n.name, names)));
    return Type{};
  }
  if (operand.is_array() && n.name == "length") return ScalarType(Scalar::kInt);  // Cg's
  if (const auto swizzle = ParseSwizzle(operand, n.name)) return SwizzleType(operand, swizzle->size());
  diagnostics_.Error(n.name_range, "X3018",
                     "invalid subscript '" + n.name + "' of '" + ToString(operand) + "'" + DescribeComponents(operand));
  return Type{};
}

Type Checker::Check(ast::Expression& e, ast::Index& n) {
  const Type operand = CheckExpression(n.operand);
  const Type index = CheckExpression(n.index);
  if (operand.kind == TypeKind::kError || index.kind == TypeKind::kError) return Type{};
  const auto element = ElementType(operand);
  if (!element) {
    diagnostics_.Error(e.range, "X3121",
                       "array, matrix, vector, or indexable object type expected in index expression, found '" +
                           ToString(operand) + "'");
    return Type{};
  }
  if (!index.is_numeric() || index.components() != 1) {
    diagnostics_.Error(n.index->range, "X3120",
                       "invalid type for index: index must be a scalar, found '" + ToString(index) + "'");
    return Type{};
  }
  if (const auto value = Evaluate(*n.index); value && !value->numbers.empty()) {
    const double at = RoundToScalar(value->numbers[0], Scalar::kInt);
    if (at < 0 || at >= ElementCount(operand)) {
      diagnostics_.Error(n.index->range, "X3504",
                         "index out of bounds: '" + ToString(operand) + "' has " +
                             std::to_string(ElementCount(operand)) + " elements");
      return Type{};
    }
  }
  return *element;
}

long Checker::CheckListElements(ast::InitializerList& list) {
  long count = 0;
  bool failed = false;
  for (auto& element : list.elements) {
    long components = -1;
    if (auto* inner = element != nullptr ? std::get_if<ast::InitializerList>(&element->node) : nullptr) {
      components = CheckListElements(*inner);
    } else {
      const Type type = CheckExpression(element);
      components = type.kind == TypeKind::kError ? -1 : type.kind == TypeKind::kString ? 1 : FlatComponents(type);
      if (components < 0 && type.kind != TypeKind::kError) {
        diagnostics_.Error(element->range, "X3022",
                           "scalar, vector, or matrix expected, found '" + ToString(type) + "'");
      }
    }
    failed = failed || components < 0;
    count += components;
  }
  return failed ? -1 : count;
}

void Checker::CheckInitializer(ast::Expression& initializer, const Type& type, const std::string& name) {
  auto* list = std::get_if<ast::InitializerList>(&initializer.node);
  if (list == nullptr) {
    CheckExpression(initializer);
    RequireConversion(initializer, type);
    return;
  }
  const long count = CheckListElements(*list);
  initializer.type = type;
  if (count < 0 || type.kind == TypeKind::kError) return;
  long wanted = FlatComponents(type);
  if (type.kind == TypeKind::kString) wanted = static_cast<long>(ZeroValue(type).strings.size());
  if (count != wanted) {
    diagnostics_.Error(initializer.range, "X3017",
                       "'" + name + "': initializer does not match type: '" + ToString(type) + "' takes " +
                           std::to_string(wanted) + " values, found " + std::to_string(count));
  }
}

Type Checker::Check(ast::Expression& e, ast::InitializerList& list) {
  CheckListElements(list);
  diagnostics_.Error(e.range, "X3000", "an initializer list is only allowed as an initial value");
  return Type{};
}

Type Checker::Check(ast::Expression& e, ast::Compile&) {
  diagnostics_.Error(e.range, "X3000", "a compile expression is only allowed as a shader's value");
  return Type{};
}
Type Checker::Check(ast::Expression& e, ast::AsmBlock&) {
  diagnostics_.Error(e.range, "X3000", "an asm block is only allowed as a shader's value");
  return Type{};
}
Type Checker::Check(ast::Expression& e, ast::StateBlockExpression&) {
  diagnostics_.Error(e.range, "X3000", "a state block is only allowed as an initial value");
  return Type{};
}

}  // namespace burin::fx
