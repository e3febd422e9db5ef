// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace burin::fx {

[[nodiscard]] bool IsUtf8(std::string_view bytes);

/// Whether bytes that are no UTF-8 read as Windows' Japanese code page 932, in which the second byte of a character may
/// be a backslash. False for what is more likely Latin-1 or Windows-1252.
[[nodiscard]] bool LooksLikeCp932(std::string_view bytes);

/// UTF-8 of text in code page 932; empty when this system cannot convert it.
[[nodiscard]] std::optional<std::string> Utf8FromCp932(std::string_view bytes);

}  // namespace burin::fx
