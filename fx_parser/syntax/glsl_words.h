// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace burin::fx {

/// What HLSL calls a type or function of GLSL's: "lerp" for "mix"; empty for other words. For messages to people who
/// come from there.
[[nodiscard]] std::string_view HlslWordFor(std::string_view glsl_word);

}  // namespace burin::fx
