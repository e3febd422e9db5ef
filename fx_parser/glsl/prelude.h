// SPDX-License-Identifier: Apache-2.0
#pragma once
// Functions that the emitted text calls where GLSL has no function with Direct3D 9's arithmetic.

#include <set>
#include <string>

#include "fx_parser/glsl/text.h"

namespace burin::fx {

/// One overload: of which function, for which storage.
struct PreludeFunction {
  std::string name;
  std::string type;  ///< "vec3"
  auto operator<=>(const PreludeFunction&) const = default;
};

/// The definitions, callees first.
[[nodiscard]] std::string PreludeText(const std::set<PreludeFunction>& functions);

}  // namespace burin::fx
