// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/source/source_text.h"

#include <optional>
#include <string_view>

#include "fx_parser/source/legacy_encoding.h"

namespace burin::fx {

std::expected<std::string, std::string> NormalizeText(const std::string& bytes) {
  std::string_view rest = bytes;
  if (rest.starts_with("\xFF\xFE") || rest.starts_with("\xFE\xFF")) {
    return std::unexpected("the file is UTF-16; save it as UTF-8");
  }
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  // The mark by which DOS ended a text; some editors still write it.
  if (const std::size_t end = rest.find('\x1A'); end != std::string_view::npos) rest = rest.substr(0, end);
  std::optional<std::string> converted;
  if (!IsUtf8(rest) && LooksLikeCp932(rest)) converted = Utf8FromCp932(rest);
  if (converted) rest = *converted;
  std::string text;
  text.reserve(rest.size());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest[i] == '\0') return std::unexpected("the file is not text (it has a zero byte)");
    if (rest[i] != '\r') {
      text += rest[i];
    } else if (i + 1 == rest.size() || rest[i + 1] != '\n') {
      text += '\n';
    }
  }
  return text;
}

}  // namespace burin::fx
