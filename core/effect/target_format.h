// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/gl/format.h"
#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// How a render target of `format` is held. Formats whose components GL cannot draw to in place (A8 keeps the shader's
/// alpha, A8L8 its red and alpha) and those that GL need not render to (B16G16R16) are held in four components; the
/// swizzle makes every one read as Direct3D 9 reads it.
[[nodiscard]] gl::Format TargetFormat(fx::Format format);

/// False when the format has no alpha of its own: then the held alpha is cleared to 1 and never written, so that
/// DestAlpha blends as in Direct3D 9.
[[nodiscard]] bool HasAlpha(fx::Format format);

/// What a target is cleared with: its annotation ClearColor, else transparent black; opaque where it has no alpha.
[[nodiscard]] std::array<float, 4> ClearColor(const fx::Texture& texture);

}  // namespace burin::effect
