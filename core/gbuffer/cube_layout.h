// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "core/gbuffer/environment.h"

namespace burin::gbuffer {

/// How the six faces of a cube lie in a picture.
enum class CubeLayout : std::uint8_t {
  kHorizontalCross,  ///< 4 x 3 faces: left, front, right and back in a row, top and bottom over and under the front
  kVerticalCross,    ///< 3 x 4: as above, the back upside down under the bottom
  kRow,              ///< 6 x 1: right, left, top, bottom, front, back, as cube maps have them
  kColumn,           ///< 1 x 6
};

/// By the picture's proportions; equirectangular maps (2 x 1) have none of these.
[[nodiscard]] std::optional<CubeLayout> CubeLayoutOf(int width, int height);

/// The same surroundings as an equirectangular map four faces wide. The front is what a camera at rest looks at, -z.
[[nodiscard]] EnvironmentMap EquirectangularOf(const EnvironmentMap& faces, CubeLayout layout);

}  // namespace burin::gbuffer
