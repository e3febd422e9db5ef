// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/gl/handle.h"
#include "core/image/image.h"

namespace burin::effect {

/// A cube map with all its mipmaps from a picture of its faces (image::CubeLayoutOf). Errors: kInput when they lie in
/// none of these ways, kFailed over the device's limits; both without a name. Context's thread.
[[nodiscard]] Result<gl::TextureHandle> CubeTextureOf(const image::Image& picture, const std::string& label);

}  // namespace burin::effect
