// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace burin::gbuffer {

/// GLSL, empty without LIGHTS: `lights[]` and `vec3 LightArriving(int i, vec3 position, out vec3 l)`, its irradiance on
/// a surface that faces it, and the unit direction towards it.
[[nodiscard]] std::string_view LightFunctions();

/// GLSL: `vec3 Shade(Surface s)` and what it needs. Wants BlockDeclarations(), LightFunctions(), the Surface struct,
/// and for lights #define LIGHTS 1.
[[nodiscard]] std::string_view ShadingFunctions();

}  // namespace burin::gbuffer
