// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/effect/parameter_override.h"

namespace burin::effect {

/// What a parameter's annotations allow: UIMin and UIMax, and the names that other hosts have for them. Of a component:
/// one number of an annotation holds for all. Empty: the effect says none.
struct ParameterLimits {
  std::optional<double> lowest, highest;
};
[[nodiscard]] ParameterLimits LimitsOf(const fx::Parameter& parameter, std::size_t component);

/// A warning for each value of --param outside its limits. The value is used all the same.
[[nodiscard]] std::vector<std::string> RangeWarnings(const fx::Effect& effect, const Overrides& overrides);

}  // namespace burin::effect
