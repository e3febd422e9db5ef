// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace burin::image {

/// True when a JPEG stream runs through to its end-of-image marker. libjpeg fills what is missing with grey and goes
/// on, so a truncated file has to be found here. Bytes after the marker are allowed.
[[nodiscard]] bool ReachesJpegEnd(std::span<const std::byte> file);

}  // namespace burin::image
