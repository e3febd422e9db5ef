// SPDX-License-Identifier: Apache-2.0
// Where the parser goes on after a fault.

#include <algorithm>

#include "fx_parser/syntax/parser.h"

namespace burin::fx {

// Braces opened since `first` and not closed yet.
int Parser::OpenBraces(std::size_t first) const {
  int depth = 0;
  for (std::size_t i = first; i < position_; ++i) {
    if (tokens_[i].kind == TokenKind::kLeftBrace) ++depth;
    if (tokens_[i].kind == TokenKind::kRightBrace && depth > 0) --depth;
  }
  return depth;
}

// From a fault in the statement that begins at `first`: behind the next ';' of its level or behind a '{...}', or before
// the '}' that ends that level.
void Parser::SkipStatement(std::size_t first) {
  int depth = OpenBraces(first);
  while (!Is(TokenKind::kEnd)) {
    switch (Peek().kind) {
      case TokenKind::kSemicolon:
        Advance();
        if (depth == 0) return;
        break;
      case TokenKind::kLeftBrace:
        ++depth;
        Advance();
        break;
      case TokenKind::kRightBrace:
        if (depth == 0) return;
        Advance();
        if (--depth == 0) return;
        break;
      default:
        if (depth == 0 && Peek().starts_line && AtTechnique()) return;
        Advance();
        break;
    }
  }
}

// From a fault in the declaration that begins at `first` to what looks like the next one.
void Parser::SkipDeclaration(std::size_t first) {
  int depth = OpenBraces(first);
  while (!Is(TokenKind::kEnd)) {
    const Token& token = Peek();
    if (position_ > first && token.starts_line && AtDeclarationKeyword()) {
      // A keyword in column 1 ends the search even inside braces: then it is a '}' that is missing.
      if (depth == 0 || token.begin.column == 1) return;
    }
    Advance();
    if (token.kind == TokenKind::kLeftBrace) ++depth;
    if (token.kind == TokenKind::kRightBrace && depth > 0) --depth;
    const bool ends = token.kind == TokenKind::kSemicolon || token.kind == TokenKind::kRightBrace;
    if (ends && depth == 0) {
      if (token.kind == TokenKind::kRightBrace) Accept(TokenKind::kSemicolon);
      return;
    }
  }
}

bool Parser::AtTechnique(std::size_t ahead) const {
  const bool word = IsEffectWord("technique", ahead) || IsEffectWord("technique10", ahead) ||
                    IsEffectWord("technique11", ahead);
  if (!word) return false;
  const TokenKind next = Peek(ahead + 1).kind;
  if (next == TokenKind::kLeftBrace || next == TokenKind::kLess) return true;
  const TokenKind after = Peek(ahead + 2).kind;
  return next == TokenKind::kIdentifier && (after == TokenKind::kLeftBrace || after == TokenKind::kLess);
}

bool Parser::AtDeclarationKeyword() const {
  return AtTechnique() || IsWord("struct") || IsWord("typedef") || IsWord("uniform") || IsWord("static") ||
         IsWord("const") || IsWord("extern") || IsWord("shared") ||
         (StartsType(0) && Is(TokenKind::kIdentifier, 1));
}

}  // namespace burin::fx
