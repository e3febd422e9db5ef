// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/image.h"

namespace burin::image {

/// The BT.709 luma of an 8-bit RGBA picture's values as stored, into `luma` (one channel, 8 bit; its storage is
/// reused). In 16-bit fixed point, rounded to nearest: within one step of the exact sum.
void LumaOfRgba8(const Image& rgba, Image& luma);

}  // namespace burin::image
