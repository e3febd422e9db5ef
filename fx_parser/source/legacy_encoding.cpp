// SPDX-License-Identifier: Apache-2.0
// Effect files written in Japan are in code page 932 more often than not, those of Europe in Windows-1252; neither says
// so.
#include "fx_parser/source/legacy_encoding.h"

#include <iconv.h>

#include <cstdint>

namespace burin::fx {
namespace {

/// Bytes of the character that begins with `lead`; 0 for a byte that begins none. (RFC 3629, section 3.)
std::size_t Utf8Length(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return 2;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  return lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
}

unsigned char ByteAt(std::string_view bytes, std::size_t i) { return static_cast<unsigned char>(bytes[i]); }

}  // namespace

bool IsUtf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t length = Utf8Length(ByteAt(bytes, i));
    if (length == 0 || i + length > bytes.size()) return false;
    for (std::size_t k = 1; k < length; ++k) {
      if ((ByteAt(bytes, i + k) & 0xC0) != 0x80) return false;
    }
    i += length;
  }
  return true;
}

bool LooksLikeCp932(std::string_view bytes) {
  bool has_kana_or_kanji = false;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const unsigned char c = ByteAt(bytes, i);
    if (c < 0x80 || (c >= 0xA1 && c <= 0xDF)) continue;  // ASCII, and katakana of half width
    const bool leads = (c >= 0x81 && c <= 0x9F) || (c >= 0xE0 && c <= 0xFC);
    if (!leads || ++i == bytes.size()) return false;
    const unsigned char trail = ByteAt(bytes, i);
    if (trail < 0x40 || trail == 0x7F || trail > 0xFC) return false;
    // Latin-1 has control characters here: what no text of Europe contains.
    has_kana_or_kanji = has_kana_or_kanji || c <= 0x9F;
  }
  return has_kana_or_kanji;
}

std::optional<std::string> Utf8FromCp932(std::string_view bytes) {
  const iconv_t converter = iconv_open("UTF-8", "CP932");
  if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;  // NOLINT: how iconv says it
  std::string input(bytes);
  std::string text(bytes.size() * 3, '\0');  // a character of one byte becomes at most three
  char* from = input.data();
  std::size_t from_left = input.size();
  char* to = text.data();
  std::size_t to_left = text.size();
  const std::size_t result = iconv(converter, &from, &from_left, &to, &to_left);
  iconv_close(converter);
  if (result == static_cast<std::size_t>(-1)) return std::nullopt;
  text.resize(text.size() - to_left);
  return text;
}

}  // namespace burin::fx
