// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/effect/pass_program.h"
#include "core/effect/schedule.h"
#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// A step's own program, then those of its pass's choices.
using StepPrograms = std::vector<PassProgram>;

/// One for each step of the schedule, empty where it draws nothing; or why this device cannot run one of them (kInput).
/// Context's thread.
[[nodiscard]] Result<std::vector<StepPrograms>> CompilePrograms(const fx::Effect& effect, const Schedule& schedule);

}  // namespace burin::effect
