// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <vector>

#include "core/translucency/dipole.h"

namespace burin::translucency {

/// The dipole at squared distances, for shaders. An entry is found by the bits of the squared distance as a 32-bit
/// float, shifted: octaves of kPerOctave even steps, so that an entry is within 0.2 % of the squared distance that it
/// is asked for.
struct DipoleTable {
  static constexpr int kPerOctave = 256;
  static constexpr int kOctaves = 40;
  /// The table begins at 2^kFirstExponent of the shortest mean free path, squared, and ends at 2^14 of it; beyond both
  /// it is as at its ends.
  static constexpr int kFirstExponent = -12;
  static constexpr int kWidth = kPerOctave;
  static constexpr int kHeight = 2 * kOctaves;

  std::vector<glm::vec4> texels;  ///< kWidth * kHeight: R_d first, then its Laplacians over 24
};

/// `least_mm`: the shortest mean free path.
[[nodiscard]] DipoleTable MakeDipoleTable(const std::array<Dipole, 3>& dipoles, double least_mm);

}  // namespace burin::translucency
