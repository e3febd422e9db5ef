// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "cli/command_table.h"

namespace burin::cli {

/// The list of commands: `burin help`.
[[nodiscard]] std::string OverviewText();
/// One command with its options by group and its examples: `burin help COMMAND`.
[[nodiscard]] std::string HelpText(const CommandSpec& command);
/// `text` in lines of at most `width` columns, each but the first after `indent` spaces; '\n' ends a paragraph.
[[nodiscard]] std::string Wrapped(std::string_view text, std::size_t indent, std::size_t width = 80);

}  // namespace burin::cli
