// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <expected>
#include <string>

namespace burin::fx {

/// A file's bytes as the lexer wants them: byte order mark stripped, CRLF and lone CR to LF. Bytes beyond ASCII stay as
/// they are, whatever their encoding (cp932 and Latin-1 comments are common). The error says why it is no text.
[[nodiscard]] std::expected<std::string, std::string> NormalizeText(const std::string& bytes);

}  // namespace burin::fx
