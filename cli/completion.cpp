// SPDX-License-Identifier: Apache-2.0
#include "cli/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

#include "cli/command_table.h"

namespace burin::cli {
namespace {

std::string OptionWords(unsigned bit) {
  std::string words;
  for (const OptionSpec& spec : OptionTable()) {
    if ((spec.commands & bit) == 0) continue;
    words += fmt::format("{}--{}", words.empty() ? "" : " ", spec.name);
  }
  return words;
}

bool IsFolder(const OptionSpec& spec) { return spec.value == "FOLDER"; }
bool IsFile(const OptionSpec& spec) { return spec.value == "FILE" || spec.value == "CONFIG"; }

}  // namespace

std::string BashCompletion() {
  std::string commands;
  std::string option_cases;
  for (const CommandSpec& command : CommandTable()) {
    commands += fmt::format("{}{}", commands.empty() ? "" : " ", command.name);
    option_cases += fmt::format("    {}) options='{}' ;;\n", command.name, OptionWords(command.bit));
  }
  std::string value_cases;
  std::set<std::string_view> named;  // commands may have options of one name
  for (const OptionSpec& spec : OptionTable()) {
    if (spec.value.empty() || !named.insert(spec.name).second) continue;
    const std::string names =
        spec.letter != 0 ? fmt::format("--{}|-{}", spec.name, spec.letter) : fmt::format("--{}", spec.name);
    std::string choices(spec.choices);
    std::ranges::replace(choices, '|', ' ');
    const std::string reply = !choices.empty()
                                  ? fmt::format("mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$word\")", choices)
                              : IsFolder(spec) ? "mapfile -t COMPREPLY < <(compgen -d -- \"$word\")"
                              : IsFile(spec)   ? "mapfile -t COMPREPLY < <(compgen -f -- \"$word\")"
                                               : "COMPREPLY=()";
    value_cases += fmt::format("    {}) {}; return ;;\n", names, reply);
  }
  return fmt::format(
      "# bash completion for burin; load it with: source <(burin completion bash)\n"
      "_burin() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} options='' names=''\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W '{} --help --version' -- \"$word\")\n"
      "    return\n"
      "  fi\n"
      "  case $before in\n{}  esac\n"
      "  case ${{COMP_WORDS[1]}} in\n{}  esac\n"
      "  if [[ $word == -* ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$word\")\n"
      "    return\n"
      "  fi\n"
      "  case ${{COMP_WORDS[1]}} in\n"
      "    render|check|info) names=$(burin effects 2>/dev/null | cut -d' ' -f1) ;;\n"
      "    help) names='{}' ;;\n"
      "    completion) names=bash ;;\n"
      "  esac\n"
      "  mapfile -t COMPREPLY < <(compgen -W \"$names\" -- \"$word\"; compgen -f -- \"$word\")\n"
      "}}\n"
      "complete -o filenames -F _burin burin\n",
      commands, value_cases, option_cases, commands);
}

}  // namespace burin::cli
