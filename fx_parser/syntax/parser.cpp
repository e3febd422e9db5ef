// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/parser.h"

#include <algorithm>
#include <utility>

#include "fx_parser/syntax/parse.h"

namespace burin::fx {

Parser::Parser(TokenStream& stream, Diagnostics& diagnostics)
    : stream_(stream), tokens_(stream.tokens), diagnostics_(diagnostics) {
  names_.Push();
}

const Token& Parser::Peek(std::size_t ahead) const {
  return tokens_[std::min(position_ + ahead, tokens_.size() - 1)];
}

bool Parser::IsEffectWord(std::string_view word, std::size_t ahead) const {
  const Token& token = Peek(ahead);
  return token.kind == TokenKind::kIdentifier && EqualsIgnoringCase(token.text, word);
}

const Token& Parser::Advance() {
  const Token& token = Peek();
  if (position_ + 1 < tokens_.size()) ++position_;
  return token;
}

bool Parser::Accept(TokenKind kind) {
  if (!Is(kind)) return false;
  Advance();
  return true;
}

bool Parser::AcceptWord(std::string_view word) {
  if (!IsWord(word)) return false;
  Advance();
  return true;
}

bool Parser::Expect(TokenKind kind, const std::string& what) {
  if (Accept(kind)) return true;
  ReportUnexpected(what);
  return false;
}

bool Parser::ExpectClosing(TokenKind kind, const std::string& what, const Range& opening) {
  if (Accept(kind)) return true;
  const std::string text = "expected " + what + ", found " + Describe(Peek());
  Report(Peek().range(), text).notes.push_back({opening, "to match this"});
  return false;
}

bool Parser::ExpectSemicolon(const std::string& what) {
  if (Accept(TokenKind::kSemicolon)) return true;
  const Token& previous = Previous();
  Location place = previous.begin;
  place.line = previous.end_line;
  place.column = previous.end_column;
  Report({place, place.line, place.column + 1}, "expected ';' after " + what);
  return Peek().starts_line || Is(TokenKind::kRightBrace) || Is(TokenKind::kEnd);
}

bool Parser::ExpectName(const std::string& what, std::string& name, Range& range) {
  if (!Is(TokenKind::kIdentifier)) {
    ReportUnexpected(what);
    return false;
  }
  range = Peek().range();
  name = Advance().text;
  return true;
}

void Parser::ReportUnexpected(const std::string& expected) {
  const Token& token = Peek();
  switch (token.kind) {
    case TokenKind::kUnterminatedString:
      Report(token.range(), "the string has no closing quote on its line", "B1102");
      return;
    case TokenKind::kBadNumber:
      Report(token.range(), "malformed number " + Describe(token), "B1103");
      return;
    case TokenKind::kUnknown:
      Report(token.range(), "character " + Describe(token) + " has no meaning here", "B1104");
      return;
    default:
      Report(token.range(), "expected " + expected + ", found " + Describe(token));
      return;
  }
}

// One fault often makes several callers fail at one place: the first knows best.
Diagnostic& Parser::Report(const Range& range, std::string text, std::string code) {
  if (last_report_ == position_) {
    ignored_ = {};
    return ignored_;
  }
  last_report_ = position_;
  return diagnostics_.Error(range, std::move(code), std::move(text));
}

bool Parser::ReportTooDeep() {
  Report(Peek().range(), "the text is nested more than " + std::to_string(kMaxNesting) + " levels deep", "B1201");
  return false;
}

Range Parser::RangeFrom(std::size_t first) const {
  const Range begin = tokens_[std::min(first, tokens_.size() - 1)].range();
  return position_ > first ? Join(begin, Previous().range()) : begin;
}

std::string Parser::TextOf(std::size_t first, std::size_t last) const {
  std::string text;
  for (std::size_t i = first; i < last; ++i) {
    if (i > first && tokens_[i].starts_line) {
      text += '\n';
    } else if (i > first && tokens_[i].space_before) {
      text += ' ';
    }
    text += tokens_[i].text;
  }
  return text;
}

std::size_t Parser::FindClosing(std::size_t open) const {
  int depth = 0;
  for (std::size_t i = open; i < tokens_.size(); ++i) {
    switch (tokens_[i].kind) {
      case TokenKind::kLeftParen:
      case TokenKind::kLeftBrace:
      case TokenKind::kLeftBracket: ++depth; break;
      case TokenKind::kRightParen:
      case TokenKind::kRightBrace:
      case TokenKind::kRightBracket:
        if (--depth == 0) return i;
        break;
      default: break;
    }
  }
  return tokens_.size() - 1;
}

}  // namespace burin::fx
