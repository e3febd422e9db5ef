// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "fx_parser/syntax/parse.h"
#include "fx_parser/syntax/parser.h"

namespace burin::fx {

// Never null: a faulty statement is skipped and stands as an empty one.
ast::StatementPtr Parser::ParseStatement() {
  const std::size_t first = position_;
  ast::StatementPtr statement;
  if (statement_depth_ >= kMaxNesting) {
    ReportTooDeep();
  } else {
    const Nesting nesting(statement_depth_);
    statement = ParseStatementKind();
  }
  if (statement) return statement;
  if (!abandon_function_) SkipStatement(first);
  return MakeStatement(first, ast::ExpressionStatement{});
}

ast::StatementPtr Parser::ParseStatementKind() {
  const std::size_t first = position_;
  if (Is(TokenKind::kLeftBrace)) return ParseBlock();
  if (Accept(TokenKind::kSemicolon)) return MakeStatement(first, ast::ExpressionStatement{});
  std::vector<std::string> attributes;
  while (Is(TokenKind::kLeftBracket)) {
    if (!ParseAttributes(attributes)) return nullptr;
  }
  if (Is(TokenKind::kLeftBrace)) return ParseBlock();  // [isolate] { ... }
  if (IsEffectWord("asm") && Is(TokenKind::kLeftBrace, 1)) return ParseAsmStatement();
  if (IsWord("if")) return ParseIf(std::move(attributes));
  if (IsWord("for")) return ParseFor(std::move(attributes));
  if (IsWord("while")) return ParseWhile(std::move(attributes));
  if (IsWord("do")) return ParseDo(std::move(attributes));
  if (IsWord("switch")) return ParseSwitch(std::move(attributes));
  if (IsWord("else")) return Report(Peek().range(), "'else' without 'if'"), nullptr;
  if (IsWord("case") || (IsWord("default") && Is(TokenKind::kColon, 1))) {
    return Report(Peek().range(), "'" + std::string(Peek().text) + "' stands inside a switch"), nullptr;
  }
  if (IsWord("return") || IsWord("break") || IsWord("continue") || IsWord("discard")) return ParseJump();
  if (AtTechnique() && CheckMissingBrace(position_)) return nullptr;
  if (StartsDeclaration()) return ParseDeclarationStatement();
  return ParseExpressionStatement();
}

ast::StatementPtr Parser::ParseBlock() {
  const std::size_t first = position_;
  const Range opening = Peek().range();
  if (!Expect(TokenKind::kLeftBrace, "'{'")) return nullptr;
  ast::Block block;
  names_.Push();
  ParseBlockContents(block.statements);
  names_.Pop();
  if (!abandon_function_ && !ExpectClosing(TokenKind::kRightBrace, "'}'", opening)) return nullptr;
  return MakeStatement(first, std::move(block));
}

void Parser::ParseBlockContents(std::vector<ast::StatementPtr>& statements) {
  while (!Is(TokenKind::kRightBrace) && !Is(TokenKind::kEnd) && !stopped() && !abandon_function_) {
    const std::size_t first = position_;
    statements.push_back(ParseStatement());
    if (position_ == first && !abandon_function_) Advance();
  }
}

ast::StatementPtr Parser::ParseDeclarationStatement() {
  const std::size_t first = position_;
  ast::DeclarationStatement declaration;
  if (IsWord("typedef")) {
    if (!ParseTypedef(declaration.typedefs, declaration.structure)) return nullptr;
    return MakeStatement(first, std::move(declaration));
  }
  Specifiers specifiers;
  if (!ParseSpecifiers(specifiers)) return nullptr;
  if (Is(TokenKind::kIdentifier) && Is(TokenKind::kLeftParen, 1)) {
    if (CheckMissingBrace(first)) return nullptr;
    Report(Peek().range(), "a function cannot be declared inside a function");
    return nullptr;
  }
  declaration.structure = std::move(specifiers.structure);
  if (declaration.structure && (!Is(TokenKind::kIdentifier) || AtDeclarationKeyword())) {
    if (!ExpectSemicolon("struct")) return nullptr;
    return MakeStatement(first, std::move(declaration));
  }
  if (!ParseVariables(specifiers, false, declaration.variables)) return nullptr;
  return MakeStatement(first, std::move(declaration));
}

ast::StatementPtr Parser::ParseExpressionStatement() {
  const std::size_t first = position_;
  ast::ExpressionPtr expression = ParseExpression();
  if (!expression || !ExpectSemicolon("expression")) return nullptr;
  return MakeStatement(first, ast::ExpressionStatement{std::move(expression)});
}

ast::StatementPtr Parser::ParseAsmStatement() {
  const std::size_t first = position_;
  ast::ExpressionPtr block = ParseAsm();
  if (!block) return nullptr;
  Accept(TokenKind::kSemicolon);
  return MakeStatement(first, ast::ExpressionStatement{std::move(block)});
}

// A technique or a function's definition inside a function: the '}' before it is missing. The parser goes on at
// `declaration`, at file scope.
bool Parser::CheckMissingBrace(std::size_t declaration) {
  if (!function_brace_) return false;
  if (Is(TokenKind::kLeftParen, 1)) {
    const std::size_t close = FindClosing(position_ + 1);
    const TokenKind after = tokens_[std::min(close + 1, tokens_.size() - 1)].kind;
    if (after != TokenKind::kLeftBrace && after != TokenKind::kColon) return false;
  }
  const Range opening = function_brace_->range();
  const std::string name = function_name_;
  Report(tokens_[declaration].range(), "expected '}' to end function '" + name + "' before this declaration")
      .notes.push_back({opening, "to match this"});
  position_ = declaration;
  abandon_function_ = true;
  return true;
}

}  // namespace burin::fx
