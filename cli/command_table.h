// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "cli/option_table.h"
#include "cli/settings.h"
#include "core/base/error.h"

namespace burin::cli {

struct Example {
  std::string_view command;
  std::string_view purpose;
};

struct CommandSpec {
  std::string_view name;
  CommandBit bit;
  std::string_view arguments;    ///< as the usage line shows them: "[EFFECT.fx ...] [SOURCE] -o OUT"
  std::string_view summary;      ///< one line, for the list of commands
  std::string_view description;  ///< paragraphs, separated by '\n', wrapped where they are shown
  std::span<const Example> examples;
  int (*run)(const Settings&);  ///< the exit status
};

[[nodiscard]] std::span<const CommandSpec> CommandTable();
/// Null when there is none of this name.
[[nodiscard]] const CommandSpec* FindCommand(std::string_view name);

// One file each, command_<name>.cpp.
int RunRender(const Settings& settings);
int RunCheck(const Settings& settings);
int RunTessellate(const Settings& settings);
int RunInfo(const Settings& settings);
int RunEffects(const Settings& settings);
int RunHelp(const Settings& settings);
int RunVersion(const Settings& settings);
int RunCompletion(const Settings& settings);

}  // namespace burin::cli
