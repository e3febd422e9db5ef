// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// What `--param NAME=VALUE` sets, found and checked. The last of several for one name wins.
struct Overrides {
  std::map<std::size_t, fx::Value> parameters;  ///< by index in Effect::parameters
  std::map<std::size_t, std::string> textures;  ///< by index in Effect::textures: a file
};

/// A value is as many numbers as the parameter has components, separated by commas or spaces (matrices row by row,
/// arrays element after element, structs member after member); a part of a parameter can be named alone,
/// "Lights[1].Color"; `true` and `false` for bools; any text for strings; a file for textures. Errors: kUsage, naming
/// near names, or what was expected and what was found.
[[nodiscard]] Result<Overrides> ParseOverrides(const fx::Effect& effect,
                                               const std::vector<std::pair<std::string, std::string>>& parameters);

}  // namespace burin::effect
