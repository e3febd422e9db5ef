// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "fx_parser/source/include_resolver.h"
#include "fx_parser/source/source_text.h"
#include "fx_parser/syntax/preprocessor.h"

namespace burin::fx {

namespace {

std::string JoinFolders(const std::vector<std::string>& folders) {
  std::string text;
  for (const std::string& folder : folders) text += (text.empty() ? "'" : ", '") + folder + "'";
  return text;
}

}  // namespace

void Preprocessor::Include(const Token& directive) {
  std::string name;
  Range range;
  if (!ReadIncludeName(directive, name, range)) return;
  const ResolvedInclude resolved =
      ResolveInclude(name, sources_.files[inputs_.back().file].path, options_.include_folders, files_);
  if (resolved.path.empty()) {
    const std::string where = resolved.searched.empty() ? "" : "; searched in " + JoinFolders(resolved.searched);
    diagnostics_.Error(range, "X1507", "include file '" + name + "' not found" + where);
    missing_include_ = true;
    return;
  }
  const std::string key = PathKey(resolved.path);
  if (once_.contains(key) || !CheckIncludeLimits(resolved.path, key, directive, range)) return;
  std::expected<std::string, std::string> text = files_.Read(resolved.path);
  if (text) text = NormalizeText(*text);
  if (!text) {
    diagnostics_.Error(range, "X1507", "cannot read include file '" + resolved.path + "': " + text.error());
    missing_include_ = true;
    return;
  }
  if (bytes_ + text->size() > kMaxSourceBytes) {
    context_.Stop(directive, "the effect and its includes have more than 32 MiB of text");
    return;
  }
  RestOfLineTokens();
  Open(resolved.path, *text, directive.begin);
}

bool Preprocessor::ReadIncludeName(const Token& directive, std::string& name, Range& range) {
  const Token next = lexer().Peek();
  const bool is_plain = next.kind == TokenKind::kString || next.kind == TokenKind::kUnterminatedString ||
                        next.kind == TokenKind::kLess;
  if (AtLineEnd() || !is_plain) return ExpandIncludeName(directive, name, range);
  Location begin;
  const std::string_view text = lexer().RestOfLine(&begin);   // raw: in a path, '\' is no escape
  const std::size_t end = text.find(text[0] == '<' ? '>' : '"', 1);
  if (end == std::string_view::npos) {
    diagnostics_.Error(next.range(), "B1004", std::string("expected '") + (text[0] == '<' ? '>' : '"') +
                                                  "' after the file name of #include");
    return false;
  }
  name = text.substr(1, end - 1);
  range = {begin, begin.line, begin.column + static_cast<std::uint32_t>(end) + 1};
  if (!name.empty()) return true;
  diagnostics_.Error(range, "B1004", "#include has an empty file name");
  return false;
}

// A macro that stands for "file" or <file>.
bool Preprocessor::ExpandIncludeName(const Token& directive, std::string& name, Range& range) {
  const std::vector<Token> tokens = MacroExpander::ExpandAll(context_, RestOfLineTokens());
  range = tokens.empty() ? directive.range() : Join(tokens.front().range(), tokens.back().range());
  if (tokens.size() == 1 && tokens[0].kind == TokenKind::kString) {
    name = tokens[0].text.substr(1, tokens[0].text.size() - 2);
  } else if (tokens.size() > 2 && tokens.front().kind == TokenKind::kLess &&
             tokens.back().kind == TokenKind::kGreater) {
    for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
      if (i > 1 && tokens[i].space_before) name += ' ';
      name += tokens[i].text;
    }
  }
  if (!name.empty()) return true;
  if (!context_.stopped()) diagnostics_.Error(range, "B1004", "expected \"file\" or <file> after #include");
  return false;
}

// Including a file inside itself is no fault as long as some macro has changed since (include guards, counted
// recursion); where none has, the same directive would go on forever.
bool Preprocessor::CheckIncludeLimits(const std::string& path, const std::string& key, const Token& directive,
                                      const Range& range) {
  for (std::size_t i = inputs_.size(); i-- > 0;) {
    if (inputs_[i].key != key || inputs_[i].macro_version != context_.macros.version()) continue;
    std::string chain = "'" + path + "'";
    for (std::size_t j = i + 1; j < inputs_.size(); ++j) chain += " -> '" + sources_.files[inputs_[j].file].path + "'";
    diagnostics_.Error(range, "B1002", "include cycle: " + chain + " -> '" + path + "'");
    missing_include_ = true;
    return false;
  }
  if (inputs_.size() > kMaxIncludeDepth) {
    context_.Stop(directive, "includes are nested more than " + std::to_string(kMaxIncludeDepth) + " deep");
    return false;
  }
  if (sources_.files.size() > kMaxIncludes) {
    context_.Stop(directive, "more than " + std::to_string(kMaxIncludes) + " files are included");
    return false;
  }
  return true;
}

}  // namespace burin::fx
