// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace burin::image {

/// How the six faces of a cube lie in a picture.
enum class CubeLayout : std::uint8_t {
  kHorizontalCross,  ///< 4 x 3 faces: left, front, right and back in a row, top and bottom over and under the front
  kVerticalCross,    ///< 3 x 4: as above, the back upside down under the bottom
  kRow,              ///< 6 x 1: right, left, top, bottom, front, back, as cube maps have them
  kColumn,           ///< 1 x 6; so are .dds cubes read
};

/// By the picture's proportions; equirectangular maps (2 x 1) have none of these.
[[nodiscard]] std::optional<CubeLayout> CubeLayoutOf(int width, int height);

/// In faces, from the picture's top left corner.
struct FacePlace {
  int column = 0, row = 0;
  bool is_turned = false;  ///< upside down: by half a turn
};
struct CubeGrid {
  int columns = 1, rows = 1;
  std::array<FacePlace, 6> faces;  ///< in GL's and Direct3D's order: +x -x +y -y +z -z
};
[[nodiscard]] const CubeGrid& GridOf(CubeLayout layout);

}  // namespace burin::image
