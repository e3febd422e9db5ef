// SPDX-License-Identifier: Apache-2.0
#include "core/scene/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/scene/scene_folder.h"

namespace burin::scene {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;
constexpr std::size_t kMostShown = 40;

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r'; }

// from_chars takes no plus sign.
std::string_view WithoutPlus(std::string_view word) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

template <class T>
std::optional<T> Parse(std::string_view word) {
  word = WithoutPlus(word);
  T value{};
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (status != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<std::string_view> TextLines::Next() {
  if (rest_.empty()) return std::nullopt;
  ++number_;
  const std::size_t end = rest_.find('\n');
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::string_view TakeWord(std::string_view& line) {
  const auto* const begin = std::find_if_not(line.begin(), line.end(), IsBlank);
  const auto* const end = std::find_if(begin, line.end(), IsBlank);
  const std::string_view word(begin, end);
  line = std::string_view(end, line.end());
  return word;
}

std::optional<float> ParseFinite(std::string_view word) {
  const std::optional<double> value = Parse<double>(word);
  if (!value) return std::nullopt;
  const auto rounded = static_cast<float>(*value);
  return std::isfinite(rounded) ? std::optional(rounded) : std::nullopt;
}

std::optional<int> ParseWhole(std::string_view word) { return Parse<int>(word); }

Result<std::string> ReadText(const std::string& path) {
  const Result<std::vector<std::byte>> bytes = ReadRegularFile(path, kMostBytes);
  if (!bytes) return std::unexpected(bytes.error());
  return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
}

std::string Found(std::string_view word) {
  if (word.empty()) return "nothing";
  std::string shown(word.substr(0, kMostShown));
  std::ranges::replace_if(
      shown, [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return "'" + shown + (word.size() > kMostShown ? "...'" : "'");
}

}  // namespace burin::scene
