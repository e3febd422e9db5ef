// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/tessellation/tessellate.h"

namespace burin::tessellation {

/// Where the vertices of a side lie. Both patterns are stepped from both ends to the middle, which makes them
/// symmetric: a side is cut the same way from whichever end a neighbour sees it.
struct Spacing {
  std::uint32_t per_half = 1;  ///< vertices from each end on, the end included, the middle not
  bool has_middle = false;     ///< a vertex at exactly 1/2
  double step = 1.0;           ///< of the parameter

  [[nodiscard]] std::uint32_t segments() const { return 2 * per_half - (has_middle ? 0 : 1); }
  /// Vertices between an end and the middle.
  [[nodiscard]] std::uint32_t inner_half() const { return per_half - 1; }
  /// Parameters of the vertices from `first` on.
  void Fill(std::uint32_t first, std::uint32_t count, double* out) const {
    const std::uint32_t end = first + count, before = std::min(end, per_half);
    std::uint32_t vertex = first;
    for (; vertex < before; ++vertex) *out++ = vertex * step;
    if (has_middle && vertex == per_half && vertex < end) {
      *out++ = 0.5;
      ++vertex;
    }
    for (const std::uint32_t last = segments(); vertex < end; ++vertex) *out++ = 1.0 - (last - vertex) * step;
  }
};

/// `factor`: 1 to kMaxFactor. Integer: ceil(factor) equal segments. Fractional: steps of 1 / factor from both ends, and
/// a vertex in the middle, where new vertices are born in pairs (Moreton, section 5.2).
[[nodiscard]] inline Spacing SpacingOf(Pattern pattern, float factor) {
  if (pattern == Pattern::kFractional)
    return {static_cast<std::uint32_t>(std::ceil(factor * 0.5f)), true, 1.0 / static_cast<double>(factor)};
  const auto segments = static_cast<std::uint32_t>(std::ceil(factor));
  return {(segments + 1) / 2, segments % 2 == 0, 1.0 / segments};
}

}  // namespace burin::tessellation
