// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/image.h"

namespace burin::overdraw {

/// The share of a picture's pixels, 0..1, that lie within two pixels of one whose last channel is above 0. Two pixels
/// are two rows and two columns. `sums`: kF32 of four channels.
[[nodiscard]] float ShareNearEdges(const image::Image& sums);

}  // namespace burin::overdraw
