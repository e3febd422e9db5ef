// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/macro_expander.h"

#include <utility>

namespace burin::fx {

namespace {

std::string Quote(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace

MacroExpander::~MacroExpander() {
  while (!frames_.empty()) PopFrame();
}

std::vector<Token> MacroExpander::ExpandAll(MacroContext& context, std::vector<Token> tokens, int depth) {
  TokenListSource source(std::move(tokens));
  MacroExpander expander(context, source, depth);
  std::vector<Token> expanded;
  for (Token token = expander.Next(); token.kind != TokenKind::kEnd; token = expander.Next()) {
    expanded.push_back(token);
  }
  return expanded;
}

Token MacroExpander::Next() {
  while (!context_.stopped()) {
    Token token = Pull(false);
    if (token.kind != TokenKind::kIdentifier || token.no_expand) return token;
    const std::shared_ptr<Macro> macro = context_.macros.Find(token.text);
    if (!macro) return token;
    if (macro->active > 0) {
      token.no_expand = true;
      return token;
    }
    if (macro->builtin != Macro::Builtin::kNone) return ExpandBuiltin(*macro, token);
    if (macro->is_function && PeekKind() != TokenKind::kLeftParen) return token;
    if (!Enter(token, macro)) continue;
  }
  return {};
}

Token MacroExpander::Pull(bool inside_arguments) {
  while (!frames_.empty()) {
    Frame& frame = frames_.back();
    if (frame.next < frame.tokens.size()) return frame.tokens[frame.next++];
    PopFrame();
  }
  return source_.Next(inside_arguments);
}

TokenKind MacroExpander::PeekKind() {
  while (!frames_.empty()) {
    const Frame& frame = frames_.back();
    if (frame.next < frame.tokens.size()) return frame.tokens[frame.next].kind;
    PopFrame();
  }
  return source_.PeekKind();
}

void MacroExpander::PopFrame() {
  --frames_.back().macro->active;
  frames_.pop_back();
}

Token MacroExpander::ExpandBuiltin(const Macro& macro, const Token& name) {
  Token token = name;
  PresumedLine place;
  if (name.begin.file != kNoFile) place = Presume(context_.sources().files[name.begin.file], name.begin.line);
  if (macro.builtin == Macro::Builtin::kLine) {
    token.kind = TokenKind::kInteger;
    token.text = context_.Keep(std::to_string(place.line), name);
  } else {
    token.kind = TokenKind::kString;
    token.text = context_.Keep(Quote(place.path), name);
  }
  return token;
}

bool MacroExpander::Enter(const Token& name, const std::shared_ptr<Macro>& macro) {
  if (depth_ + static_cast<int>(frames_.size()) >= MacroContext::kMaxDepth) {
    context_.Stop(name, "macros expand inside one another more than " + std::to_string(MacroContext::kMaxDepth) +
                            " levels deep");
    return false;
  }
  std::vector<Argument> arguments;
  if (macro->is_function && !CollectArguments(name, *macro, arguments)) return false;
  std::vector<Token> tokens = Substitute(name, *macro, arguments);
  if (context_.stopped()) return false;
  if (!tokens.empty()) {
    tokens.front().starts_line = name.starts_line;
    tokens.front().space_before = name.space_before;
  }
  ++macro->active;
  frames_.push_back({std::move(tokens), 0, macro});
  return true;
}

bool MacroExpander::CollectArguments(const Token& name, const Macro& macro, std::vector<Argument>& arguments) {
  Pull(true);   // the parenthesis
  arguments.emplace_back();
  int nesting = 0;
  for (;;) {
    Token token = Pull(true);
    if (token.kind == TokenKind::kEnd) {
      if (!context_.stopped()) {
        context_.diagnostics().Error(name.range(), "B1011",
                                     "missing ')' to end the arguments of macro '" + macro.name + "'");
      }
      return false;
    }
    if (!context_.Count(1, name)) return false;
    token.space_before |= token.starts_line;   // line breaks among arguments are only space
    token.starts_line = false;
    if (token.kind == TokenKind::kLeftParen) ++nesting;
    if (token.kind == TokenKind::kRightParen && nesting-- == 0) break;
    const bool in_rest = macro.is_variadic && arguments.size() == macro.parameters.size();
    if (token.kind == TokenKind::kComma && nesting == 0 && !in_rest) {
      arguments.emplace_back();
    } else {
      arguments.back().raw.push_back(token);
    }
  }
  return CheckArgumentCount(name, macro, arguments);
}

bool MacroExpander::CheckArgumentCount(const Token& name, const Macro& macro, std::vector<Argument>& arguments) {
  const std::size_t wanted = macro.parameters.size();
  if (wanted == 0 && arguments.size() == 1 && arguments[0].raw.empty()) arguments.clear();
  if (arguments.size() > wanted) {
    context_.diagnostics()
        .Error(name.range(), "B1012", "macro '" + macro.name + "' takes " + std::to_string(wanted) +
                                          (wanted == 1 ? " argument" : " arguments") + " but is given " +
                                          std::to_string(arguments.size()))
        .notes.push_back({macro.definition, "macro '" + macro.name + "' is defined here"});
    return false;
  }
  const std::size_t needed = macro.is_variadic ? wanted - 1 : wanted;
  if (arguments.size() < needed) {
    context_.diagnostics()
        .Warning(name.range(), "X1516", "not enough arguments for macro '" + macro.name + "': " +
                                            std::to_string(needed) + " expected, " +
                                            std::to_string(arguments.size()) + " given")
        .notes.push_back({macro.definition, "macro '" + macro.name + "' is defined here"});
  }
  arguments.resize(wanted);
  return true;
}

}  // namespace burin::fx
