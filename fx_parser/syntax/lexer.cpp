// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/lexer.h"

#include <array>

#include "fx_parser/syntax/literal.h"

namespace burin::fx {

namespace {

enum class CharacterClass : std::uint8_t { kOther, kSpace, kNewLine, kWordStart, kDigit, kQuote, kPunctuator };

constexpr std::array<CharacterClass, 256> kClasses = [] {
  std::array<CharacterClass, 256> classes{};
  for (const char c : {' ', '\t', '\v', '\f'}) classes[static_cast<unsigned char>(c)] = CharacterClass::kSpace;
  classes['\n'] = CharacterClass::kNewLine;
  for (int c = 'a'; c <= 'z'; ++c) classes[c] = classes[c - 'a' + 'A'] = CharacterClass::kWordStart;
  classes['_'] = CharacterClass::kWordStart;
  for (int c = '0'; c <= '9'; ++c) classes[c] = CharacterClass::kDigit;
  classes['"'] = CharacterClass::kQuote;
  for (const char c : std::string_view("(){}[];,.:?<>=!+-*/%&|^~#")) {
    classes[static_cast<unsigned char>(c)] = CharacterClass::kPunctuator;
  }
  return classes;
}();

CharacterClass ClassOf(char c) { return kClasses[static_cast<unsigned char>(c)]; }

struct Punctuator {
  std::string_view text;
  TokenKind kind;
};

// Longest first among those with a common start.
constexpr Punctuator kPunctuators[] = {
    {"<<=", TokenKind::kShiftLeftAssign}, {">>=", TokenKind::kShiftRightAssign}, {"...", TokenKind::kEllipsis},
    {"<<", TokenKind::kShiftLeft},        {">>", TokenKind::kShiftRight},        {"<=", TokenKind::kLessEqual},
    {">=", TokenKind::kGreaterEqual},     {"==", TokenKind::kEqual},             {"!=", TokenKind::kNotEqual},
    {"&&", TokenKind::kAndAnd},           {"||", TokenKind::kOrOr},              {"++", TokenKind::kPlusPlus},
    {"--", TokenKind::kMinusMinus},       {"+=", TokenKind::kPlusAssign},        {"-=", TokenKind::kMinusAssign},
    {"*=", TokenKind::kStarAssign},       {"/=", TokenKind::kSlashAssign},       {"%=", TokenKind::kPercentAssign},
    {"&=", TokenKind::kAndAssign},        {"|=", TokenKind::kOrAssign},          {"^=", TokenKind::kXorAssign},
    {"::", TokenKind::kScope},            {"##", TokenKind::kHashHash},          {"(", TokenKind::kLeftParen},
    {")", TokenKind::kRightParen},        {"{", TokenKind::kLeftBrace},          {"}", TokenKind::kRightBrace},
    {"[", TokenKind::kLeftBracket},       {"]", TokenKind::kRightBracket},       {";", TokenKind::kSemicolon},
    {",", TokenKind::kComma},             {".", TokenKind::kDot},                {":", TokenKind::kColon},
    {"?", TokenKind::kQuestion},          {"<", TokenKind::kLess},               {">", TokenKind::kGreater},
    {"=", TokenKind::kAssign},            {"!", TokenKind::kExclamation},        {"+", TokenKind::kPlus},
    {"-", TokenKind::kMinus},             {"*", TokenKind::kStar},               {"/", TokenKind::kSlash},
    {"%", TokenKind::kPercent},           {"&", TokenKind::kAmpersand},          {"|", TokenKind::kPipe},
    {"^", TokenKind::kCaret},             {"~", TokenKind::kTilde},              {"#", TokenKind::kHash},
};

bool IsWord(char c) { return ClassOf(c) == CharacterClass::kWordStart || ClassOf(c) == CharacterClass::kDigit; }

}  // namespace

Lexer::Lexer(std::string_view text, FileId file, Diagnostics& diagnostics)
    : text_(text), file_(file), diagnostics_(diagnostics) {}

const Token& Lexer::Peek() {
  if (!has_peeked_) {
    before_peeked_ = {position_, line_start_, line_, at_line_start_};
    peeked_ = Scan();
    has_peeked_ = true;
  }
  return peeked_;
}

Token Lexer::Next() {
  if (!has_peeked_) return Scan();
  has_peeked_ = false;
  return peeked_;
}

std::string_view Lexer::RestOfLine(Location* begin) {
  if (has_peeked_) {
    position_ = before_peeked_.position;
    line_start_ = before_peeked_.line_start;
    line_ = before_peeked_.line;
    at_line_start_ = before_peeked_.at_line_start;
    has_peeked_ = false;
  }
  while (ClassOf(At()) == CharacterClass::kSpace) ++position_;
  *begin = location();
  const std::size_t start = position_;
  while (position_ < text_.size() && At() != '\n') {
    if (At() != '\\' || !SkipLineSplice()) ++position_;
  }
  std::string_view rest = text_.substr(start, position_ - start);
  while (!rest.empty() && ClassOf(rest.back()) == CharacterClass::kSpace) rest.remove_suffix(1);
  return rest;
}

void Lexer::NewLine() {
  ++position_;
  ++line_;
  line_start_ = position_;
}

bool Lexer::SkipLineSplice() {
  std::size_t ahead = 1;   // spaces between the backslash and the line's end are tolerated, as by most compilers
  while (At(ahead) == ' ' || At(ahead) == '\t') ++ahead;
  if (At(ahead) != '\n') return false;
  position_ += ahead;
  NewLine();
  return true;
}

void Lexer::SkipLineComment() {
  while (position_ < text_.size() && At() != '\n') {
    if (At() != '\\' || !SkipLineSplice()) ++position_;
  }
}

void Lexer::SkipBlockComment() {
  const Location begin = location();
  position_ += 2;
  while (position_ < text_.size() && !(At() == '*' && At(1) == '/')) {
    if (At() == '\n') {
      NewLine();
    } else {
      ++position_;
    }
  }
  if (position_ < text_.size()) {
    position_ += 2;
  } else {
    diagnostics_.Error({begin, begin.line, begin.column + 2}, "B1101", "unterminated comment");
  }
}

void Lexer::SkipSpace(Token& token) {
  token.starts_line = at_line_start_;
  while (position_ < text_.size()) {
    const char c = At();
    if (ClassOf(c) == CharacterClass::kSpace) {
      ++position_;
    } else if (c == '\n') {
      NewLine();
      token.starts_line = true;
    } else if (c == '\\') {
      if (!SkipLineSplice()) return;
    } else if (c == '/' && At(1) == '/') {
      SkipLineComment();
    } else if (c == '/' && At(1) == '*') {
      SkipBlockComment();
    } else {
      return;
    }
    token.space_before = true;
  }
}

Token Lexer::Scan() {
  Token token;
  SkipSpace(token);
  at_line_start_ = false;
  token.begin = location();
  const std::size_t start = position_;
  if (position_ < text_.size()) {
    switch (ClassOf(At())) {
      case CharacterClass::kWordStart:
        while (IsWord(At())) ++position_;
        token.kind = TokenKind::kIdentifier;
        break;
      case CharacterClass::kQuote: token.kind = ScanString(); break;
      case CharacterClass::kDigit:
      case CharacterClass::kPunctuator:
        if (ClassOf(At()) == CharacterClass::kDigit ||
            (At() == '.' && ClassOf(At(1)) == CharacterClass::kDigit)) {
          const NumberScan number = ScanNumber(text_.substr(position_));
          position_ += number.length;
          token.kind = number.kind;
        } else {
          token.kind = ScanPunctuator();
        }
        break;
      default:
        ++position_;
        token.kind = TokenKind::kUnknown;
        break;
    }
  } else {
    token.starts_line = true;   // so that a directive on a last line without a newline ends here
  }
  token.text = text_.substr(start, position_ - start);
  token.end_line = line_;
  token.end_column = column();
  return token;
}

TokenKind Lexer::ScanString() {
  ++position_;
  while (position_ < text_.size() && At() != '\n') {
    const char c = At();
    if (c == '"') {
      ++position_;
      return TokenKind::kString;
    }
    if (c == '\\' && At(1) == '\n') {
      ++position_;
      NewLine();
    } else {
      position_ += c == '\\' && position_ + 1 < text_.size() ? 2 : 1;
    }
  }
  return TokenKind::kUnterminatedString;
}

TokenKind Lexer::ScanPunctuator() {
  for (const Punctuator& punctuator : kPunctuators) {
    if (text_.substr(position_).starts_with(punctuator.text)) {
      position_ += punctuator.text.size();
      return punctuator.kind;
    }
  }
  ++position_;
  return TokenKind::kUnknown;
}

}  // namespace burin::fx
