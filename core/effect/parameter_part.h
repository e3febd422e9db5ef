// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <expected>
#include <string>
#include <string_view>

#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// A parameter or a part of one, as --param names it: "Light", "Lights[1]", "Lights[1].Color".
struct ParameterPart {
  std::size_t offset = 0;  ///< in fx::Value::numbers
  fx::Type type;
};

/// What stands before the first '[' or '.'.
[[nodiscard]] std::string_view ParameterName(std::string_view path);

/// The part of `parameter` that `path` names; otherwise why there is none, in words that name what there is.
[[nodiscard]] std::expected<ParameterPart, std::string> FindPart(const fx::Parameter& parameter, std::string_view path);

}  // namespace burin::effect
