// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/negated_variables.h"

#include "fx_parser/semantics/walk.h"

namespace burin::fx {

std::set<const ast::Variable*> NegatedVariables(const ast::Module& module) {
  std::set<const ast::Variable*> negated;
  const auto note = [&](const ast::Expression& inner) {
    if (const auto* name = std::get_if<ast::Name>(&inner.node); name != nullptr && name->variable != nullptr)
      negated.insert(name->variable);
  };
  const auto visit = [&](const ast::Expression& expression) {
    const auto* unary = std::get_if<ast::Unary>(&expression.node);
    if (unary != nullptr && unary->op == ast::UnaryOperator::kNegate) ForEachExpression(*unary->operand, note);
  };
  for (const ast::Declaration& declaration : module.declarations) {
    const auto* function = std::get_if<std::unique_ptr<ast::Function>>(&declaration);
    if (function != nullptr && (*function)->body != nullptr) ForEachExpression(*(*function)->body, visit);
  }
  return negated;
}

}  // namespace burin::fx
