// SPDX-License-Identifier: Apache-2.0
#pragma once
// Visits every expression of a tree, and finds what a tree writes.

#include <functional>
#include <set>

#include "fx_parser/syntax/ast.h"

namespace burin::fx {

using ExpressionVisitor = std::function<void(const ast::Expression&)>;

/// Calls `visit` for the expression and everything inside it, outermost first.
void ForEachExpression(const ast::Expression& expression, const ExpressionVisitor& visit);
/// The same for every expression of a statement, initialisers included.
void ForEachExpression(const ast::Statement& statement, const ExpressionVisitor& visit);

/// Adds the variables that `expression` itself assigns to (not those of expressions inside it): targets of assignments
/// and increments, arguments of out parameters.
void AppendWritten(const ast::Expression& expression, std::set<const ast::Variable*>& written);

/// Every variable that any function of the module writes to.
[[nodiscard]] std::set<const ast::Variable*> WrittenVariables(const ast::Module& module);

/// The variable at the bottom of an lvalue; null when there is none, and of constructors, which may have several.
[[nodiscard]] const ast::Variable* RootVariable(const ast::Expression& expression);

}  // namespace burin::fx
