// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "fx_parser/syntax/lexer.h"
#include "fx_parser/syntax/macro_expander.h"
#include "fx_parser/syntax/parse.h"
#include "fx_parser/syntax/token.h"

namespace burin::fx {

/// Runs directives and expands macros: one file and its includes in, one stream of tokens out, each of which knows the
/// place that a user would look at. Bounded in tokens, bytes read, include depth and macro depth.
class Preprocessor final : private TokenSource {
 public:
  static constexpr std::size_t kMaxTokens = std::size_t{1} << 20;
  static constexpr std::size_t kMaxSourceBytes = std::size_t{32} << 20;
  static constexpr std::size_t kMaxIncludes = 4096;
  static constexpr std::size_t kMaxIncludeDepth = 64;

  Preprocessor(const FileSystem& files, const PreprocessOptions& options, SourceSet& sources, Diagnostics& diagnostics);

  TokenStream Run(const std::string& path);

  /// True after a fault that makes the rest of the text meaningless (a missing include, #error, a limit).
  [[nodiscard]] bool incomplete() const { return incomplete_ || missing_include_; }

 private:
  struct Input {
    FileId file = kNoFile;
    std::string key;                     // PathKey
    std::unique_ptr<Lexer> lexer;
    std::size_t conditionals = 0;        // open ones when it began
    Location included_from;
    std::uint64_t macro_version = 0;     // when it was included
  };
  struct Conditional {
    Token directive;
    bool parent_live = false;
    bool live = false;                   // this group is kept
    bool taken = false;                  // a group of this #if has been kept
    bool has_else = false;
  };
  using Directive = void (Preprocessor::*)(const Token&);

  // preprocessor.cpp
  Token Next(bool inside_arguments) override;
  TokenKind PeekKind() override;
  void DefineBuiltins();
  bool OpenMain(const std::string& path);
  void Open(const std::string& path, const std::string& bytes_as_text, const Location& included_from);
  bool CloseInput();
  [[nodiscard]] Lexer& lexer() { return *inputs_.back().lexer; }
  [[nodiscard]] bool live() const { return conditionals_.empty() || conditionals_.back().live; }

  // directives.cpp
  void RunDirective();
  static Directive FindDirective(std::string_view name);
  [[nodiscard]] bool AtLineEnd() { return lexer().Peek().starts_line; }
  std::vector<Token> RestOfLineTokens();
  bool ExpectMacroName(const Token& directive, Token& name);
  void Undef(const Token& directive);
  void Error(const Token& directive);
  void Warning(const Token& directive);
  void Line(const Token& directive);
  void Pragma(const Token& directive);

  // conditionals.cpp
  void If(const Token& directive);
  void Ifdef(const Token& directive);
  void Ifndef(const Token& directive);
  void IfMacro(const Token& directive, bool wanted);
  void Elif(const Token& directive);
  void Else(const Token& directive);
  void Endif(const Token& directive);
  Conditional* InnermostOf(const Token& directive);
  void Begin(const Token& directive, bool condition);

  // define_directive.cpp
  void Define(const Token& directive);
  void DefineFromOption(const std::string& name, const std::string& value);
  bool ParseMacro(const Token& name, std::vector<Token> tokens, Macro& macro);
  bool ParseParameters(const std::vector<Token>& tokens, std::size_t& position, Macro& macro);
  bool CheckBody(const Macro& macro);

  // include_directive.cpp
  void Include(const Token& directive);
  bool ReadIncludeName(const Token& directive, std::string& name, Range& range);
  bool ExpandIncludeName(const Token& directive, std::string& name, Range& range);
  bool CheckIncludeLimits(const std::string& path, const std::string& key, const Token& directive, const Range& range);

  const FileSystem& files_;
  const PreprocessOptions& options_;
  SourceSet& sources_;
  Diagnostics& diagnostics_;
  TokenStream stream_;
  MacroContext context_;
  std::vector<Input> inputs_;
  std::vector<Conditional> conditionals_;
  std::set<std::string> once_;           // PathKeys of files with #pragma once
  std::size_t bytes_ = 0;
  bool incomplete_ = false;              // stops at once
  bool missing_include_ = false;         // goes on, so that all missing files are named in one run
};

}  // namespace burin::fx
