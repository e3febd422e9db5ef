// SPDX-License-Identifier: Apache-2.0
#include "core/image/cube_layout.h"

#include <cstddef>

namespace burin::image {

const CubeGrid& GridOf(CubeLayout layout) {
  static constexpr std::array<CubeGrid, 4> kGrids = {{
      {4, 3, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}}},
      {3, 4, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3, true}}}},
      {6, 1, {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}}},
      {1, 6, {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}}},
  }};
  return kGrids[static_cast<std::size_t>(layout)];
}

std::optional<CubeLayout> CubeLayoutOf(int width, int height) {
  for (const CubeLayout layout :
       {CubeLayout::kHorizontalCross, CubeLayout::kVerticalCross, CubeLayout::kRow, CubeLayout::kColumn}) {
    const CubeGrid& grid = GridOf(layout);
    const int size = width / grid.columns;
    if (size > 0 && size * grid.columns == width && size * grid.rows == height) return layout;
  }
  return std::nullopt;
}

}  // namespace burin::image
