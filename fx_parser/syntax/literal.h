// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers and strings as HLSL and Cg write them.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "fx_parser/syntax/token.h"

namespace burin::fx {

/// The length of the number at the start of `text` (a digit, or '.' and a digit) and what it is: kInteger, kFloat or
/// kBadNumber. `1.xxx` is 1 with a swizzle; a wrong suffix belongs to a bad number.
struct NumberScan {
  std::size_t length = 0;
  TokenKind kind = TokenKind::kInteger;
};
[[nodiscard]] NumberScan ScanNumber(std::string_view text);

/// Decimal, hexadecimal or octal with u and l suffixes; empty if it needs more than 64 bits.
struct IntegerValue {
  std::uint64_t value = 0;
  bool is_unsigned = false;
};
[[nodiscard]] std::optional<IntegerValue> ParseInteger(std::string_view text);

struct FloatValue {
  double value = 0;
  bool is_half = false;
};
/// Independent of the locale. Overflow gives infinity, underflow 0.
[[nodiscard]] FloatValue ParseFloat(std::string_view text);

/// The text between the quotes with its escapes resolved. An unknown escape keeps its backslash: Windows paths such as
/// "..\media\wood.dds" are common in effects.
[[nodiscard]] std::string ParseString(std::string_view quoted);

}  // namespace burin::fx
