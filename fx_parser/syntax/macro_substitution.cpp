// SPDX-License-Identifier: Apache-2.0
// A macro's body with its arguments put in: the # and ## operators (C99 6.10.3.1 to 6.10.3.3). Unlike C, a ## whose
// result is not one token gives the several tokens that it spells, as under FXC.

#include <utility>

#include "fx_parser/syntax/lexer.h"
#include "fx_parser/syntax/macro_expander.h"

namespace burin::fx {

namespace {

// Tokens of the body stand, for messages, where the outermost invocation stands.
Token PlaceBodyToken(MacroContext& context, const Macro& macro, const Token& name, const Token& body_token) {
  Token token = body_token;
  token.begin = name.begin;
  token.begin.macro = context.AddExpansion(macro, body_token.begin, name.begin.macro);
  token.end_line = name.end_line;
  token.end_column = name.end_column;
  return token;
}

// Tokens of an argument keep the place where they are written.
void PlaceArgumentTokens(MacroContext& context, const Macro& macro, const Token& spot, std::vector<Token>& tokens) {
  for (Token& token : tokens) token.begin.macro = context.AddExpansion(macro, spot.begin, token.begin.macro);
  if (tokens.empty()) return;
  tokens.front().space_before = spot.space_before;
  tokens.front().starts_line = false;
}

}  // namespace

std::vector<Token> MacroExpander::Substitute(const Token& name, const Macro& macro, std::vector<Argument>& arguments) {
  std::vector<Token> result;
  bool pasting = false;
  std::size_t left_begin = 0;   // of the left operand of a ## that may follow
  for (std::size_t i = 0; i < macro.body.size() && !context_.stopped(); ++i) {
    const Token& spot = macro.body[i];
    if (spot.kind == TokenKind::kHashHash) {
      pasting = true;
      continue;
    }
    std::vector<Token> piece;
    bool is_rest = false;
    if (macro.is_function && spot.kind == TokenKind::kHash) {
      const std::size_t index = *macro.ParameterIndex(macro.body[++i]);
      piece.push_back(Stringify(name, macro, spot, arguments[index]));
    } else if (const std::optional<std::size_t> index = macro.ParameterIndex(spot)) {
      const bool pasted_to = i + 1 < macro.body.size() && macro.body[i + 1].kind == TokenKind::kHashHash;
      Argument& argument = arguments[*index];
      is_rest = macro.is_variadic && *index + 1 == macro.parameters.size();
      if (!pasting && !pasted_to && !argument.is_expanded) {
        argument.expanded =
            ExpandAll(context_, argument.raw, depth_ + static_cast<int>(frames_.size()) + 1);
        argument.is_expanded = true;
      }
      piece = pasting || pasted_to ? argument.raw : argument.expanded;
      if (!context_.Count(piece.size(), name)) return {};
      PlaceArgumentTokens(context_, macro, spot, piece);
    } else {
      piece.push_back(PlaceBodyToken(context_, macro, name, spot));
    }
    if (!context_.Count(1, name)) return {};

    const bool left_is_empty = result.size() == left_begin;
    const bool after_comma = pasting && is_rest && !left_is_empty && result.back().kind == TokenKind::kComma;
    if (after_comma && piece.empty()) result.pop_back();   // GNU's `, ## __VA_ARGS__`
    if (!pasting) left_begin = result.size();
    if (pasting && !left_is_empty && !piece.empty() && !after_comma) {
      Paste(result, std::move(piece), name);
    } else {
      result.insert(result.end(), piece.begin(), piece.end());
    }
    pasting = false;
  }
  return result;
}

Token MacroExpander::Stringify(const Token& name, const Macro& macro, const Token& spot, const Argument& argument) {
  std::string text = "\"";
  for (std::size_t i = 0; i < argument.raw.size(); ++i) {
    const Token& token = argument.raw[i];
    if (i > 0 && (token.space_before || token.starts_line)) text += ' ';
    for (const char c : token.text) {
      const bool in_string = token.kind == TokenKind::kString || token.kind == TokenKind::kUnterminatedString;
      if (in_string && (c == '"' || c == '\\')) text += '\\';
      text += c;
    }
  }
  Token token = PlaceBodyToken(context_, macro, name, spot);
  token.kind = TokenKind::kString;
  token.text = context_.Keep(text + "\"", name);
  return token;
}

void MacroExpander::Paste(std::vector<Token>& result, std::vector<Token> piece, const Token& name) {
  const Token left = result.back();
  result.pop_back();
  const std::string_view text = context_.Keep(std::string(left.text) + std::string(piece.front().text), name);
  Diagnostics ignored;   // the text has no place of its own
  Lexer lexer(text, kNoFile, ignored);
  bool first = true;
  for (Token token = lexer.Next(); token.kind != TokenKind::kEnd; token = lexer.Next()) {
    token.begin = left.begin;
    token.end_line = left.end_line;
    token.end_column = left.end_column;
    token.starts_line = false;
    token.space_before = first && left.space_before;
    first = false;
    result.push_back(token);
  }
  result.insert(result.end(), piece.begin() + 1, piece.end());
}

}  // namespace burin::fx
