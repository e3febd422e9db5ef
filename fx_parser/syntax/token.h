// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "fx_parser/source/source.h"

namespace burin::fx {

enum class TokenKind : std::uint8_t {
  kEnd, kIdentifier, kInteger, kFloat, kString,
  // Malformed texts travel as tokens, so that those in skipped #if groups and asm blocks do no harm.
  kBadNumber, kUnterminatedString, kUnknown,
  kLeftParen, kRightParen, kLeftBrace, kRightBrace, kLeftBracket, kRightBracket,
  kSemicolon, kComma, kDot, kColon, kScope, kQuestion, kEllipsis,
  kLess, kGreater, kLessEqual, kGreaterEqual, kEqual, kNotEqual,
  kPlus, kMinus, kStar, kSlash, kPercent, kPlusPlus, kMinusMinus,
  kShiftLeft, kShiftRight, kAmpersand, kPipe, kCaret, kTilde, kExclamation, kAndAnd, kOrOr,
  kAssign, kPlusAssign, kMinusAssign, kStarAssign, kSlashAssign, kPercentAssign,
  kShiftLeftAssign, kShiftRightAssign, kAndAssign, kOrAssign, kXorAssign,
  kHash, kHashHash
};

/// `text` lives as long as the TokenStream that the token belongs to.
struct Token {
  TokenKind kind = TokenKind::kEnd;
  bool starts_line = false;    ///< first on its line, comments aside
  bool space_before = false;
  bool no_expand = false;      ///< a macro's name met inside its own expansion: never expanded again (C99 6.10.3.4)
  std::string_view text;
  Location begin;
  std::uint32_t end_line = 0;
  std::uint32_t end_column = 0;   ///< exclusive

  [[nodiscard]] Range range() const { return {begin, end_line, end_column}; }
  [[nodiscard]] bool Is(std::string_view identifier) const {
    return kind == TokenKind::kIdentifier && text == identifier;
  }
};

/// The preprocessed text: all tokens, ended by one kEnd.
struct TokenStream {
  struct PackMatrix {
    std::size_t from = 0;      ///< index in `tokens`
    bool row_major = false;
  };
  std::vector<Token> tokens;
  std::vector<PackMatrix> pack_matrix;   ///< #pragma pack_matrix, in order
  std::deque<std::string> texts;         ///< what the tokens' texts point into; a deque never moves its strings
};

/// Compares ASCII letters without regard to case.
[[nodiscard]] bool EqualsIgnoringCase(std::string_view a, std::string_view b);

/// As messages name it: "'float4'", "end of file".
[[nodiscard]] std::string Describe(const Token& token);

/// From the start of `first` to the end of `last`; only `first` where the two are not in one text in this order.
[[nodiscard]] Range Join(const Range& first, const Range& last);

}  // namespace burin::fx
