// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "fx_parser/source/diagnostic.h"
#include "fx_parser/syntax/macro.h"
#include "fx_parser/syntax/token.h"

namespace burin::fx {

/// Where an expansion takes its unexpanded tokens from. kEnd means no more; for `inside_arguments`, no more in this file.
class TokenSource {
 public:
  virtual ~TokenSource() = default;
  virtual Token Next(bool inside_arguments) = 0;
  /// What the next token is, without side effects; kHash stands for a directive that comes first.
  [[nodiscard]] virtual TokenKind PeekKind() = 0;
};

class TokenListSource final : public TokenSource {
 public:
  explicit TokenListSource(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  Token Next(bool) override { return next_ < tokens_.size() ? tokens_[next_++] : Token{}; }
  TokenKind PeekKind() override { return next_ < tokens_.size() ? tokens_[next_].kind : TokenKind::kEnd; }

 private:
  std::vector<Token> tokens_;
  std::size_t next_ = 0;
};

/// What every expansion of one compilation shares: definitions, new texts, places and limits.
class MacroContext {
 public:
  // Real effects stay below a tenth of these; beyond them a text is a macro bomb.
  static constexpr std::size_t kMaxTokens = std::size_t{1} << 20;
  static constexpr std::size_t kMaxTextBytes = std::size_t{16} << 20;
  static constexpr int kMaxDepth = 200;

  MacroContext(SourceSet& sources, Diagnostics& diagnostics, TokenStream& stream)
      : sources_(sources), diagnostics_(diagnostics), stream_(stream) {}

  MacroTable macros;

  [[nodiscard]] SourceSet& sources() { return sources_; }
  [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }
  [[nodiscard]] bool stopped() const { return stopped_ || diagnostics_.exhausted(); }

  /// A text that lives as long as the token stream.
  std::string_view Keep(std::string text, const Token& where);
  /// The index for Location::macro.
  std::uint32_t AddExpansion(const Macro& macro, const Location& spot, std::uint32_t parent);
  /// Counts tokens that an expansion makes. False: the limit is passed, and expansion has stopped.
  bool Count(std::size_t tokens, const Token& where);
  /// Reports an error after which nothing more is expanded.
  void Stop(const Token& where, std::string text);

 private:
  SourceSet& sources_;
  Diagnostics& diagnostics_;
  TokenStream& stream_;
  std::size_t tokens_ = 0;
  std::size_t text_bytes_ = 0;
  bool stopped_ = false;
};

/// Replaces macros in one run of tokens, after C99 6.10.3: arguments are expanded before substitution unless # or ##
/// touches them, the result is scanned again with the rest, and a macro is not expanded inside itself.
class MacroExpander {
 public:
  MacroExpander(MacroContext& context, TokenSource& source, int depth = 0)
      : context_(context), source_(source), depth_(depth) {}
  ~MacroExpander();
  MacroExpander(const MacroExpander&) = delete;
  MacroExpander& operator=(const MacroExpander&) = delete;

  Token Next();
  /// The next token as it stands, for the operand of `defined`.
  Token NextUnexpanded() { return Pull(false); }

  /// All of `tokens`, expanded on their own.
  [[nodiscard]] static std::vector<Token> ExpandAll(MacroContext& context, std::vector<Token> tokens, int depth = 0);

 private:
  struct Frame {
    std::vector<Token> tokens;
    std::size_t next = 0;
    std::shared_ptr<Macro> macro;
  };
  struct Argument {
    std::vector<Token> raw;
    std::vector<Token> expanded;
    bool is_expanded = false;
  };

  Token Pull(bool inside_arguments);
  TokenKind PeekKind();
  void PopFrame();
  Token ExpandBuiltin(const Macro& macro, const Token& name);
  bool Enter(const Token& name, const std::shared_ptr<Macro>& macro);
  bool CollectArguments(const Token& name, const Macro& macro, std::vector<Argument>& arguments);
  bool CheckArgumentCount(const Token& name, const Macro& macro, std::vector<Argument>& arguments);
  std::vector<Token> Substitute(const Token& name, const Macro& macro, std::vector<Argument>& arguments);
  Token Stringify(const Token& name, const Macro& macro, const Token& spot, const Argument& argument);
  void Paste(std::vector<Token>& result, std::vector<Token> piece, const Token& name);

  MacroContext& context_;
  TokenSource& source_;
  int depth_;
  std::vector<Frame> frames_;
};

}  // namespace burin::fx
