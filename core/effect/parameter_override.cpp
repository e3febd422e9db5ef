// SPDX-License-Identifier: Apache-2.0
#include "core/effect/parameter_override.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "core/effect/parameter_part.h"
#include "core/effect/text.h"
#include "fx_parser/semantics/conversion.h"
#include "fx_parser/source/diagnostic.h"

namespace burin::effect {
namespace {

std::vector<std::string_view> SplitNumbers(std::string_view text) {
  std::vector<std::string_view> words;
  constexpr std::string_view kSpace = " \t\n";
  const bool has_comma = text.find(',') != std::string_view::npos;
  const std::string_view separators = has_comma ? std::string_view(",") : kSpace;
  while (true) {
    const std::size_t end = text.find_first_of(separators);
    std::string_view word = text.substr(0, end);
    while (!word.empty() && kSpace.find(word.front()) != kSpace.npos) word.remove_prefix(1);
    while (!word.empty() && kSpace.find(word.back()) != kSpace.npos) word.remove_suffix(1);
    if (!word.empty() || has_comma) words.push_back(word);
    if (end == std::string_view::npos) return words;
    text.remove_prefix(end + 1);
  }
}

std::optional<double> ParseNumber(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::optional<double> ParseBool(std::string_view word) {
  for (const std::string_view yes : {"true", "1", "yes", "on"}) {
    if (EqualsIgnoringCase(word, yes)) return 1.0;
  }
  for (const std::string_view no : {"false", "0", "no", "off"}) {
    if (EqualsIgnoringCase(word, no)) return 0.0;
  }
  return std::nullopt;
}

// One component; the reason in words when it isn't one.
std::expected<double, std::string> ParseComponent(fx::Scalar scalar, std::string_view word) {
  if (scalar == fx::Scalar::kBool) {
    if (const auto value = ParseBool(word)) return *value;
    return std::unexpected(fmt::format("'{}' is neither true nor false", word));
  }
  const auto number = ParseNumber(word);
  if (!number) return std::unexpected(fmt::format("'{}' is not a number", word));
  if (scalar == fx::Scalar::kInt || scalar == fx::Scalar::kUint) {
    const double low = scalar == fx::Scalar::kUint ? 0.0 : std::numeric_limits<std::int32_t>::min();
    const double high = scalar == fx::Scalar::kUint ? std::numeric_limits<std::uint32_t>::max()
                                                    : std::numeric_limits<std::int32_t>::max();
    if (*number != std::trunc(*number)) return std::unexpected(fmt::format("'{}' is not a whole number", word));
    if (*number < low || *number > high) return std::unexpected(fmt::format("'{}' is out of range", word));
  } else if (std::abs(*number) > std::numeric_limits<float>::max()) {
    return std::unexpected(fmt::format("'{}' is out of range", word));
  }
  return *number;
}

// The numbers of a part of a parameter, one a scalar.
std::expected<std::vector<double>, std::string> ParseNumbers(const fx::Type& type, const std::string& text) {
  const bool has_numbers = type.kind == fx::TypeKind::kNumeric || type.kind == fx::TypeKind::kStruct;
  std::vector<fx::Scalar> scalars;
  if (has_numbers && fx::FlatComponents(type) > 0) fx::AppendFlatScalars(type, scalars);
  if (scalars.empty()) return std::unexpected(std::string("values of this type cannot be set"));
  const auto words = SplitNumbers(text);
  if (words.size() != scalars.size()) {
    return std::unexpected(
        fmt::format("expected {} number{}, found {}", scalars.size(), scalars.size() == 1 ? "" : "s", words.size()));
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto number = ParseComponent(scalars[i], words[i]);
    if (!number) return std::unexpected(number.error());
    numbers.push_back(*number);
  }
  return numbers;
}

// `so_far`: of an earlier assignment or the default; what `path` does not name stays as it is.
std::expected<fx::Value, std::string> ParseValue(const fx::Parameter& parameter, const std::string& path,
                                                 const std::string& text, const fx::Value& so_far) {
  fx::Value value = so_far;
  value.type = parameter.type;
  if (parameter.type.kind == fx::TypeKind::kString && !parameter.type.is_array()) {
    value.strings = {text};
    return value;
  }
  const auto part = FindPart(parameter, path);
  if (!part) return std::unexpected(part.error());
  const auto numbers = ParseNumbers(part->type, text);
  if (!numbers) return std::unexpected(numbers.error());
  value.numbers.resize(std::max(value.numbers.size(), part->offset + numbers->size()));
  std::copy(numbers->begin(), numbers->end(), value.numbers.begin() + static_cast<std::ptrdiff_t>(part->offset));
  return value;
}

Error UnknownName(const fx::Effect& effect, const std::string& name) {
  std::vector<std::string> names;
  for (const fx::Parameter& parameter : effect.parameters) names.push_back(parameter.name);
  for (const fx::Texture& texture : effect.textures) {
    if (std::holds_alternative<fx::FileRole>(texture.role)) names.push_back(texture.name);
  }
  std::string message = fmt::format("{} has no parameter '{}'", effect.path, name);
  if (const std::string near = fx::NearestName(name, names); !near.empty()) {
    message += fmt::format("; did you mean '{}'?", near);
  } else if (!names.empty()) {
    message += fmt::format("; it has {}", fmt::join(names, ", "));
  }
  return {ErrorKind::kUsage, std::move(message)};
}

template <class Things>
std::optional<std::size_t> Find(const Things& things, const std::string& name) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (things[i].name == name) return i;
  }
  return std::nullopt;
}

}  // namespace

Result<Overrides> ParseOverrides(const fx::Effect& effect,
                                 const std::vector<std::pair<std::string, std::string>>& parameters) {
  Overrides overrides;
  for (const auto& [name, text] : parameters) {
    if (const auto index = Find(effect.parameters, std::string(ParameterName(name)))) {
      const fx::Parameter& parameter = effect.parameters[*index];
      const auto earlier = overrides.parameters.find(*index);
      auto value = ParseValue(parameter, name, text,
                              earlier != overrides.parameters.end() ? earlier->second : parameter.default_value);
      if (!value) {
        return Fail(ErrorKind::kUsage, fmt::format("parameter '{}' of {} ({}): {}", name, effect.path,
                                                   fx::ToString(parameter.type), value.error()));
      }
      overrides.parameters.insert_or_assign(*index, std::move(*value));
    } else if (const auto texture = Find(effect.textures, name)) {
      if (!std::holds_alternative<fx::FileRole>(effect.textures[*texture].role)) {
        return Fail(ErrorKind::kUsage,
                    fmt::format("texture '{}' of {} is rendered and takes no file", name, effect.path));
      }
      if (text.empty())
        return Fail(ErrorKind::kUsage, fmt::format("texture '{}' of {}: no file named", name, effect.path));
      overrides.textures.insert_or_assign(*texture, text);
    } else {
      return std::unexpected(UnknownName(effect, name));
    }
  }
  return overrides;
}

}  // namespace burin::effect
