// SPDX-License-Identifier: Apache-2.0
#pragma once
// The sRGB transfer functions of IEC 61966-2-1:1999, with 0.0031308 and 0.04045 as break points. Below 0 the linear
// segment goes on, above 1 the power does; NaN and infinity pass through.

#include <array>
#include <cstdint>
#include <span>

namespace burin::image {

/// One value by the C library: the reference for the fast ones.
[[nodiscard]] float SrgbFromLinear(float linear);
[[nodiscard]] float LinearFromSrgb(float encoded);

/// LinearFromSrgb(i / 255).
[[nodiscard]] const std::array<float, 256>& LinearFromSrgb8Table();

/// In place over pixels of 4 floats, alpha left alone; vectorised, within 2e-6 relative of the functions above.
void SrgbFromLinearRgba(std::span<float> rgba);
void LinearFromSrgbRgba(std::span<float> rgba);

}  // namespace burin::image
