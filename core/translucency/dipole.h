// SPDX-License-Identifier: Apache-2.0
#pragma once
// The dipole diffusion approximation: how light that enters a flat surface at one point comes out around it.
//
// Jensen and Buhler 2002, "A Rapid Hierarchical Rendering Technique for Translucent Materials", section 2. The paper
// that this stage follows prints z_v = z_r (1 + 4 A D), which mixes a length with a number, and puts the virtual source
// on the real one's side; here z_v = z_r + 4 A D, above the surface.

#include <array>

#include "core/translucency/medium.h"

namespace burin::translucency {

/// One channel of a medium. Lengths in millimetres.
struct Dipole {
  double alpha = 0.0;       ///< reduced albedo
  double sigma_tr = 0.0;    ///< effective transport coefficient, 1/mm
  double real_mm = 1.0;     ///< z_r = 1 / sigma_t', depth of the real source
  double virtual_mm = 1.0;  ///< z_v = z_r + 4 A D, height of the virtual one

  /// Diffuse reflectance R_d, 1/mm^2, at `distance_mm` in the plane. Over any surface this planar form, with the plain
  /// distance between two points, is bounded, where sources that stand below a curved surface are not.
  [[nodiscard]] double Reflectance(double distance_mm) const;
  /// Integral of R_d over the disc of that radius.
  [[nodiscard]] double Cumulative(double radius_mm) const;
  /// Integral over the plane.
  [[nodiscard]] double Total() const;
};

[[nodiscard]] std::array<Dipole, 3> MakeDipoles(const Medium& medium);

/// Total() as a function of the reduced albedo alone: what a uniformly lit half-space gives off of what enters it.
[[nodiscard]] double TotalReflectance(double alpha, double ior);

}  // namespace burin::translucency
