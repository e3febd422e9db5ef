// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/walk.h"

#include "fx_parser/semantics/intrinsics.h"

namespace burin::fx {
namespace {

void WalkExpression(const ast::ExpressionPtr& expression, const ExpressionVisitor& visit) {
  if (expression != nullptr) ForEachExpression(*expression, visit);
}

void WalkStatement(const ast::StatementPtr& statement, const ExpressionVisitor& visit) {
  if (statement != nullptr) ForEachExpression(*statement, visit);
}

struct Children {
  const ExpressionVisitor& visit;
  void operator()(const ast::Unary& n) const { WalkExpression(n.operand, visit); }
  void operator()(const ast::Binary& n) const {
    WalkExpression(n.left, visit);
    WalkExpression(n.right, visit);
  }
  void operator()(const ast::Assign& n) const {
    WalkExpression(n.target, visit);
    WalkExpression(n.value, visit);
  }
  void operator()(const ast::Conditional& n) const {
    WalkExpression(n.condition, visit);
    WalkExpression(n.if_true, visit);
    WalkExpression(n.if_false, visit);
  }
  void operator()(const ast::Call& n) const {
    WalkExpression(n.object, visit);
    for (const auto& argument : n.arguments) WalkExpression(argument, visit);
  }
  void operator()(const ast::Construct& n) const {
    for (const auto& argument : n.arguments) WalkExpression(argument, visit);
  }
  void operator()(const ast::Cast& n) const { WalkExpression(n.operand, visit); }
  void operator()(const ast::Member& n) const { WalkExpression(n.operand, visit); }
  void operator()(const ast::Index& n) const {
    WalkExpression(n.operand, visit);
    WalkExpression(n.index, visit);
  }
  void operator()(const ast::InitializerList& n) const {
    for (const auto& element : n.elements) WalkExpression(element, visit);
  }
  void operator()(const ast::Block& n) const {
    for (const auto& statement : n.statements) WalkStatement(statement, visit);
  }
  void operator()(const ast::DeclarationStatement& n) const {
    for (const auto& variable : n.variables) WalkExpression(variable->initializer, visit);
  }
  void operator()(const ast::ExpressionStatement& n) const { WalkExpression(n.expression, visit); }
  void operator()(const ast::If& n) const {
    WalkExpression(n.condition, visit);
    WalkStatement(n.then_branch, visit);
    WalkStatement(n.else_branch, visit);
  }
  void operator()(const ast::For& n) const {
    WalkStatement(n.init, visit);
    WalkExpression(n.condition, visit);
    WalkExpression(n.step, visit);
    WalkStatement(n.body, visit);
  }
  void operator()(const ast::While& n) const {
    WalkExpression(n.condition, visit);
    WalkStatement(n.body, visit);
  }
  void operator()(const ast::DoWhile& n) const {
    WalkStatement(n.body, visit);
    WalkExpression(n.condition, visit);
  }
  void operator()(const ast::Switch& n) const {
    WalkExpression(n.selector, visit);
    for (const ast::Case& arm : n.cases) {
      WalkExpression(arm.value, visit);
      for (const auto& statement : arm.statements) WalkStatement(statement, visit);
    }
  }
  void operator()(const ast::Return& n) const { WalkExpression(n.value, visit); }
  template <class Leaf>
  void operator()(const Leaf&) const {}
};

}  // namespace

void ForEachExpression(const ast::Expression& expression, const ExpressionVisitor& visit) {
  visit(expression);
  std::visit(Children{visit}, expression.node);
}

void ForEachExpression(const ast::Statement& statement, const ExpressionVisitor& visit) {
  std::visit(Children{visit}, statement.node);
}

const ast::Variable* RootVariable(const ast::Expression& expression) {
  if (const auto* name = std::get_if<ast::Name>(&expression.node)) return name->variable;
  if (const auto* member = std::get_if<ast::Member>(&expression.node)) return RootVariable(*member->operand);
  if (const auto* index = std::get_if<ast::Index>(&expression.node)) return RootVariable(*index->operand);
  return nullptr;
}

void AppendWritten(const ast::Expression& expression, std::set<const ast::Variable*>& written) {
  const std::function<void(const ast::Expression&)> add = [&](const ast::Expression& target) {
    if (const auto* parts = std::get_if<ast::Construct>(&target.node)) {
      for (const auto& part : parts->arguments) add(*part);
    } else if (const ast::Variable* root = RootVariable(target)) {
      written.insert(root);
    }
  };
  if (const auto* assign = std::get_if<ast::Assign>(&expression.node)) add(*assign->target);
  if (const auto* unary = std::get_if<ast::Unary>(&expression.node);
      unary != nullptr && unary->op >= ast::UnaryOperator::kPreIncrement) {
    add(*unary->operand);
  }
  const auto* call = std::get_if<ast::Call>(&expression.node);
  if (call == nullptr) return;
  if (call->function != nullptr) {
    for (std::size_t i = 0; i < call->arguments.size(); ++i) {
      if ((call->function->parameters[i]->qualifiers & ast::kOut) != 0) add(*call->arguments[i]);
    }
  } else if (call->intrinsic >= 0) {
    std::vector<Type> types;
    for (const auto& argument : call->arguments) types.push_back(argument->type);
    const auto resolved = ResolveIntrinsic(Intrinsics()[static_cast<std::size_t>(call->intrinsic)], types);
    for (std::size_t i = 0; resolved && i < call->arguments.size(); ++i) {
      if (resolved->is_out[i]) add(*call->arguments[i]);
    }
  }
}

std::set<const ast::Variable*> WrittenVariables(const ast::Module& module) {
  std::set<const ast::Variable*> written;
  for (const auto& declaration : module.declarations) {
    const auto* function = std::get_if<std::unique_ptr<ast::Function>>(&declaration);
    if (function == nullptr || (*function)->body == nullptr) continue;
    ForEachExpression(*(*function)->body, [&](const ast::Expression& e) { AppendWritten(e, written); });
  }
  return written;
}

}  // namespace burin::fx
