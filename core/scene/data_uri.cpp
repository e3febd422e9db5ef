// SPDX-License-Identifier: Apache-2.0
#include "core/scene/data_uri.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>

namespace burin::scene {
namespace {

constexpr std::uint8_t kInvalid = 0xff;

constexpr std::array<std::uint8_t, 256> MakeTable() {
  std::array<std::uint8_t, 256> table{};
  table.fill(kInvalid);
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < alphabet.size(); ++i) {
    table[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
  }
  return table;
}
constexpr std::array<std::uint8_t, 256> kTable = MakeTable();

}  // namespace

bool IsDataUri(std::string_view uri) { return uri.starts_with("data:"); }

Result<std::vector<std::byte>> DecodeDataUri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return Fail(ErrorKind::kInput, "data URI without a comma");
  if (!uri.substr(0, comma).ends_with(";base64")) return Fail(ErrorKind::kInput, "data URI that is not base64");
  std::string_view text = uri.substr(comma + 1);
  const std::size_t length = text.size();
  while (!text.empty() && text.back() == '=' && length - text.size() < 2) text.remove_suffix(1);
  if (text.size() % 4 == 1) return Fail(ErrorKind::kInput, fmt::format("base64 of impossible length {}", length));

  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int bit_count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::uint8_t digit = kTable[static_cast<unsigned char>(text[i])];
    if (digit == kInvalid) return Fail(ErrorKind::kInput, fmt::format("bad base64 character at {}", i));
    bits = (bits << 6) | digit;
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    bytes.push_back(static_cast<std::byte>((bits >> bit_count) & 0xffu));
  }
  return bytes;
}

}  // namespace burin::scene
