// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace burin::translucency {

/// GLSL after BodyDeclarations() and gbuffer::LightFunctions(); LIGHTS is 0 or 1.
///   float FresnelTransmittance(float cosine)        what enters or leaves a smooth boundary of the body's eta
///   vec3 EnteringLight(vec3 world, vec3 n, vec3 g)  irradiance times Fresnel's transmittance: shadowed lights and the
///                                                   environment; n: shading normal, g: of the surface itself
[[nodiscard]] std::string IrradianceFunctions();

}  // namespace burin::translucency
