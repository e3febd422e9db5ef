// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/literal.h"

#include <charconv>
#include <limits>

namespace burin::fx {

namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsWord(char c) { return IsDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool IsExponent(char c) { return c == 'e' || c == 'E'; }
bool IsSign(char c) { return c == '+' || c == '-'; }

int HexValue(char c) {
  if (IsDigit(c)) return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

class NumberScanner {
 public:
  explicit NumberScanner(std::string_view text) : text_(text) {}

  NumberScan Scan() {
    if (At() == '0' && (At(1) == 'x' || At(1) == 'X')) return ScanHex();
    const bool started_with_digit = IsDigit(At());
    SkipDigits();
    if (At() == '.' && (!started_with_digit || DotBelongs())) {
      is_float_ = true;
      ++length_;
      SkipDigits();
    }
    const std::size_t sign = IsSign(At(1)) ? 1 : 0;
    if (IsExponent(At()) && IsDigit(At(1 + sign))) {
      is_float_ = true;
      length_ += 1 + sign;
      SkipDigits();
    }
    return Finish(ScanSuffix());
  }

 private:
  [[nodiscard]] char At(std::size_t offset = 0) const {
    return length_ + offset < text_.size() ? text_[length_ + offset] : '\0';
  }

  void SkipDigits() {
    while (IsDigit(At())) ++length_;
  }

  // `1.f`, `1.e5` and `1.` are numbers, `1.xxx` is a member access.
  [[nodiscard]] bool DotBelongs() const {
    const char next = At(1);
    if (!IsWord(next) || IsDigit(next)) return true;
    if (IsExponent(next)) return IsDigit(At(2)) || IsSign(At(2));
    const bool suffix = std::string_view("fFhHlL").contains(next);
    return suffix && !IsWord(At(2));
  }

  NumberScan ScanHex() {
    length_ = 2;
    while (HexValue(At()) >= 0) ++length_;
    return Finish(length_ > 2 && ScanSuffix() && !is_float_);
  }

  // False if letters follow that are no suffix.
  bool ScanSuffix() {
    const std::size_t begin = length_;
    while (IsWord(At())) ++length_;
    const std::string_view suffix = text_.substr(begin, length_ - begin);
    if (suffix.empty()) return true;
    if (suffix.size() == 1 && std::string_view("fFhHxX").contains(suffix[0])) {   // x: Cg's `fixed`
      is_float_ = true;
      return true;
    }
    if (is_float_) return suffix == "l" || suffix == "L" || suffix == "lf" || suffix == "LF";
    for (const char c : suffix) {
      if (!std::string_view("uUlL").contains(c)) return false;
    }
    return suffix.size() <= 3;
  }

  [[nodiscard]] NumberScan Finish(bool valid) {
    while (IsWord(At())) ++length_;
    if (!valid) return {length_, TokenKind::kBadNumber};
    if (!is_float_ && !OctalDigitsOnly()) return {length_, TokenKind::kBadNumber};
    return {length_, is_float_ ? TokenKind::kFloat : TokenKind::kInteger};
  }

  [[nodiscard]] bool OctalDigitsOnly() const {
    const bool octal = text_[0] == '0' && length_ > 1 && IsDigit(text_[1]);
    if (!octal) return true;
    for (const char c : text_.substr(0, length_)) {
      if (c == '8' || c == '9') return false;
    }
    return true;
  }

  std::string_view text_;
  std::size_t length_ = 0;
  bool is_float_ = false;
};

}  // namespace

NumberScan ScanNumber(std::string_view text) { return NumberScanner(text).Scan(); }

std::optional<IntegerValue> ParseInteger(std::string_view text) {
  IntegerValue result;
  while (!text.empty() && std::string_view("uUlL").contains(text.back())) {
    result.is_unsigned |= text.back() == 'u' || text.back() == 'U';
    text.remove_suffix(1);
  }
  int base = 10;
  if (text.starts_with("0x") || text.starts_with("0X")) {
    base = 16;
    text.remove_prefix(2);
  } else if (text.size() > 1 && text[0] == '0') {
    base = 8;
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result.value, base);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return result;
}

FloatValue ParseFloat(std::string_view text) {
  FloatValue result;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, result.value);
  if (error == std::errc::result_out_of_range) {
    const std::size_t exponent = text.find_first_of("eE");
    const bool tiny = exponent != std::string_view::npos && text.substr(exponent + 1).starts_with('-');
    result.value = tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  result.is_half = !text.empty() && (text.back() == 'h' || text.back() == 'H');
  return result;
}

namespace {

class StringReader {
 public:
  explicit StringReader(std::string_view text) : text_(text) {}

  std::string Read() {
    std::string result;
    while (position_ < text_.size()) {
      const char c = text_[position_++];
      if (c != '\\' || position_ == text_.size()) {
        result += c;
      } else {
        ReadEscape(result);
      }
    }
    return result;
  }

 private:
  void ReadEscape(std::string& result) {
    constexpr std::string_view kNames = "abfnrtv\\\"'?";
    constexpr std::string_view kValues = "\a\b\f\n\r\t\v\\\"'?";
    const char c = text_[position_++];
    if (c == '\n') return;   // a string continued on the next line
    if (c >= '0' && c <= '7') {
      --position_;
      result += ReadDigits(8, 3);
    } else if (c == 'x' && position_ < text_.size() && HexValue(text_[position_]) >= 0) {
      result += ReadDigits(16, 2);
    } else if (const std::size_t index = kNames.find(c); index != std::string_view::npos) {
      result += kValues[index];
    } else {
      result += '\\';
      result += c;
    }
  }

  char ReadDigits(int base, int most) {
    int value = 0;
    for (int i = 0; i < most && position_ < text_.size(); ++i) {
      const int digit = HexValue(text_[position_]);
      if (digit < 0 || digit >= base) break;
      value = value * base + digit;
      ++position_;
    }
    return static_cast<char>(static_cast<unsigned char>(value & 0xff));
  }

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace

std::string ParseString(std::string_view quoted) {
  if (quoted.starts_with('"')) quoted.remove_prefix(1);
  if (quoted.ends_with('"')) quoted.remove_suffix(1);
  return StringReader(quoted).Read();
}

}  // namespace burin::fx
