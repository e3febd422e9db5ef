// SPDX-License-Identifier: Apache-2.0
#include "cli/option_values.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

namespace burin::cli {
namespace {

std::unexpected<Error> Refused(std::string_view option, std::string_view text, std::string_view expected) {
  return Fail(ErrorKind::kUsage, fmt::format("--{} {}: expected {}", option, text.empty() ? "''" : text, expected));
}

template <class T>
std::optional<T> Number(std::string_view text) {
  T value{};
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The transfer function of IEC 61966-2-1, display to linear.
float LinearFromSrgb(double display) {
  return static_cast<float>(display <= 0.04045 ? display / 12.92 : std::pow((display + 0.055) / 1.055, 2.4));
}

std::optional<std::array<float, 4>> HexColor(std::string_view digits) {
  if (digits.size() != 6 && digits.size() != 8) return std::nullopt;
  std::array<float, 4> color{0, 0, 0, 1};
  for (std::size_t i = 0; i < digits.size() / 2; ++i) {
    int byte = 0;
    const char* const begin = digits.data() + 2 * i;
    const auto [end, status] = std::from_chars(begin, begin + 2, byte, 16);
    if (status != std::errc() || end != begin + 2 || byte < 0) return std::nullopt;
    color[i] = i < 3 ? LinearFromSrgb(byte / 255.0) : static_cast<float>(byte) / 255.0f;
  }
  return color;
}

std::vector<std::string_view> Split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

}  // namespace

Result<std::pair<int, int>> ParseSize(std::string_view text) {
  const std::size_t at = text.find_first_of("xX");
  if (at != std::string_view::npos) {
    const auto width = Number<int>(text.substr(0, at));
    const auto height = Number<int>(text.substr(at + 1));
    if (width && height && *width > 0 && *height > 0) return std::pair(*width, *height);
  }
  return Refused("size", text, "WIDTHxHEIGHT in pixels, both at least 1, such as 1920x1080");
}

Result<video::FrameRate> ParseFrameRate(std::string_view text) {
  static constexpr std::string_view kExpected =
      "frames a second above 0 and at most 1000, such as 24, 23.976 or 30000/1001";
  const std::size_t slash = text.find('/');
  if (slash != std::string_view::npos) {
    const auto numerator = Number<int>(text.substr(0, slash));
    const auto denominator = Number<int>(text.substr(slash + 1));
    if (!numerator || !denominator || *numerator <= 0 || *denominator <= 0) return Refused("fps", text, kExpected);
    const video::FrameRate rate{*numerator, *denominator};
    if (rate.value() > 1000.0) return Refused("fps", text, kExpected);
    return rate;
  }
  const auto value = Number<double>(text);
  if (!value || !std::isfinite(*value) || *value < 0.001 || *value > 1000.0) return Refused("fps", text, kExpected);
  if (*value == std::floor(*value)) return video::FrameRate{static_cast<int>(*value), 1};
  for (const int base : {24, 30, 48, 60, 120}) {
    if (std::abs(*value - base * 1000.0 / 1001.0) < 0.002) return video::FrameRate{base * 1000, 1001};
  }
  return video::FrameRate{static_cast<int>(std::lround(*value * 1000.0)), 1000};
}

Result<std::array<float, 4>> ParseColor(std::string_view text) {
  if (text == "transparent") return std::array<float, 4>{0, 0, 0, 0};
  if (text == "black") return std::array<float, 4>{0, 0, 0, 1};
  if (text == "white") return std::array<float, 4>{1, 1, 1, 1};
  if (text.starts_with('#')) {
    if (const auto color = HexColor(text.substr(1))) return *color;
  } else {
    const std::vector<std::string_view> parts = Split(text, ',');
    std::array<float, 4> color{0, 0, 0, 1};
    bool good = parts.size() == 3 || parts.size() == 4;
    for (std::size_t i = 0; good && i < parts.size(); ++i) {
      const auto value = Number<float>(parts[i]);
      good = value && std::isfinite(*value) && *value >= 0.0f && (i < 3 || *value <= 1.0f);
      if (good) color[i] = *value;
    }
    if (good) return color;
  }
  return Refused("background", text,
                 "#RRGGBB or #RRGGBBAA (sRGB), R,G,B or R,G,B,A (scene-linear), black, white or transparent");
}

Result<double> ParseNumber(std::string_view option, std::string_view text) {
  const auto value = Number<double>(text.starts_with('+') ? text.substr(1) : text);
  if (!value || !std::isfinite(*value)) return Refused(option, text, "a number");
  return *value;
}

Result<long> ParseInteger(std::string_view option, std::string_view text, long lowest, long highest) {
  const auto value = Number<long>(text);
  if (!value || *value < lowest || *value > highest) {
    return Refused(option, text, fmt::format("a whole number from {} to {}", lowest, highest));
  }
  return *value;
}

Result<std::pair<std::string, std::string>> ParseAssignment(std::string_view option, std::string_view text,
                                                            const char* otherwise, std::string_view kind) {
  const std::size_t equals = text.find('=');
  const bool has_name = !text.empty() && (text[0] == '_' || std::isalpha(static_cast<unsigned char>(text[0])) != 0);
  if (!has_name || (equals == std::string_view::npos && otherwise == nullptr)) {
    const std::string pair = fmt::format("NAME={}", kind);
    return Refused(option, text, otherwise != nullptr ? "NAME or " + pair : pair);
  }
  if (equals == std::string_view::npos) return std::pair(std::string(text), std::string(otherwise));
  return std::pair(std::string(text.substr(0, equals)), std::string(text.substr(equals + 1)));
}

Result<std::vector<std::string>> ParseNames(std::string_view option, std::string_view text) {
  std::vector<std::string> names;
  for (const std::string_view name : Split(text, ',')) {
    if (name.empty()) return Refused(option, text, "names separated by commas");
    names.emplace_back(name);
  }
  return names;
}

}  // namespace burin::cli
