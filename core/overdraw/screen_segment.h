// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>

#include "core/overdraw/screen_projection.h"

namespace burin::overdraw {

/// The part of an edge that is in the picture.
struct ScreenSegment {
  ScreenPoint a, b;
  /// Where the ends lie on the edge, 0..1 as clip space has it, and clip space's w there.
  glm::vec2 range{0.0f, 1.0f};
  glm::vec2 w{1.0f};
};

/// Cuts the edge from `a` to `b` (clip space, reversed depth) at the near plane and at `margin` pixels round a picture
/// of `width` x `height` pixels. Nothing where no part of it is seen or it is not finite.
[[nodiscard]] std::optional<ScreenSegment> CutToPicture(const glm::vec4& a, const glm::vec4& b,
                                                        const Projection& projection, int width, int height,
                                                        float margin);

}  // namespace burin::overdraw
