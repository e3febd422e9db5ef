// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/flow.h"

#include <algorithm>

namespace burin::fx {
namespace {

bool AnyReturns(const std::vector<ast::StatementPtr>& statements) {
  return std::ranges::any_of(statements, [](const auto& s) { return AlwaysReturns(*s); });
}

/// Whether a break in it leaves the loop whose body it is.
bool Breaks(const ast::Statement& statement) {
  const auto breaks = [](const ast::StatementPtr& s) { return s != nullptr && Breaks(*s); };
  if (std::holds_alternative<ast::Break>(statement.node)) return true;
  if (const auto* block = std::get_if<ast::Block>(&statement.node))
    return std::ranges::any_of(block->statements, breaks);
  if (const auto* branch = std::get_if<ast::If>(&statement.node))
    return breaks(branch->then_branch) || breaks(branch->else_branch);
  return false;
}

bool IsAlwaysTrue(const ast::ExpressionPtr& condition) {
  if (condition == nullptr) return true;
  if (const auto* literal = std::get_if<ast::BoolLiteral>(&condition->node)) return literal->value;
  const auto* number = std::get_if<ast::IntLiteral>(&condition->node);
  return number != nullptr && number->value != 0;
}

/// A loop without end is left by a return or not at all.
bool IsEndless(const ast::ExpressionPtr& condition, const ast::StatementPtr& body) {
  return IsAlwaysTrue(condition) && body != nullptr && !Breaks(*body);
}

bool Has(const ast::StatementPtr& statement) { return statement != nullptr && HasReturn(*statement); }

/// A case without a return falls into the next; a break anywhere in it leaves the switch.
bool SwitchReturns(const ast::Switch& choice) {
  bool has_default = false;
  for (std::size_t i = 0; i < choice.cases.size(); ++i) {
    const ast::Case& arm = choice.cases[i];
    has_default = has_default || arm.value == nullptr;
    const bool last = i + 1 == choice.cases.size();
    if (!AnyReturns(arm.statements) && (last || !arm.statements.empty())) return false;
  }
  return has_default;
}

}  // namespace

bool AlwaysReturns(const ast::Statement& statement) {
  if (std::holds_alternative<ast::Return>(statement.node)) return true;
  if (const auto* block = std::get_if<ast::Block>(&statement.node)) return AnyReturns(block->statements);
  if (const auto* branch = std::get_if<ast::If>(&statement.node)) {
    return branch->else_branch != nullptr && branch->then_branch != nullptr && AlwaysReturns(*branch->then_branch) &&
           AlwaysReturns(*branch->else_branch);
  }
  if (const auto* loop = std::get_if<ast::DoWhile>(&statement.node))
    return loop->body != nullptr && (AlwaysReturns(*loop->body) || IsEndless(loop->condition, loop->body));
  if (const auto* loop = std::get_if<ast::While>(&statement.node)) return IsEndless(loop->condition, loop->body);
  if (const auto* loop = std::get_if<ast::For>(&statement.node)) return IsEndless(loop->condition, loop->body);
  if (const auto* choice = std::get_if<ast::Switch>(&statement.node)) return SwitchReturns(*choice);
  return false;
}

bool HasReturn(const ast::Statement& statement) {
  if (std::holds_alternative<ast::Return>(statement.node)) return true;
  if (const auto* block = std::get_if<ast::Block>(&statement.node)) return std::ranges::any_of(block->statements, Has);
  if (const auto* branch = std::get_if<ast::If>(&statement.node))
    return Has(branch->then_branch) || Has(branch->else_branch);
  if (const auto* loop = std::get_if<ast::For>(&statement.node)) return Has(loop->body);
  if (const auto* loop = std::get_if<ast::While>(&statement.node)) return Has(loop->body);
  if (const auto* loop = std::get_if<ast::DoWhile>(&statement.node)) return Has(loop->body);
  if (const auto* choice = std::get_if<ast::Switch>(&statement.node)) {
    return std::ranges::any_of(choice->cases,
                               [](const ast::Case& arm) { return std::ranges::any_of(arm.statements, Has); });
  }
  return false;
}

}  // namespace burin::fx
