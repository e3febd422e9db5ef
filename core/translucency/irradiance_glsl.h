// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/translucency/body_block.h"
#include "core/translucency/scattering_quality.h"

namespace burin::translucency {

/// GLSL after BodyDeclarations() and gbuffer::LightFunctions(); LIGHTS is 0 or 1.
///   float FresnelTransmittance(float cosine)        what enters or leaves a smooth boundary of the body's eta
///   vec3 EnteringLight(vec3 world, vec3 n, vec3 g)  irradiance times Fresnel's transmittance: shadowed lights and the
///                                                   environment; n: shading normal, g: of the surface itself
/// `fixed_lights`: FixedLights of what is drawn, or 0 for any lights.
[[nodiscard]] std::string IrradianceFunctions(const Quality& quality, int fixed_lights = 0);

/// How many lights there are, if few and of one shadow map each, for faster shaders; else 0.
[[nodiscard]] int FixedLights(const ShadowBlock& shadows, int lights);

}  // namespace burin::translucency
