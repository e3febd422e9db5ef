// SPDX-License-Identifier: Apache-2.0
#include "core/render/name_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace burin::render {
namespace {

constexpr int kMaxDigits = 9;

/// One place for a number: where it stands in the text and how many digits it asks for.
struct Token {
  std::size_t begin = 0;
  std::size_t end = 0;
  int digits = 0;
};

std::size_t SkipDigits(std::string_view text, std::size_t at) {
  while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
  return at;
}

/// Digits such as "04": 0 without any, kMaxDigits + 1 when there are more than a number can be.
int DigitsOf(std::string_view text) {
  int value = 0;
  for (const char digit : text) value = std::min(value * 10 + (digit - '0'), kMaxDigits + 1);
  return value;
}

std::optional<Token> TokenAt(std::string_view text, std::size_t at) {
  if (text[at] == '#') {
    std::size_t end = at;
    while (end < text.size() && text[end] == '#') ++end;
    return Token{at, end, static_cast<int>(std::min<std::size_t>(end - at, kMaxDigits + 1))};
  }
  if (text[at] == '%') {
    const std::size_t end = SkipDigits(text, at + 1);
    if (end < text.size() && text[end] == 'd') return Token{at, end + 1, DigitsOf(text.substr(at + 1, end - at - 1))};
    return std::nullopt;
  }
  static constexpr std::string_view kName = "{frame";
  if (text.substr(at).starts_with(kName)) {
    std::size_t end = at + kName.size();
    int digits = 0;
    if (end < text.size() && text[end] == ':') {
      const std::size_t first = end + 1;
      end = SkipDigits(text, first);
      digits = DigitsOf(text.substr(first, end - first));
    }
    if (end < text.size() && text[end] == '}') return Token{at, end + 1, digits};
  }
  return std::nullopt;
}

}  // namespace

Result<NamePattern> NamePattern::Parse(std::string_view path) {
  NamePattern pattern;
  pattern.text_ = pattern.before_ = path;
  for (std::size_t at = 0; at < path.size(); ++at) {
    const std::optional<Token> token = TokenAt(path, at);
    if (!token) continue;
    const std::string_view written = path.substr(token->begin, token->end - token->begin);
    if (pattern.has_token_) {
      return Fail(ErrorKind::kUsage,
                  fmt::format("'{}': a second place for the frame number, '{}'; expected one", path, written));
    }
    if (token->digits > kMaxDigits) {
      return Fail(ErrorKind::kUsage, fmt::format("'{}': '{}' asks for more than {} digits", path, written, kMaxDigits));
    }
    if (path.find('/', token->end) != std::string_view::npos) {
      return Fail(ErrorKind::kUsage,
                  fmt::format("'{}': the frame number '{}' stands in a folder's name; expected it in "
                              "the file's name",
                              path, written));
    }
    pattern.has_token_ = true;
    pattern.before_ = path.substr(0, token->begin);
    pattern.after_ = path.substr(token->end);
    pattern.digits_ = token->digits;
    at = token->end - 1;
  }
  return pattern;
}

std::string NamePattern::Format(long frame) const {
  if (!has_token_) return text_;
  // The sign does not count as a digit, so that -0001 and 0001 line up as the farms' tools have it.
  return fmt::format("{}{}{:0{}}{}", before_, frame < 0 ? "-" : "", frame < 0 ? -frame : frame, digits_, after_);
}

std::optional<long> NamePattern::Match(std::string_view path) const {
  if (!has_token_ || path.size() <= before_.size() + after_.size()) return std::nullopt;
  if (!path.starts_with(before_) || !path.ends_with(after_)) return std::nullopt;
  const std::string_view number = path.substr(before_.size(), path.size() - before_.size() - after_.size());
  long frame = 0;
  const auto [after, status] = std::from_chars(number.data(), number.data() + number.size(), frame);
  if (status != std::errc() || after != number.data() + number.size()) return std::nullopt;
  // "7" is not a name of "####": only names that Format() gives count.
  if (Format(frame) != path) return std::nullopt;
  return frame;
}

Result<std::vector<long>> NamePattern::FindFrames() const {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(text_).parent_path();
  std::error_code status;
  fs::directory_iterator entries(folder.empty() ? fs::path(".") : folder, status);
  if (status) {
    return Fail(ErrorKind::kInput,
                fmt::format("'{}': cannot read the folder '{}': {}", text_, folder.string(), status.message()));
  }
  const std::string in_folder = text_.substr(0, text_.rfind('/') + 1);  // npos + 1 is 0
  std::vector<long> frames;
  for (; entries != fs::directory_iterator(); entries.increment(status)) {
    if (status) break;
    if (const auto frame = Match(in_folder + entries->path().filename().string())) frames.push_back(*frame);
  }
  std::ranges::sort(frames);
  return frames;
}

}  // namespace burin::render
