// SPDX-License-Identifier: Apache-2.0
// TIFF 6.0, section "Orientation": where row 0 and column 0 of the stored data are seen.
#include "core/image/orientation.h"

#include <cstring>

#include "core/image/convert.h"

namespace burin::image {

Image Upright(Image image, int orientation) {
  if (orientation < 2 || orientation > 8) return image;
  const bool exchanged = orientation >= 5;
  // Of the upright picture's axes: is column (row) 0 at the far end of the stored axis that it runs along?
  const bool flip_x = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
  const bool flip_y = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
  const int width = exchanged ? image.height : image.width;
  const int height = exchanged ? image.width : image.height;
  Image upright = MakeImage(width, height, image.channels, image.type, image.encoding);
  const std::size_t pixel = static_cast<std::size_t>(image.channels) * SampleBytes(image.type);
  std::byte* target = upright.pixels.data();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, target += pixel) {
      const int u = flip_x ? width - 1 - x : x;
      const int v = flip_y ? height - 1 - y : y;
      const std::size_t source = static_cast<std::size_t>(exchanged ? u : v) * static_cast<std::size_t>(image.width) +
                                 static_cast<std::size_t>(exchanged ? v : u);
      std::memcpy(target, image.pixels.data() + source * pixel, pixel);
    }
  }
  return upright;
}

}  // namespace burin::image
