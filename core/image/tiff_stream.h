// SPDX-License-Identifier: Apache-2.0
#pragma once
// The structure of TIFF files in memory, where the libraries don't look closely enough.

#include <cstddef>
#include <span>

namespace burin::image {

/// False when the first directory, or pixel data that it points to, lies outside the file: a truncated TIFF, of which
/// OpenImageIO would hand over what there is. True for what is no TIFF.
[[nodiscard]] bool TiffIsWhole(std::span<const std::byte> file);

/// Takes the DateTime tag out of the first directory and blanks its text, so that two runs write the same bytes.
void RemoveTiffDate(std::span<std::byte> file);

}  // namespace burin::image
