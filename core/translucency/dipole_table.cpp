// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/dipole_table.h"

#include <bit>
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

// The float's bits from `lowest` on, rounded to the nearest.
std::uint32_t UpperBits(double value, unsigned lowest) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  return (bits + (1u << (lowest - 1))) >> lowest;
}

std::uint32_t Packed(double reflectance, double laplacian) {
  constexpr unsigned kUnsigned = 15;  // of 31 bits, the upper 16
  constexpr unsigned kSigned = 16;
  return UpperBits(reflectance, kUnsigned) << 16 | UpperBits(laplacian, kSigned);
}

}  // namespace

DipoleTable MakeDipoleTable(const std::array<Dipole, 3>& dipoles, double least_mm) {
  DipoleTable table;
  table.texels.resize(static_cast<std::size_t>(DipoleTable::kWidth) * DipoleTable::kHeight);
  for (int octave = 0; octave < DipoleTable::kOctaves; ++octave) {
    for (int step = 0; step < DipoleTable::kPerOctave; ++step) {
      const double fraction = 1.0 + (step + 0.5) / DipoleTable::kPerOctave;
      const double distance2 = std::ldexp(fraction, octave + DipoleTable::kFirstExponent) * least_mm * least_mm;
      const auto i = static_cast<std::size_t>(octave) * DipoleTable::kPerOctave + static_cast<std::size_t>(step);
      for (int c = 0; c < 3; ++c) {
        const Dipole& dipole = dipoles[static_cast<std::size_t>(c)];
        table.texels[i][c] = Packed(dipole.Reflectance(std::sqrt(distance2)), Laplacian(dipole, distance2) / 24.0);
      }
    }
  }
  return table;
}

}  // namespace burin::translucency
