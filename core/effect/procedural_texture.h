// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"
#include "core/effect/parameter_values.h"
#include "core/gl/handle.h"
#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// Runs the function that fills a texture (its role is fx::ProceduralRole) for every texel of every slice or face, and
/// makes its mipmaps. `values`: parameters that the function reads, as they are now. Errors: kFailed, naming the
/// texture.
[[nodiscard]] Result<gl::TextureHandle> FillProceduralTexture(const fx::Effect& effect, std::size_t texture,
                                                              const ParameterValues& values);

}  // namespace burin::effect
