// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin::bench {

/// Scene-linear red, green and blue over the opaque background, clamped to 0..1 as a display shows them: one highlight
/// of 5 would otherwise weigh more than a whole outline.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
};

/// One byte a pixel: 1 within two pixels of a visible discontinuity edge.
using Mask = std::vector<std::uint8_t>;

/// Which share of the frame is set.
[[nodiscard]] inline double Share(const Mask& mask) {
  std::size_t set = 0;
  for (const std::uint8_t pixel : mask) set += pixel;
  return static_cast<double>(set) / static_cast<double>(mask.size());
}

}  // namespace burin::bench
