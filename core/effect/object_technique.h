// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/effect/frame_context.h"
#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// Files for MikuMikuEffect say by annotations of their techniques which objects each draws: MMDPass, UseTexture,
/// UseSphereMap, UseToon, Subset. These are the techniques that draw objects as they are seen, in the file's order,
/// those with self-shadow only where there are no others; empty when the file says nothing of the kind. What draws
/// edges, ground shadows and depth alone is not among them.
[[nodiscard]] std::vector<std::size_t> ObjectTechniques(const fx::Effect& effect);

/// Whether the technique is for an object of this material. A scene's objects have neither sphere maps nor toon
/// textures.
[[nodiscard]] bool Draws(const fx::Technique& technique, const MaterialContext& material);

}  // namespace burin::effect
