// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/dipole_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace burin::translucency {
namespace {

// As the shader unpacks a word.
float Reflectance(std::uint32_t word) { return std::bit_cast<float>((word & 0xffff0000u) >> 1); }
float Laplacian(std::uint32_t word) { return std::bit_cast<float>(word << 16); }

constexpr double kNearest = 0.002;       // of the squared distance that an entry stands for
constexpr double kRounding = 1.0 / 512;  // nine significant bits

/// The entry of a squared distance in squares of the shortest mean free path, found by its bits.
const glm::uvec4& EntryOf(const DipoleTable& table, double relative) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(relative));
  const auto first = std::bit_cast<std::uint32_t>(static_cast<float>(std::ldexp(1.0, DipoleTable::kFirstExponent)));
  return table.texels[(bits - first) >> (23 - std::bit_width(unsigned{DipoleTable::kPerOctave} - 1))];
}

TEST(DipoleTable, HoldsReflectancesAndLaplaciansOfEveryMedium) {
  constexpr unsigned kSeed = 20091;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> exponent(-11.5, 9.5);
  for (const Medium& medium : MeasuredMedia()) {
    const std::array<Dipole, 3> dipoles = MakeDipoles(medium);
    const double least = std::min({dipoles[0].real_mm, dipoles[1].real_mm, dipoles[2].real_mm});
    const DipoleTable table = MakeDipoleTable(dipoles, least);
    for (int i = 0; i < 300; ++i) {
      const double relative = std::exp2(exponent(random));
      const double distance = least * std::sqrt(relative);
      const glm::uvec4& entry = EntryOf(table, relative);
      for (std::size_t c = 0; c < 3; ++c) {
        const Dipole& dipole = dipoles[c];
        const double expected = dipole.Reflectance(distance);
        if (expected < 1e-30) continue;
        // How much the function changes over half an entry.
        const double change = std::abs(dipole.Reflectance(distance * (1.0 + 0.5 * kNearest)) - expected);
        const std::uint32_t word = entry[static_cast<int>(c)];
        ASSERT_NEAR(static_cast<double>(Reflectance(word)), expected, 1.01 * change + kRounding * expected)
            << medium.name << " at " << distance << " mm, seed " << kSeed;
        // R'' + R' / r by differences.
        const double step = 1e-3 * std::hypot(distance, dipole.real_mm);
        const double r = std::max(distance, 2.0 * step);
        const double before = dipole.Reflectance(r - step), at = dipole.Reflectance(r),
                     after = dipole.Reflectance(r + step);
        const double laplacian = ((before - 2.0 * at + after) / step + (after - before) / (2.0 * r)) / step;
        const double scale = at / (r * r + dipole.real_mm * dipole.real_mm);
        const double sigma = 1.0 + dipole.sigma_tr * std::hypot(r, dipole.virtual_mm);
        ASSERT_NEAR(static_cast<double>(Laplacian(word)) * 24.0, laplacian,
                    0.02 * std::abs(laplacian) + 0.1 * scale * sigma * sigma)
            << medium.name << " at " << distance << " mm, seed " << kSeed;
      }
    }
  }
}

}  // namespace
}  // namespace burin::translucency
