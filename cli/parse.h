// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "cli/command_table.h"
#include "cli/settings.h"
#include "core/base/error.h"

namespace burin::cli {

/// Reads the words after the command's name by the option table. Nothing runs before every word is understood. Errors:
/// kUsage; an unknown option's message names the nearest that there is.
[[nodiscard]] Result<Settings> ParseArguments(const CommandSpec& command, std::span<const std::string> words);

}  // namespace burin::cli
