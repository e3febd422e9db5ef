// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "fx_parser/syntax/parser.h"

namespace burin::fx {

// [unroll], [loop], [unroll(8)] ...: kept as text.
bool Parser::ParseAttributes(std::vector<std::string>& attributes) {
  const Range opening = Peek().range();
  const std::size_t close = FindClosing(position_);
  if (!Is(TokenKind::kIdentifier, 1)) {
    Advance();
    ReportUnexpected("an attribute such as 'unroll'");
    return false;
  }
  attributes.push_back(TextOf(position_ + 1, close));
  position_ = close;
  return ExpectClosing(TokenKind::kRightBracket, "']' after the attribute", opening);
}

// After a fault between the parentheses of a header: before the closing one, if it can be told.
bool Parser::SkipHeader(std::size_t open) {
  const std::size_t close = FindClosing(open);
  if (tokens_[close].kind != TokenKind::kRightParen || close < position_) return false;
  for (std::size_t i = open; i < close; ++i) {
    if (tokens_[i].kind == TokenKind::kLeftBrace) return false;
  }
  position_ = close;
  return true;
}

// ( condition )
bool Parser::ParseHeader(const std::string& keyword, ast::ExpressionPtr& condition) {
  const std::size_t open = position_;
  const Range opening = Peek().range();
  if (!Expect(TokenKind::kLeftParen, "'(' after '" + keyword + "'")) return false;
  condition = ParseExpression();
  if (condition && Accept(TokenKind::kRightParen)) return true;
  if (condition) ExpectClosing(TokenKind::kRightParen, "')' after the condition", opening);
  return SkipHeader(open) && Accept(TokenKind::kRightParen);
}

ast::StatementPtr Parser::ParseIf(std::vector<std::string> attributes) {
  const std::size_t first = position_;
  Advance();
  ast::If node;
  node.attributes = std::move(attributes);
  if (!ParseHeader("if", node.condition)) return nullptr;
  node.then_branch = ParseStatement();
  if (!abandon_function_ && AcceptWord("else")) node.else_branch = ParseStatement();
  return MakeStatement(first, std::move(node));
}

ast::StatementPtr Parser::ParseFor(std::vector<std::string> attributes) {
  const std::size_t first = position_;
  Advance();
  ast::For node;
  node.attributes = std::move(attributes);
  const std::size_t open = position_;
  if (!Expect(TokenKind::kLeftParen, "'(' after 'for'")) return nullptr;
  names_.Push();
  const bool has_header = ParseForHeader(node) || (SkipHeader(open) && Accept(TokenKind::kRightParen));
  if (has_header) node.body = ParseStatement();
  names_.Pop();
  if (!has_header) return nullptr;
  return MakeStatement(first, std::move(node));
}

bool Parser::ParseForHeader(ast::For& loop) {
  if (StartsDeclaration()) {
    loop.init = ParseDeclarationStatement();
    if (!loop.init) return false;
  } else {
    const std::size_t first = position_;
    ast::ExpressionPtr init;
    if (!Is(TokenKind::kSemicolon)) {
      init = ParseExpression();
      if (!init) return false;
    }
    loop.init = MakeStatement(first, ast::ExpressionStatement{std::move(init)});
    if (!Expect(TokenKind::kSemicolon, "';' after the start of the loop")) return false;
  }
  if (!Is(TokenKind::kSemicolon)) {
    loop.condition = ParseExpression();
    if (!loop.condition) return false;
  }
  if (!Expect(TokenKind::kSemicolon, "';' after the condition of the loop")) return false;
  if (!Is(TokenKind::kRightParen)) {
    loop.step = ParseExpression();
    if (!loop.step) return false;
  }
  return Expect(TokenKind::kRightParen, "')' after the step of the loop");
}

ast::StatementPtr Parser::ParseWhile(std::vector<std::string> attributes) {
  const std::size_t first = position_;
  Advance();
  ast::While node;
  node.attributes = std::move(attributes);
  if (!ParseHeader("while", node.condition)) return nullptr;
  node.body = ParseStatement();
  return MakeStatement(first, std::move(node));
}

ast::StatementPtr Parser::ParseDo(std::vector<std::string> attributes) {
  const std::size_t first = position_;
  Advance();
  ast::DoWhile node;
  node.attributes = std::move(attributes);
  node.body = ParseStatement();
  if (abandon_function_) return nullptr;
  if (!AcceptWord("while")) return ReportUnexpected("'while' after the body of 'do'"), nullptr;
  if (!ParseHeader("while", node.condition) || !ExpectSemicolon("do-while loop")) return nullptr;
  return MakeStatement(first, std::move(node));
}

ast::StatementPtr Parser::ParseSwitch(std::vector<std::string> attributes) {
  const std::size_t first = position_;
  Advance();
  ast::Switch node;
  node.attributes = std::move(attributes);
  if (!ParseHeader("switch", node.selector)) return nullptr;
  const Range opening = Peek().range();
  if (!Expect(TokenKind::kLeftBrace, "'{' after the selector of 'switch'")) return nullptr;
  names_.Push();
  while (!Is(TokenKind::kRightBrace) && !Is(TokenKind::kEnd) && !stopped() && !abandon_function_) {
    const std::size_t begin = position_;
    if (IsWord("case") || (IsWord("default") && Is(TokenKind::kColon, 1))) {
      ast::Case label;
      if (!ParseCaseLabel(label)) SkipStatement(begin);
      node.cases.push_back(std::move(label));
    } else if (node.cases.empty()) {
      ReportUnexpected("'case' or 'default'");
      SkipStatement(begin);
    } else {
      node.cases.back().statements.push_back(ParseStatement());
    }
    if (position_ == begin && !abandon_function_) Advance();
  }
  names_.Pop();
  if (!abandon_function_ && !ExpectClosing(TokenKind::kRightBrace, "'}' to end the switch", opening)) return nullptr;
  return MakeStatement(first, std::move(node));
}

bool Parser::ParseCaseLabel(ast::Case& label) {
  label.range = Peek().range();
  if (AcceptWord("case")) {
    label.value = ParseConditional();
    if (!label.value) return false;
  } else {
    Advance();   // default
  }
  return Expect(TokenKind::kColon, label.value ? "':' after the value of 'case'" : "':' after 'default'");
}

ast::StatementPtr Parser::ParseJump() {
  const std::size_t first = position_;
  const std::string keyword(Advance().text);
  if (keyword == "return") {
    ast::Return node;
    if (!Is(TokenKind::kSemicolon) && !Is(TokenKind::kRightBrace)) {
      node.value = ParseExpression();
      if (!node.value) return nullptr;
    }
    if (!ExpectSemicolon("return")) return nullptr;
    return MakeStatement(first, std::move(node));
  }
  if (!ExpectSemicolon("'" + keyword + "'")) return nullptr;
  if (keyword == "break") return MakeStatement(first, ast::Break{});
  if (keyword == "continue") return MakeStatement(first, ast::Continue{});
  return MakeStatement(first, ast::Discard{});
}

}  // namespace burin::fx
