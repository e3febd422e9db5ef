// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_share.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace burin::overdraw {
namespace {

constexpr int kReach = 2;

/// Spreads what is set by kReach along lines of `count` items that lie `step` apart.
void Spread(std::vector<std::uint8_t>& mask, int lines, int line_step, int count, int step) {
  std::vector<std::uint8_t> line(static_cast<std::size_t>(count));
  for (int i = 0; i < lines; ++i) {
    std::uint8_t* const first = mask.data() + static_cast<std::ptrdiff_t>(i) * line_step;
    for (int k = 0; k < count; ++k) {
      std::uint8_t set = 0;
      for (int n = std::max(k - kReach, 0); n <= std::min(k + kReach, count - 1); ++n) {
        set |= first[static_cast<std::ptrdiff_t>(n) * step];
      }
      line[static_cast<std::size_t>(k)] = set;
    }
    for (int k = 0; k < count; ++k) first[static_cast<std::ptrdiff_t>(k) * step] = line[static_cast<std::size_t>(k)];
  }
}

}  // namespace

float ShareNearEdges(const image::Image& sums) {
  const auto values = sums.As<float>();
  std::vector<std::uint8_t> mask(values.size() / 4);
  if (mask.empty()) return 0.0f;
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = values[4 * i + 3] > 0.0f ? 1 : 0;
  Spread(mask, sums.height, sums.width, sums.width, 1);
  Spread(mask, sums.width, 1, sums.height, sums.width);
  const auto set = std::ranges::count(mask, std::uint8_t{1});
  return static_cast<float>(set) / static_cast<float>(mask.size());
}

}  // namespace burin::overdraw
