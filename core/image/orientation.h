// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/image.h"

namespace burin::image {

/// The picture the right way up, from how its rows and columns were stored: the Orientation tag of TIFF 6.0 and Exif,
/// 1 (as is) to 8; other values count as 1. 5 to 8 exchange width and height.
[[nodiscard]] Image Upright(Image image, int orientation);

}  // namespace burin::image
