// SPDX-License-Identifier: Apache-2.0
// Any bytes as tokens: their texts lie in the source one after the other, and literals evaluate.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "fx_parser/syntax/lexer.h"
#include "fx_parser/syntax/literal.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace burin::fx;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Diagnostics diagnostics;
  Lexer lexer(text, 0, diagnostics);
  const char* end = text.data();
  for (Token token = lexer.Next(); token.kind != TokenKind::kEnd; token = lexer.Next()) {
    if (token.text.empty() || token.text.data() < end) std::abort();
    end = token.text.data() + token.text.size();
    if (end > text.data() + text.size()) std::abort();
    if (token.kind == TokenKind::kInteger) static_cast<void>(ParseInteger(token.text));
    if (token.kind == TokenKind::kFloat) static_cast<void>(ParseFloat(token.text));
    if (token.kind == TokenKind::kString) static_cast<void>(ParseString(token.text));
  }
  return 0;
}
