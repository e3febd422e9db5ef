// SPDX-License-Identifier: Apache-2.0
#include "core/effect/parameter_range.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>

namespace burin::effect {
namespace {

// FX Composer's, DXSAS's, ReShade's and Maya's.
constexpr std::array<std::string_view, 4> kLowest = {"UIMin", "SasUiMin", "ui_min", "minValue"};
constexpr std::array<std::string_view, 4> kHighest = {"UIMax", "SasUiMax", "ui_max", "maxValue"};

// One number holds for every component, several for each its own.
std::optional<double> Limit(const fx::Parameter& parameter, const std::array<std::string_view, 4>& names,
                            std::size_t component) {
  for (const std::string_view name : names) {
    const fx::EffectAnnotation* annotation = fx::FindAnnotation(parameter.annotations, name);
    if (annotation == nullptr || annotation->value.numbers.empty()) continue;
    const std::vector<double>& numbers = annotation->value.numbers;
    if (numbers.size() == 1) return numbers[0];
    if (component < numbers.size()) return numbers[component];
  }
  return std::nullopt;
}

}  // namespace

ParameterLimits LimitsOf(const fx::Parameter& parameter, std::size_t component) {
  return {.lowest = Limit(parameter, kLowest, component), .highest = Limit(parameter, kHighest, component)};
}

std::vector<std::string> RangeWarnings(const fx::Effect& effect, const Overrides& overrides) {
  std::vector<std::string> warnings;
  for (const auto& [index, value] : overrides.parameters) {
    const fx::Parameter& parameter = effect.parameters[index];
    for (std::size_t i = 0; i < value.numbers.size(); ++i) {
      const auto lowest = Limit(parameter, kLowest, i);
      const auto highest = Limit(parameter, kHighest, i);
      const bool is_low = lowest && value.numbers[i] < *lowest;
      const bool is_high = highest && value.numbers[i] > *highest;
      if (!is_low && !is_high) continue;
      warnings.push_back(fmt::format("{}: parameter '{}' is {:g}, {} {:g}", effect.path, parameter.name,
                                     value.numbers[i], is_low ? "below its least" : "above its greatest",
                                     is_low ? *lowest : *highest));
      break;
    }
  }
  return warnings;
}

}  // namespace burin::effect
