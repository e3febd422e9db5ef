// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/dipole.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/translucency/fresnel.h"

namespace burin::translucency {

double Dipole::Reflectance(double distance_mm) const {
  double sum = 0.0;
  for (const double z : {real_mm, virtual_mm}) {
    const double s = std::sqrt(distance_mm * distance_mm + z * z);
    sum += z * (sigma_tr * s + 1.0) * std::exp(-sigma_tr * s) / (s * s * s);
  }
  return alpha / (4.0 * glm::pi<double>()) * sum;
}

double Dipole::Cumulative(double radius_mm) const {
  double sum = 0.0;
  for (const double z : {real_mm, virtual_mm}) {
    const double d = std::sqrt(radius_mm * radius_mm + z * z);
    sum += std::exp(-sigma_tr * z) - z * std::exp(-sigma_tr * d) / d;
  }
  return 0.5 * alpha * sum;
}

double Dipole::Total() const {
  return 0.5 * alpha * (std::exp(-sigma_tr * real_mm) + std::exp(-sigma_tr * virtual_mm));
}

std::array<Dipole, 3> MakeDipoles(const Medium& medium) {
  const double boundary = BoundaryFactor(static_cast<double>(medium.ior));
  std::array<Dipole, 3> dipoles;
  for (int c = 0; c < 3; ++c) {
    const double scattering = static_cast<double>(medium.reduced_scattering[c]);
    const double absorption = static_cast<double>(medium.absorption[c]);
    const double extinction = scattering + absorption;
    Dipole& dipole = dipoles[static_cast<std::size_t>(c)];
    if (!(extinction > 0.0)) continue;
    dipole.alpha = scattering / extinction;
    dipole.sigma_tr = std::sqrt(3.0 * absorption * extinction);
    dipole.real_mm = 1.0 / extinction;
    const double diffusion = 1.0 / (3.0 * extinction);
    dipole.virtual_mm = dipole.real_mm + 4.0 * boundary * diffusion;
  }
  return dipoles;
}

double TotalReflectance(double alpha, double ior) {
  const double root = std::sqrt(3.0 * (1.0 - alpha));
  return 0.5 * alpha * (1.0 + std::exp(-4.0 / 3.0 * BoundaryFactor(ior) * root)) * std::exp(-root);
}

}  // namespace burin::translucency
