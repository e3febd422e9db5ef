// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "core/base/error.h"
#include "core/gl/texture.h"
#include "core/image/image.h"

namespace burin::gbuffer {

/// A material's image with its mipmaps. `is_color`: display-encoded images are decoded by the sRGB transfer function,
/// so that look-ups give scene-linear light and filter in it. An empty image becomes one white texel.
[[nodiscard]] Result<gl::Texture> UploadMaterialTexture(const image::Image& image, bool is_color,
                                                        std::string_view label);

}  // namespace burin::gbuffer
