// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which image files burin writes and what each can hold. Plain tables: no module is loaded to ask.

#include <string>

#include "core/base/error.h"
#include "core/image/image.h"

namespace burin::image {

/// True for the extensions of still images that burin reads or writes (.png .jpg .tif .exr .hdr .bmp .tga ...).
[[nodiscard]] bool IsImagePath(const std::string& path);

/// kUsage with the reason and the alternatives when the extension is unknown or its format can't hold such samples.
/// 1 to 4 channels; JPEG and Radiance HDR drop alpha, and Radiance and TIFF store halves as floats, without loss.
[[nodiscard]] Result<void> CheckWritable(const std::string& path, SampleType type, int channels);

}  // namespace burin::image
