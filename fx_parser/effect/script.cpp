// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/script.h"

#include <algorithm>

#include "fx_parser/effect/case.h"

namespace burin::fx {
namespace {

struct VerbName {
  std::string_view name;
  ScriptVerb verb;
};
constexpr VerbName kVerbs[] = {{"Technique", ScriptVerb::kTechnique},
                               {"Pass", ScriptVerb::kPass},
                               {"Draw", ScriptVerb::kDraw},
                               {"RenderColorTarget", ScriptVerb::kColorTarget},
                               {"RenderDepthStencilTarget", ScriptVerb::kDepthStencilTarget},
                               {"RenderDepthTarget", ScriptVerb::kDepthStencilTarget},
                               {"Clear", ScriptVerb::kClear},
                               {"ClearSetColor", ScriptVerb::kClearSetColor},
                               {"ClearSetDepth", ScriptVerb::kClearSetDepth},
                               {"ClearSetStencil", ScriptVerb::kClearSetStencil},
                               {"ScriptExternal", ScriptVerb::kExternal},
                               {"LoopByCount", ScriptVerb::kLoopByCount},
                               {"LoopGetIndex", ScriptVerb::kLoopGetIndex},
                               {"LoopEnd", ScriptVerb::kLoopEnd},
                               {"RenderPort", ScriptVerb::kRenderPort},
                               {"ScriptSignature", ScriptVerb::kSignature}};

std::string_view Trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n\f\v";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

ScriptCommand ParseCommand(std::string_view text) {
  const std::size_t equals = text.find('=');
  ScriptCommand command;
  command.name = Trimmed(text.substr(0, equals));
  if (equals != std::string_view::npos) command.value = Trimmed(text.substr(equals + 1));
  std::string_view name = command.name;
  const bool is_target = name.size() > 1 && EqualsIgnoringCase(name.substr(0, name.size() - 1), "RenderColorTarget");
  if (is_target && name.back() >= '0' && name.back() <= '7') {
    command.index = name.back() - '0';
    name.remove_suffix(1);
  }
  const auto found =
      std::ranges::find_if(kVerbs, [&](const VerbName& verb) { return EqualsIgnoringCase(verb.name, name); });
  if (found != std::end(kVerbs)) command.verb = found->verb;
  return command;
}

}  // namespace

std::vector<ScriptCommand> ParseScript(std::string_view text) {
  std::vector<ScriptCommand> commands;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    const std::string_view command = Trimmed(text.substr(0, end));
    if (!command.empty()) commands.push_back(ParseCommand(command));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return commands;
}

std::vector<std::string> ScriptCommandNames() {
  std::vector<std::string> names;
  for (const VerbName& verb : kVerbs) names.emplace_back(verb.name);
  return names;
}

std::vector<std::string> ScriptChoices(std::string_view value) {
  if (const std::size_t label = value.find('?'); label != std::string_view::npos) value.remove_prefix(label + 1);
  std::vector<std::string> choices;
  while (!value.empty()) {
    const std::size_t end = std::min(value.find(':'), value.size());
    if (const std::string_view choice = Trimmed(value.substr(0, end)); !choice.empty()) choices.emplace_back(choice);
    value.remove_prefix(std::min(end + 1, value.size()));
  }
  return choices;
}

}  // namespace burin::fx
