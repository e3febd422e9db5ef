// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "fx_parser/source/diagnostic.h"
#include "fx_parser/syntax/token.h"

namespace burin::fx {

/// Splits one text into tokens, on demand. Comments and backslash-newlines count as space. Of all faults only an
/// unterminated comment is reported here; the others come out as tokens of their own kinds.
class Lexer {
 public:
  /// `text` must outlive the tokens.
  Lexer(std::string_view text, FileId file, Diagnostics& diagnostics);

  Token Next();
  [[nodiscard]] const Token& Peek();

  /// For #include and #error, whose text is not made of tokens: the rest of the line that the last token taken stands
  /// on, without the space around it. Consumes it. `begin` is where it starts.
  std::string_view RestOfLine(Location* begin);

  [[nodiscard]] Location location() const { return {file_, line_, column(), 0}; }

 private:
  [[nodiscard]] char At(std::size_t offset = 0) const {
    return position_ + offset < text_.size() ? text_[position_ + offset] : '\0';
  }
  [[nodiscard]] std::uint32_t column() const { return static_cast<std::uint32_t>(position_ - line_start_ + 1); }
  void NewLine();
  void SkipSpace(Token& token);
  bool SkipLineSplice();
  void SkipLineComment();
  void SkipBlockComment();
  Token Scan();
  TokenKind ScanString();
  TokenKind ScanPunctuator();

  std::string_view text_;
  FileId file_;
  Diagnostics& diagnostics_;
  std::size_t position_ = 0;
  std::size_t line_start_ = 0;
  std::uint32_t line_ = 1;
  bool at_line_start_ = true;
  bool has_peeked_ = false;
  Token peeked_;
  struct Mark {
    std::size_t position, line_start;
    std::uint32_t line;
    bool at_line_start;
  };
  Mark before_peeked_{};   ///< to take the peeked token back
};

}  // namespace burin::fx
