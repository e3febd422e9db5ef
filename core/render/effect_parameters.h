// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "fx_parser/effect/effect.h"

namespace burin::render {

using Assignments = std::vector<std::pair<std::string, std::string>>;

/// Gives each effect of a chain the assignments whose names it declares. The name of a file for a texture is taken
/// relative to the working folder when it is there. Errors: kUsage for a name that no effect declares, with the
/// nearest.
[[nodiscard]] Result<std::vector<Assignments>> ShareParameters(
    std::span<const std::shared_ptr<const fx::Effect>> effects, const Assignments& assignments);

/// The technique that --technique means for each effect: `wanted` where it is declared, else empty. Errors: kUsage when
/// no effect has it.
[[nodiscard]] Result<std::vector<std::string>> ShareTechnique(
    std::span<const std::shared_ptr<const fx::Effect>> effects, const std::string& wanted);

}  // namespace burin::render
