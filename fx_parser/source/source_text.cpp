// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/source/source_text.h"

#include <string_view>

namespace burin::fx {

std::expected<std::string, std::string> NormalizeText(const std::string& bytes) {
  std::string_view rest = bytes;
  if (rest.starts_with("\xFF\xFE") || rest.starts_with("\xFE\xFF")) {
    return std::unexpected("the file is UTF-16; save it as UTF-8");
  }
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
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
