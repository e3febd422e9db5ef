// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "core/base/error.h"
#include "core/image/image_module.h"

namespace burin::image {

/// PNG, JPEG, TIFF and Radiance through OpenImageIO; the caller has asked CheckWritable.
[[nodiscard]] Result<void> WriteWithOiio(const std::string& path, const Image& image, const WriteOptions& options);

/// OpenEXR through its own library: one scanline part, ZIP compression, per-channel types.
[[nodiscard]] Result<void> WriteExr(const std::string& path, std::span<const Layer> layers,
                                    const WriteOptions& options);

}  // namespace burin::image
