// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/effect/parameter_override.h"

namespace burin::effect {

/// A warning for each value of --param outside what the effect's annotations allow: UIMin and UIMax, and the names that
/// other hosts have for them. The value is used all the same.
[[nodiscard]] std::vector<std::string> RangeWarnings(const fx::Effect& effect, const Overrides& overrides);

}  // namespace burin::effect
