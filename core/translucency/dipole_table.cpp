// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/dipole_table.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace burin::translucency {
namespace {

// In the plane, for s^2 = d^2 + z^2 and x = sigma s, of each source:
//   z e^-x / s^5 (t (15 + 15 x + 6 x^2 + x^3) - 6 - 6 x - 2 x^2),  t = d^2 / s^2.
double Laplacian(const Dipole& dipole, double distance2) {
  double sum = 0.0;
  for (const double z : {dipole.real_mm, dipole.virtual_mm}) {
    const double s2 = distance2 + z * z;
    const double s = std::sqrt(s2);
    const double x = dipole.sigma_tr * s;
    const double t = distance2 / s2;
    const double bend = t * (15.0 + 15.0 * x + 6.0 * x * x + x * x * x) - 6.0 - 6.0 * x - 2.0 * x * x;
    sum += z * std::exp(-x) / (s2 * s2 * s) * bend;
  }
  return dipole.alpha / (4.0 * glm::pi<double>()) * sum;
}

}  // namespace

DipoleTable MakeDipoleTable(const std::array<Dipole, 3>& dipoles, double least_mm) {
  DipoleTable table;
  table.texels.resize(static_cast<std::size_t>(DipoleTable::kWidth) * DipoleTable::kHeight);
  const std::size_t laplacians = table.texels.size() / 2;
  for (int octave = 0; octave < DipoleTable::kOctaves; ++octave) {
    for (int step = 0; step < DipoleTable::kPerOctave; ++step) {
      const double fraction = 1.0 + (step + 0.5) / DipoleTable::kPerOctave;
      const double distance2 = std::ldexp(fraction, octave + DipoleTable::kFirstExponent) * least_mm * least_mm;
      const auto i = static_cast<std::size_t>(octave) * DipoleTable::kPerOctave + static_cast<std::size_t>(step);
      for (int c = 0; c < 3; ++c) {
        const Dipole& dipole = dipoles[static_cast<std::size_t>(c)];
        table.texels[i][c] = static_cast<float>(dipole.Reflectance(std::sqrt(distance2)));
        table.texels[laplacians + i][c] = static_cast<float>(Laplacian(dipole, distance2) / 24.0);
      }
    }
  }
  return table;
}

}  // namespace burin::translucency
