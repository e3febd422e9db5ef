// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/expression_height.h"

#include <algorithm>

namespace burin::fx {

namespace {

struct Highest {
  int height = 0;

  void Add(const ast::ExpressionPtr& operand) {
    if (operand) height = std::max(height, operand->height);
  }
  void Add(const std::vector<ast::ExpressionPtr>& operands) {
    for (const ast::ExpressionPtr& operand : operands) Add(operand);
  }

  void operator()(const ast::Unary& node) { Add(node.operand); }
  void operator()(const ast::Binary& node) { Add(node.left), Add(node.right); }
  void operator()(const ast::Assign& node) { Add(node.target), Add(node.value); }
  void operator()(const ast::Conditional& node) { Add(node.condition), Add(node.if_true), Add(node.if_false); }
  void operator()(const ast::Call& node) { Add(node.object), Add(node.arguments); }
  void operator()(const ast::Construct& node) { Add(node.arguments); }
  void operator()(const ast::Cast& node) { Add(node.operand); }
  void operator()(const ast::Member& node) { Add(node.operand); }
  void operator()(const ast::Index& node) { Add(node.operand), Add(node.index); }
  void operator()(const ast::InitializerList& node) { Add(node.elements); }
  void operator()(const ast::Compile& node) { Add(node.arguments); }
  void operator()(const ast::BoolLiteral&) {}
  void operator()(const ast::IntLiteral&) {}
  void operator()(const ast::FloatLiteral&) {}
  void operator()(const ast::StringLiteral&) {}
  void operator()(const ast::Name&) {}
  void operator()(const ast::AsmBlock&) {}
  void operator()(const ast::StateBlockExpression&) {}
};

}  // namespace

int HeightOf(const ast::Expression& expression) {
  Highest highest;
  std::visit([&](const auto& node) { highest(node); }, expression.node);
  return highest.height + 1;
}

}  // namespace burin::fx
