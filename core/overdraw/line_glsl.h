// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace burin::overdraw {

/// TilePass's body for EdgeRecords of lines: each is drawn over the picture one pixel wide with square caps of half a
/// pixel, through a box filter of one pixel, blended in linear light; the depth is tested (Sander et al.,
/// "Discontinuity Edge Overdraw", 2001).
[[nodiscard]] std::string_view LineBody();

/// How far from an edge its line reaches: pixels, in x and in y, to their squares.
inline constexpr float kLineReach = 1.0f;

}  // namespace burin::overdraw
