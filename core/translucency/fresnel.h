// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fresnel reflection of unpolarised light at a smooth dielectric boundary. `ior`: eta, of the inside over the outside.

namespace burin::translucency {

/// Reflectance for light that comes from outside (`ior` > 1) or inside (pass 1 / ior) at this cosine to the normal;
/// 1 beyond the critical angle.
[[nodiscard]] double FresnelReflectance(double cosine, double ior);

/// Average diffuse reflectance F_dr of the inside of the boundary, by Egan and Hilgeman's fit as Jensen et al. 2001
/// print it.
[[nodiscard]] double DiffuseFresnelFit(double ior);
/// The same by integration: 2 int_0^1 F(c, 1 / ior) c dc.
[[nodiscard]] double DiffuseFresnelExact(double ior);

/// A = (1 + F_dr) / (1 - F_dr) of the fit.
[[nodiscard]] double BoundaryFactor(double ior);

}  // namespace burin::translucency
