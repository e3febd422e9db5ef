// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/effect/schedule.h"

namespace burin::effect {

/// The steps of a technique's script, its loops unrolled, with their targets, clears and depth-stencil buffers.
/// `schedule.texture_sizes` must be filled in.
void AddScriptSteps(const fx::Effect& effect, const std::vector<std::size_t>& techniques, glm::ivec2 frame,
                    const ScheduleOptions& options, Schedule& schedule);

}  // namespace burin::effect
