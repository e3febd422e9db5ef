// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "fx_parser/syntax/parser.h"

namespace burin::fx {

namespace {

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string Named(const std::string& kind, const std::string& name) {
  return name.empty() ? "the " + kind : kind + " '" + name + "'";
}

}  // namespace

std::unique_ptr<ast::Technique> Parser::ParseTechnique() {
  auto technique = std::make_unique<ast::Technique>();
  technique->range = Peek().range();
  technique->keyword = Lower(Advance().text);
  if (Is(TokenKind::kIdentifier)) {
    technique->range = Peek().range();
    technique->name = Advance().text;
  }
  if (Is(TokenKind::kLess) && !ParseAnnotations(technique->annotations)) return nullptr;
  const Range opening = Peek().range();
  if (!Expect(TokenKind::kLeftBrace, "'{' to begin " + Named("technique", technique->name))) return nullptr;
  while (!Is(TokenKind::kRightBrace) && !Is(TokenKind::kEnd) && !stopped()) {
    const std::size_t first = position_;
    if (Accept(TokenKind::kSemicolon)) continue;
    if (AtTechnique()) break;  // a '}' is missing
    if (!IsEffectWord("pass")) {
      const bool is_state = Is(TokenKind::kIdentifier) && Is(TokenKind::kAssign, 1);
      ReportUnexpected("'pass' or '}' in " + Named("technique", technique->name) +
                       (is_state ? " (states stand inside a pass)" : ""));
      SkipStatement(first);
    } else if (!ParsePass(*technique)) {
      SkipStatement(first);
    }
    if (position_ == first) Advance();
  }
  ExpectClosing(TokenKind::kRightBrace, "'}' to end " + Named("technique", technique->name), opening);
  Accept(TokenKind::kSemicolon);
  return technique;
}

bool Parser::ParsePass(ast::Technique& technique) {
  ast::Pass pass;
  pass.range = Advance().range();
  if (Is(TokenKind::kIdentifier)) {
    pass.range = Peek().range();
    pass.name = Advance().text;
  }
  if (Is(TokenKind::kLess) && !ParseAnnotations(pass.annotations)) return false;
  const Range opening = Peek().range();
  if (!Expect(TokenKind::kLeftBrace, "'{' to begin " + Named("pass", pass.name))) return false;
  ParseStates(pass.states, "render state");
  const std::string what = "'}' to end " + Named("pass", pass.name);
  technique.passes.push_back(std::move(pass));
  ExpectClosing(TokenKind::kRightBrace, what, opening);  // where it is missing, the next pass or technique follows
  return true;
}

}  // namespace burin::fx
