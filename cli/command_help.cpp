// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/command_table.h"
#include "cli/console.h"
#include "cli/help.h"
#include "fx_parser/source/diagnostic.h"

namespace burin::cli {

int RunHelp(const Settings& settings) {
  if (settings.arguments.empty()) return PrintData(OverviewText());
  const std::string& name = settings.arguments.front();
  if (const CommandSpec* command = FindCommand(name)) return PrintData(HelpText(*command));
  std::vector<std::string> names;
  for (const CommandSpec& command : CommandTable()) names.emplace_back(command.name);
  const std::string nearest = fx::NearestName(name, names);
  PrintError({ErrorKind::kUsage, fmt::format("burin help: no command '{}'{}", name,
                                             nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest))});
  return kExitUsage;
}

}  // namespace burin::cli
