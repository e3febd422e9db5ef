// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace burin::image {

/// Takes the DateTime tag out of the first directory of a TIFF in memory and blanks its text, so that two runs give
/// the same bytes. Anything that is not a little-endian TIFF or BigTIFF with such a tag is left as it is.
void RemoveTiffDate(std::span<std::byte> file);

}  // namespace burin::image
