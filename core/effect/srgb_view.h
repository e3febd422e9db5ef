// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "core/base/error.h"
#include "core/gl/handle.h"
#include "core/gl/texture.h"

namespace burin::effect {

/// The same pixels, decoded from sRGB when read and encoded when drawn to with SRGBWriteEnable. Empty where the format has
/// no such view (only those of 8 bits and three or four components have).
[[nodiscard]] gl::TextureHandle CreateSrgbView(const gl::Texture& texture);

/// A framebuffer over views and textures by their GL names; 0 for `depth_stencil`: none.
[[nodiscard]] Result<gl::FramebufferHandle> CreateFramebuffer(std::span<const std::uint32_t> colors,
                                                              std::uint32_t depth_stencil, std::string_view label);

}  // namespace burin::effect
