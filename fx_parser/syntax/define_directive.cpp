// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "fx_parser/syntax/preprocessor.h"

namespace burin::fx {

void Preprocessor::Define(const Token& directive) {
  Token name;
  if (!ExpectMacroName(directive, name)) return;
  auto macro = std::make_shared<Macro>();
  if (!ParseMacro(name, RestOfLineTokens(), *macro)) return;
  const std::shared_ptr<Macro> previous = context_.macros.Find(name.text);
  if (previous && !previous->SameAs(*macro)) {
    Diagnostic& warning =
        diagnostics_.Warning(name.range(), "X1519", "macro '" + macro->name + "' is defined again, differently");
    if (previous->definition.begin.file != kNoFile) {
      warning.notes.push_back({previous->definition, "it was defined here"});
    }
  }
  context_.macros.Define(std::move(macro));
}

void Preprocessor::DefineFromOption(const std::string& name, const std::string& value) {
  const std::string_view text = context_.Keep(name + " " + value, {});
  Diagnostics ignored;
  Lexer lexer(text, kNoFile, ignored);
  const Token first = lexer.Next();
  std::vector<Token> rest;
  for (Token token = lexer.Next(); token.kind != TokenKind::kEnd; token = lexer.Next()) rest.push_back(token);
  auto macro = std::make_shared<Macro>();
  const std::size_t open = name.find('(');
  const bool is_name = first.kind == TokenKind::kIdentifier && first.text == name.substr(0, open);
  if (!is_name || !ParseMacro(first, std::move(rest), *macro)) {
    if (!is_name) diagnostics_.Error({}, "B1010", "'" + name + "' is not a name that can be defined");
    return;
  }
  macro->definition = {};
  for (Token& token : macro->body) token.begin = {};
  context_.macros.Define(std::move(macro));
}

bool Preprocessor::ParseMacro(const Token& name, std::vector<Token> tokens, Macro& macro) {
  macro.name = name.text;
  macro.definition = name.range();
  std::size_t position = 0;
  if (!tokens.empty() && tokens[0].kind == TokenKind::kLeftParen && !tokens[0].space_before) {
    macro.is_function = true;
    position = 1;
    if (!ParseParameters(tokens, position, macro)) return false;
  }
  macro.body.assign(tokens.begin() + static_cast<std::ptrdiff_t>(position), tokens.end());
  return CheckBody(macro);
}

bool Preprocessor::ParseParameters(const std::vector<Token>& tokens, std::size_t& position, Macro& macro) {
  const auto kind = [&] { return position < tokens.size() ? tokens[position].kind : TokenKind::kEnd; };
  const auto fail = [&](const std::string& expected) {
    const Range& range = position < tokens.size() ? tokens[position].range() : macro.definition;
    diagnostics_.Error(range, "B1010", "expected " + expected + " in the parameters of macro '" + macro.name + "'");
    return false;
  };
  if (kind() == TokenKind::kRightParen) return ++position, true;
  for (;;) {
    if (kind() == TokenKind::kEllipsis) {
      macro.is_variadic = true;
      macro.parameters.emplace_back("__VA_ARGS__");
      ++position;
      if (kind() != TokenKind::kRightParen) return fail("')' after '...'");
      return ++position, true;
    }
    if (kind() != TokenKind::kIdentifier) return fail("a name");
    const std::string parameter(tokens[position].text);
    if (std::ranges::find(macro.parameters, parameter) != macro.parameters.end()) {
      diagnostics_.Error(tokens[position].range(), "B1010",
                         "macro '" + macro.name + "' has two parameters named '" + parameter + "'");
      return false;
    }
    macro.parameters.push_back(parameter);
    ++position;
    if (kind() == TokenKind::kRightParen) return ++position, true;
    if (kind() != TokenKind::kComma) return fail("',' or ')'");
    ++position;
  }
}

bool Preprocessor::CheckBody(const Macro& macro) {
  const std::vector<Token>& body = macro.body;
  if (body.empty()) return true;
  for (const Token& token : {body.front(), body.back()}) {
    if (token.kind != TokenKind::kHashHash) continue;
    diagnostics_.Error(token.range(), "B1010", "'##' needs an operand on each side");
    return false;
  }
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (i > 0 && body[i].kind == TokenKind::kHashHash && body[i - 1].kind == TokenKind::kHashHash) {
      diagnostics_.Error(body[i].range(), "B1010", "'##' needs an operand on each side");
      return false;
    }
    const bool stringifies = macro.is_function && body[i].kind == TokenKind::kHash;
    if (stringifies && (i + 1 == body.size() || !macro.ParameterIndex(body[i + 1]))) {
      diagnostics_.Error(body[i].range(), "B1010", "'#' must stand before a parameter of macro '" + macro.name + "'");
      return false;
    }
  }
  return true;
}

}  // namespace burin::fx
