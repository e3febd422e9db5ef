// SPDX-License-Identifier: Apache-2.0
#pragma once
// Light from all around in real spherical harmonics, folded with what enters a smooth dielectric. Arrays in, arrays
// out; no GL.

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <span>

namespace burin::translucency {

/// Bands 0 to 4. Nine terms, bands 0 to 2, leave some per cent at the rims of lamps; the cosine's band 3 is nearly 0,
/// its band 4 the last that shows.
inline constexpr int kShBands = 5;
inline constexpr std::size_t kShTerms = 25;

/// Y_lm(n) at l * l + l + m, real, without the Condon-Shortley phase (y, z, x in band 1). `n`: unit.
[[nodiscard]] std::array<double, kShTerms> ShBasis(const glm::dvec3& n);

/// Radiance projected: L_lm. Red, green, blue.
using ShRadiance = std::array<glm::dvec3, kShTerms>;

/// The image's numbers, rows top first; the centre lies at -z, x grows to the right, the top is +y. Texels that are no
/// finite number count as 0.
[[nodiscard]] ShRadiance ProjectLatLong(std::span<const glm::vec3> pixels, int width, int height);

/// Six faces in GL's order (+x -x +y -y +z -z), rows as GL has them, size * size texels each.
[[nodiscard]] ShRadiance ProjectCube(std::span<const glm::vec3> pixels, int size);
/// Of the texel (x, y) of a cube face; all of a cube's add up to 4 pi.
[[nodiscard]] double CubeTexelSolidAngle(int x, int y, int size);

/// Coefficients A_l of the zonal kernel F_t(c) c with max(c, 0): irradiance that enters is E(n) = sum A_l L_lm Y_lm(n).
/// `ior` 1: the plain cosine, pi, 2 pi / 3, pi / 4, 0, -pi / 24. Fresnel's factor depends on the angle to the normal,
/// so it belongs into this kernel; the paper multiplies three series term by term, which is no product of theirs.
[[nodiscard]] std::array<double, kShBands> IrradianceLobe(double ior);

/// A window against ringing round small bright lamps (Sloan 2008, "Stupid Spherical Harmonics Tricks"): band l is
/// multiplied by (1 + cos(pi l / kShBands)) / 2.
[[nodiscard]] std::array<double, kShBands> HanningWindow();

/// A_l L_lm (times the window of l, if any), ready for a sum over Y_lm(n).
[[nodiscard]] std::array<glm::vec3, kShTerms> FoldIrradiance(const ShRadiance& radiance, double ior, bool is_windowed);

/// The sum, not below 0.
[[nodiscard]] glm::dvec3 EvaluateIrradiance(const std::array<glm::vec3, kShTerms>& folded, const glm::dvec3& normal);

}  // namespace burin::translucency
