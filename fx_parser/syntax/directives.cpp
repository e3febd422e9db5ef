// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "fx_parser/syntax/literal.h"
#include "fx_parser/syntax/preprocessor.h"

namespace burin::fx {

namespace {

constexpr std::string_view kDirectiveNames[] = {"if",    "ifdef", "ifndef",  "elif",  "else",    "endif", "define",
                                                "undef", "error", "include", "line",  "warning", "pragma"};

bool IsConditional(std::string_view name) {
  return name.starts_with("if") || name == "elif" || name == "else" || name == "endif";
}

}  // namespace

Preprocessor::Directive Preprocessor::FindDirective(std::string_view name) {
  constexpr std::pair<std::string_view, Directive> kDirectives[] = {
      {"if", &Preprocessor::If},         {"ifdef", &Preprocessor::Ifdef},     {"ifndef", &Preprocessor::Ifndef},
      {"elif", &Preprocessor::Elif},     {"else", &Preprocessor::Else},       {"endif", &Preprocessor::Endif},
      {"define", &Preprocessor::Define}, {"undef", &Preprocessor::Undef},     {"include", &Preprocessor::Include},
      {"error", &Preprocessor::Error},   {"warning", &Preprocessor::Warning}, {"line", &Preprocessor::Line},
      {"pragma", &Preprocessor::Pragma},
  };
  for (const auto& [directive_name, directive] : kDirectives) {
    if (directive_name == name) return directive;
  }
  return nullptr;
}

void Preprocessor::RunDirective() {
  const std::size_t depth = inputs_.size();
  lexer().Next();   // the '#'
  if (AtLineEnd()) return;
  const Token name = lexer().Next();
  const Directive directive = name.kind == TokenKind::kIdentifier ? FindDirective(name.text) : nullptr;
  if (directive && (live() || IsConditional(name.text))) {
    (this->*directive)(name);
  } else if (live() && name.kind == TokenKind::kIdentifier) {
    std::string text = "unknown directive '#" + std::string(name.text) + "'";
    const std::string near =
        NearestName(std::string(name.text), {std::begin(kDirectiveNames), std::end(kDirectiveNames)});
    if (!near.empty()) text += "; did you mean '#" + near + "'?";
    diagnostics_.Error(name.range(), "B1004", text);
  } else if (live() && name.kind != TokenKind::kInteger) {   // `# 12 "file"`: a preprocessor's line marker
    diagnostics_.Error(name.range(), "B1004", "expected a directive after '#', found " + Describe(name));
  }
  if (inputs_.size() == depth) RestOfLineTokens();   // an #include has finished its line itself
}

std::vector<Token> Preprocessor::RestOfLineTokens() {
  std::vector<Token> tokens;
  while (!AtLineEnd() && tokens.size() < kMaxTokens) tokens.push_back(lexer().Next());
  return tokens;
}

bool Preprocessor::ExpectMacroName(const Token& directive, Token& name) {
  if (!AtLineEnd()) {
    name = lexer().Next();
    if (name.kind == TokenKind::kIdentifier && name.text != "defined") return true;
    diagnostics_.Error(name.range(), "B1004", "expected a macro name after #" + std::string(directive.text) +
                                                  ", found " + Describe(name));
    return false;
  }
  diagnostics_.Error(directive.range(), "B1004", "expected a macro name after #" + std::string(directive.text));
  return false;
}

void Preprocessor::Undef(const Token& directive) {
  Token name;
  if (ExpectMacroName(directive, name)) context_.macros.Undefine(name.text);
}

void Preprocessor::Error(const Token& directive) {
  Location begin;
  const std::string_view text = lexer().RestOfLine(&begin);
  diagnostics_.Error(directive.range(), "B1005", "#error" + (text.empty() ? "" : ": " + std::string(text)));
  incomplete_ = true;
}

void Preprocessor::Warning(const Token& directive) {
  Location begin;
  const std::string_view text = lexer().RestOfLine(&begin);
  diagnostics_.Warning(directive.range(), "B1006", "#warning" + (text.empty() ? "" : ": " + std::string(text)));
}

void Preprocessor::Line(const Token& directive) {
  const std::vector<Token> tokens = MacroExpander::ExpandAll(context_, RestOfLineTokens());
  const bool has_number = !tokens.empty() && tokens[0].kind == TokenKind::kInteger;
  const auto number = has_number ? ParseInteger(tokens[0].text) : std::nullopt;
  const bool has_path = tokens.size() > 1;
  if (!number || number->value > std::numeric_limits<std::int32_t>::max() ||
      (has_path && tokens[1].kind != TokenKind::kString)) {
    diagnostics_.Error(directive.range(), "B1004", "expected a line number and perhaps a file name after #line");
    return;
  }
  std::string path;
  if (has_path) path = ParseString(tokens[1].text);
  std::vector<LineDirective>& all = sources_.files[inputs_.back().file].line_directives;
  if (!has_path && !all.empty()) path = all.back().path;
  all.push_back({directive.begin.line, static_cast<std::uint32_t>(number->value), path});
}

// once and pack_matrix do something; warning, def and ReShade's own are known and ignored.
void Preprocessor::Pragma(const Token& directive) {
  const std::vector<Token> tokens = RestOfLineTokens();
  if (tokens.empty()) return;
  if (tokens[0].Is("once")) {
    once_.insert(inputs_.back().key);
  } else if (tokens[0].Is("pack_matrix") || tokens[0].Is("packmatrix")) {
    const bool whole = tokens.size() >= 4 && tokens[1].kind == TokenKind::kLeftParen &&
                       (tokens[2].Is("row_major") || tokens[2].Is("column_major"));
    if (!whole) {
      diagnostics_.Error(directive.range(), "B1004", "expected #pragma pack_matrix(row_major) or (column_major)");
      return;
    }
    stream_.pack_matrix.push_back({stream_.tokens.size(), tokens[2].Is("row_major")});
  } else if (!tokens[0].Is("warning") && !tokens[0].Is("def") && !tokens[0].Is("reshade")) {
    diagnostics_.Warning(tokens[0].range(), "X3568", Describe(tokens[0]) + ": unknown pragma ignored");
  }
}

}  // namespace burin::fx
