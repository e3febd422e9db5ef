// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace burin::gbuffer {

/// GLSL: `vec3 Shade(Surface s)` and what it needs. Wants BlockDeclarations(), the Surface struct, and for lights
/// #define LIGHTS 1.
[[nodiscard]] std::string_view ShadingFunctions();

}  // namespace burin::gbuffer
