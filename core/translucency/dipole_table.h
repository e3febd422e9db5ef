// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "core/translucency/dipole.h"

namespace burin::translucency {

/// The dipole at squared distances, for shaders. An entry is found by the bits of the squared distance as a 32-bit
/// float, shifted: octaves of kPerOctave even steps, so that an entry is within 0.2 % of the squared distance that it
/// is asked for. Each is one texel of three words, a channel each: R_d in the upper half, its Laplacian over 24 in the
/// lower, both as the upper bits of a 32-bit float (R_d without the sign), rounded to 9 and 8 significant bits.
struct DipoleTable {
  static constexpr int kPerOctave = 256;
  static constexpr int kOctaves = 40;
  /// The table begins at 2^kFirstExponent of the shortest mean free path, squared, and ends at 2^14 of it; beyond both
  /// it is as at its ends.
  static constexpr int kFirstExponent = -12;
  static constexpr int kWidth = kPerOctave;
  static constexpr int kHeight = kOctaves;

  std::vector<glm::uvec4> texels;  ///< kWidth * kHeight; w: 0
};

/// `least_mm`: the shortest mean free path.
[[nodiscard]] DipoleTable MakeDipoleTable(const std::array<Dipole, 3>& dipoles, double least_mm);

}  // namespace burin::translucency
