// SPDX-License-Identifier: Apache-2.0
// State assignments of passes, sampler_state and stateblock_state: Name[index] = value; and Direct3D 10's Set...(...);

#include <algorithm>
#include <utility>

#include "fx_parser/syntax/parser.h"

namespace burin::fx {

// Up to the closing brace, which stays. A faulty state costs only itself.
void Parser::ParseStates(std::vector<ast::StateAssignment>& states, const std::string& what) {
  while (!Is(TokenKind::kRightBrace) && !Is(TokenKind::kEnd) && !stopped()) {
    const std::size_t first = position_;
    if (Accept(TokenKind::kSemicolon)) continue;
    if (AtTechnique()) return;   // the braces before it are missing
    const bool is_pass = IsEffectWord("pass") && !Is(TokenKind::kAssign, 1) && Peek().starts_line;
    if (is_pass) return;
    ast::StateAssignment state;
    if (ParseState(state, what)) {
      states.push_back(std::move(state));
    } else {
      SkipStatement(first);
    }
    if (position_ == first) Advance();
  }
}

bool Parser::ParseState(ast::StateAssignment& state, const std::string& what) {
  const std::size_t first = position_;
  if (!ExpectName("a " + what + " or '}'", state.name, state.name_range)) return false;
  if (Is(TokenKind::kLeftParen)) {
    state.is_call = true;
    if (!ParseArguments(state.arguments)) return false;
  } else {
    if (Is(TokenKind::kLeftBracket)) {
      const Range opening = Advance().range();
      state.index = ParseExpression();
      if (!state.index || !ExpectClosing(TokenKind::kRightBracket, "']' after the index of " + what, opening)) {
        return false;
      }
    }
    if (!Expect(TokenKind::kAssign, "'=' after " + what + " '" + state.name + "'") || !ParseStateValue(state)) {
      return false;
    }
  }
  state.range = RangeFrom(first);
  return ExpectSemicolon(what);
}

bool Parser::ParseStateValue(ast::StateAssignment& state) {
  if (Is(TokenKind::kLess)) {
    state.form = ast::StateAssignment::Form::kAngled;
    const Range opening = Advance().range();
    const Setting angle(stop_at_greater_, true);
    state.value = ParseAssignment();
    return state.value && ExpectClosing(TokenKind::kGreater, "'>' after the value", opening);
  }
  if (Is(TokenKind::kLeftParen) && !StartsCast()) {
    const std::size_t after = std::min(FindClosing(position_) + 1, tokens_.size() - 1);
    const TokenKind next = tokens_[after].kind;
    if (next == TokenKind::kSemicolon || next == TokenKind::kRightBrace) {
      state.form = ast::StateAssignment::Form::kParenthesised;
    }
  }
  const Setting angle(stop_at_greater_, false);
  state.value = ParseAssignment();
  return state.value != nullptr;
}

// The braces and what is between them.
ast::ExpressionPtr Parser::ParseStateBlock(const std::string& what) {
  const std::size_t first = position_;
  const Range opening = Peek().range();
  if (!Expect(TokenKind::kLeftBrace, "'{'")) return nullptr;
  auto block = std::make_unique<ast::StateBlock>();
  ParseStates(block->states, what);
  if (!ExpectClosing(TokenKind::kRightBrace, "'}' to end the " + what + "s", opening)) return nullptr;
  block->range = RangeFrom(first);
  return Make(first, ast::StateBlockExpression{std::move(block)});
}

}  // namespace burin::fx
