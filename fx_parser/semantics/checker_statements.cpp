// SPDX-License-Identifier: Apache-2.0
#include <set>

#include "fx_parser/semantics/checker.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/conversion.h"

namespace burin::fx {

void Checker::CheckStatement(ast::Statement& statement) {
  if (diagnostics_.exhausted()) return;
  std::visit([&](auto& node) { Visit(node, statement.range); }, statement.node);
}

void Checker::CheckStatements(std::vector<ast::StatementPtr>& statements) {
  for (auto& statement : statements) {
    if (statement != nullptr) CheckStatement(*statement);
  }
}

void Checker::CheckBody(ast::Statement& body) {
  scopes_.Push();
  CheckStatement(body);
  scopes_.Pop();
}

void Checker::CheckCondition(ast::ExpressionPtr& condition, const char* statement) {
  const Type type = CheckExpression(condition);
  if (type.kind == TypeKind::kError) return;
  if (!type.is_numeric() || type.components() != 1) {
    diagnostics_.Error(condition->range, "X3019",
                       std::string(statement) + " conditional expressions must evaluate to a scalar, not '" +
                           ToString(type) + "'" + (type.is_numeric() ? "; any() or all() makes one of it" : ""));
  }
}

void Checker::Visit(ast::Block& block, const Range&) {
  scopes_.Push();
  CheckStatements(block.statements);
  scopes_.Pop();
}

void Checker::CheckLocal(ast::Variable& variable) {
  variable.type = ResolveArrayType(variable.type_name, variable.array_sizes, variable.initializer.get());
  if (variable.type.kind == TypeKind::kVoid) {
    diagnostics_.Error(variable.range, "X3038",
                       "'" + variable.name + "': local variables cannot be declared as 'void'");
    variable.type = Type{};
  } else if (variable.type.kind == TypeKind::kSampler || variable.type.kind == TypeKind::kTexture) {
    diagnostics_.Error(variable.range, "X3000",
                       "'" + variable.name + "': samplers and textures must be declared at file scope");
    variable.type = Type{};
  }
  if ((variable.qualifiers & ast::kConst) != 0 && variable.initializer == nullptr) {
    diagnostics_.Error(variable.range, "X3012", "'" + variable.name + "': missing initial value");
  }
  if (variable.initializer != nullptr) CheckInitializer(*variable.initializer, variable.type, variable.name);
  DeclareVariable(variable);
}

void Checker::Visit(ast::DeclarationStatement& declaration, const Range&) {
  if (declaration.structure != nullptr) CheckStruct(*declaration.structure);
  for (auto& alias : declaration.typedefs) CheckTypedef(*alias);
  for (auto& variable : declaration.variables) CheckLocal(*variable);
}

void Checker::Visit(ast::ExpressionStatement& statement, const Range&) {
  if (statement.expression == nullptr) return;
  // Whether a technique runs into one of another machine's blocks, Unportable() tells.
  if (!std::holds_alternative<ast::AsmBlock>(statement.expression->node)) CheckExpression(statement.expression);
}

void Checker::Visit(ast::If& branch, const Range&) {
  CheckCondition(branch.condition, "if statement");
  if (branch.then_branch != nullptr) CheckBody(*branch.then_branch);
  if (branch.else_branch != nullptr) CheckBody(*branch.else_branch);
}

void Checker::Visit(ast::For& loop, const Range&) {
  scopes_.Push();
  if (loop.init != nullptr) CheckStatement(*loop.init);
  if (loop.condition != nullptr) CheckCondition(loop.condition, "loop");
  if (loop.step != nullptr) CheckExpression(loop.step);
  ++loop_depth_;
  if (loop.body != nullptr) CheckBody(*loop.body);
  --loop_depth_;
  scopes_.PopLeaking();
}

void Checker::Visit(ast::While& loop, const Range&) {
  CheckCondition(loop.condition, "loop");
  ++loop_depth_;
  if (loop.body != nullptr) CheckBody(*loop.body);
  --loop_depth_;
}

void Checker::Visit(ast::DoWhile& loop, const Range&) {
  ++loop_depth_;
  if (loop.body != nullptr) CheckBody(*loop.body);
  --loop_depth_;
  CheckCondition(loop.condition, "loop");
}

void Checker::Visit(ast::Switch& choice, const Range&) {
  const Type type = CheckExpression(choice.selector);
  if (type.kind != TypeKind::kError && (!type.is_numeric() || type.components() != 1)) {
    diagnostics_.Error(choice.selector->range, "X3019", "switch statement expressions must evaluate to a scalar");
  }
  std::set<double> seen;
  bool has_default = false;
  ++switch_depth_;
  scopes_.Push();
  for (ast::Case& arm : choice.cases) {
    if (arm.value == nullptr) {
      if (has_default) diagnostics_.Error(arm.range, "X3533", "duplicate default case in switch statement");
      has_default = true;
    } else if (CheckExpression(arm.value).kind != TypeKind::kError) {
      const auto value = EvaluateAs(*arm.value, ScalarType(Scalar::kInt));
      if (!value)
        diagnostics_.Error(arm.value->range, "X3020", "case values must be literal integers");
      else if (!seen.insert(value->numbers[0]).second)
        diagnostics_.Error(arm.value->range, "X3532", "duplicate case in switch statement");
    }
    CheckStatements(arm.statements);
  }
  scopes_.Pop();
  --switch_depth_;
}

void Checker::Visit(ast::Return& leave, const Range& range) {
  if (current_ == nullptr) return;
  const Type& wanted = current_->return_type;
  if (leave.value == nullptr) {
    if (wanted.kind != TypeKind::kVoid && wanted.kind != TypeKind::kError) {
      diagnostics_.Error(range, "X3080", "'" + current_->name + "': function must return a value");
    }
    return;
  }
  const Type type = CheckExpression(leave.value);
  if (wanted.kind == TypeKind::kVoid) {
    if (type.kind != TypeKind::kVoid && type.kind != TypeKind::kError) {
      diagnostics_.Error(leave.value->range, "X3079", "'" + current_->name + "': void functions cannot return a value");
    }
    return;
  }
  RequireConversion(*leave.value, wanted);
}

void Checker::Visit(ast::Break&, const Range& range) {
  if (loop_depth_ == 0 && switch_depth_ == 0)
    diagnostics_.Error(range, "X3518", "break must be inside a loop or switch");
}

void Checker::Visit(ast::Continue&, const Range& range) {
  if (loop_depth_ == 0) diagnostics_.Error(range, "X3519", "continue must be inside a loop");
}

void Checker::Visit(ast::Discard&, const Range&) {}

}  // namespace burin::fx
