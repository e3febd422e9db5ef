// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/effect/frame_context.h"
#include "fx_parser/effect/effect.h"
#include "fx_parser/fx_parser.h"

namespace burin::effect {

/// The numbers that a pass's fixed stages read (fx::FixedSlot): fx::kFixedSlots vec4s, one after the other. What the
/// pass's states do not say comes from the scene: its matrices, the object's material, and the key light where the pass
/// names no light.
[[nodiscard]] std::vector<float> FixedValues(const fx::Effect& effect, const fx::FixedFunction& fixed,
                                             const FrameContext& context, const fx::ParameterLookup& lookup);

}  // namespace burin::effect
