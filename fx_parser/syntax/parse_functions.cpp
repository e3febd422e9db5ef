// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "fx_parser/syntax/parser.h"

namespace burin::fx {

std::unique_ptr<ast::Function> Parser::ParseFunction(Specifiers& specifiers) {
  auto function = std::make_unique<ast::Function>();
  function->qualifiers = specifiers.qualifiers;
  function->return_type_name = std::move(specifiers.type);
  function->range = Peek().range();
  function->name = space_ + std::string(Advance().text);
  names_.Declare(function->name, false);
  names_.Push();
  const bool has_head = ParseParameters(*function) &&
                        ParseSemantics(function->semantic, function->semantic_range, nullptr) &&
                        (!Is(TokenKind::kLess) || ParseAnnotations(function->annotations));
  bool parsed = has_head;
  if (has_head && Is(TokenKind::kLeftBrace)) {
    function_brace_ = &Peek();
    function_name_ = function->name;
    function->body = ParseBlock();
    parsed = function->body != nullptr;
    function_brace_ = nullptr;
  } else if (has_head && !Accept(TokenKind::kSemicolon)) {
    ReportUnexpected("'{' or ';' after the parameters of '" + function->name + "'");
    parsed = false;
  }
  names_.Pop();
  if (!parsed) return nullptr;
  return function;
}

bool Parser::ParseParameters(ast::Function& function) {
  const Range opening = Advance().range();
  if (IsWord("void") && Is(TokenKind::kRightParen, 1)) Advance();
  if (Accept(TokenKind::kRightParen)) return true;
  do {
    if (!ParseParameter(function)) return false;
  } while (Accept(TokenKind::kComma));
  return ExpectClosing(TokenKind::kRightParen, "',' or ')' in the parameters of '" + function.name + "'", opening);
}

bool Parser::ParseParameter(ast::Function& function) {
  Specifiers specifiers;
  if (!Is(TokenKind::kIdentifier)) {
    ReportUnexpected("a parameter of '" + function.name + "'");
    return false;
  }
  if (!ParseSpecifiers(specifiers)) return false;
  auto parameter = std::make_unique<ast::Variable>();
  parameter->qualifiers = specifiers.qualifiers;
  parameter->range = specifiers.type.range;
  parameter->type_name = std::move(specifiers.type);
  parameter->is_parameter = true;
  if (specifiers.structure) {
    Report(specifiers.structure->range, "a struct cannot be defined in a parameter");
    return false;
  }
  if (Is(TokenKind::kIdentifier)) {  // a prototype's, or one that is not used, may have no name
    parameter->range = Peek().range();
    parameter->name = Advance().text;
    names_.Declare(parameter->name, false);
  }
  if (!ParseArraySizes(parameter->array_sizes)) return false;
  if (!ParseSemantics(parameter->semantic, parameter->semantic_range, &parameter->registers)) return false;
  if (Is(TokenKind::kLess) && !ParseAnnotations(parameter->annotations)) return false;
  if (Accept(TokenKind::kAssign)) {
    parameter->initializer = ParseAssignment();
    if (!parameter->initializer) return false;
    if (!ParseSemantics(parameter->semantic, parameter->semantic_range, &parameter->registers)) return false;
  }
  function.parameters.push_back(std::move(parameter));
  return true;
}

}  // namespace burin::fx
