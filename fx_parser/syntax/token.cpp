// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/token.h"

namespace burin::fx {

namespace {

// Messages stay readable when the text is a page-long string.
constexpr std::size_t kMaxDescribed = 40;

char Lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

bool EqualsIgnoringCase(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (Lower(a[i]) != Lower(b[i])) return false;
  }
  return true;
}

std::string Describe(const Token& token) {
  if (token.kind == TokenKind::kEnd) return "end of file";
  if (token.kind == TokenKind::kUnknown) {
    const auto byte = static_cast<unsigned char>(token.text.empty() ? '\0' : token.text[0]);
    if (byte < 0x20 || byte > 0x7e) {
      constexpr std::string_view kHex = "0123456789ABCDEF";
      return std::string("byte 0x") + kHex[byte >> 4] + kHex[byte & 15];
    }
  }
  std::string text(token.text.substr(0, kMaxDescribed));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  if (token.text.size() > kMaxDescribed) text += "...";
  return token.kind == TokenKind::kString ? text : "'" + text + "'";
}

Range Join(const Range& first, const Range& last) {
  const bool same_text = first.begin.file == last.begin.file;
  const bool ordered = last.end_line > first.end_line ||
                       (last.end_line == first.end_line && last.end_column >= first.end_column);
  if (!same_text || !ordered) return first;
  return {first.begin, last.end_line, last.end_column};
}

}  // namespace burin::fx
