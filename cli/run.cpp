// SPDX-License-Identifier: Apache-2.0
#include "cli/run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <span>

#include "cli/command_table.h"
#include "cli/console.h"
#include "cli/help.h"
#include "cli/parse.h"
#include "fx_parser/source/diagnostic.h"

namespace burin::cli {
namespace {

int UnknownCommand(const std::string& word) {
  std::vector<std::string> names;
  for (const CommandSpec& command : CommandTable()) names.emplace_back(command.name);
  const std::string nearest = fx::NearestName(word, names);
  const std::string what = word.starts_with('-') ? "option" : "command";
  PrintError({ErrorKind::kUsage, fmt::format("unknown {} '{}'{}; burin help lists the commands", what, word,
                                             nearest.empty() ? "" : fmt::format(", did you mean {}?", nearest))});
  return kExitUsage;
}

int RunCommand(const CommandSpec& command, std::span<const std::string> words) {
  const auto settings = ParseArguments(command, words);
  if (!settings) {
    PrintError(settings.error());
    return ExitStatus(settings.error());
  }
  if (settings->help) return PrintData(HelpText(command));
  return command.run(*settings);
}

}  // namespace

int Run(const std::vector<std::string>& words) {
  if (words.empty()) {
    WriteText(STDERR_FILENO, OverviewText());
    return kExitUsage;
  }
  const std::span<const std::string> rest = std::span(words).subspan(1);
  if (words.front() == "--version" || words.front() == "-V") return RunCommand(*FindCommand("version"), rest);
  if (words.front() == "--help" || words.front() == "-h") return RunCommand(*FindCommand("help"), rest);
  const CommandSpec* const command = FindCommand(words.front());
  return command != nullptr ? RunCommand(*command, rest) : UnknownCommand(words.front());
}

}  // namespace burin::cli
