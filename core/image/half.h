// SPDX-License-Identifier: Apache-2.0
#pragma once
// IEEE 754 binary16, as bits in a std::uint16_t.

#include <cstddef>
#include <cstdint>

namespace burin::image {

[[nodiscard]] float FloatFromHalf(std::uint16_t half);
/// Rounds to nearest, ties to even; too large becomes infinity, NaN stays NaN (quiet).
[[nodiscard]] std::uint16_t HalfFromFloat(float value);

/// Arrays, vectorised; the two may not overlap.
void FloatsFromHalves(const std::uint16_t* halves, float* floats, std::size_t count);
void HalvesFromFloats(const float* floats, std::uint16_t* halves, std::size_t count);

}  // namespace burin::image
