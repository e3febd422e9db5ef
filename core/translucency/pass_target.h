// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "core/base/error.h"
#include "core/gl/handle.h"
#include "core/gl/texture.h"

namespace burin::translucency {

/// Textures that a pass draws into and later ones read texel by texel.
[[nodiscard]] Result<gl::Texture> CreateDepthTexture(int width, int height, std::string_view label);
[[nodiscard]] Result<gl::Texture> CreateFloatTexture(int width, int height, std::string_view label);
[[nodiscard]] Result<gl::Texture> CreateBitsTexture(int width, int height, std::string_view label);  ///< RGBA32UI

/// A framebuffer on them; null ones are left out.
[[nodiscard]] gl::FramebufferHandle CreateTarget(std::array<const gl::Texture*, 2> colors, const gl::Texture* depth,
                                                 std::string_view label);

/// Binds a texture for texelFetch.
void BindForFetch(unsigned unit, const gl::Texture& texture);

}  // namespace burin::translucency
