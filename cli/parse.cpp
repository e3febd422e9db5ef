// SPDX-License-Identifier: Apache-2.0
#include "cli/parse.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "fx_parser/source/diagnostic.h"

namespace burin::cli {
namespace {

/// One option of the table with what CLI11 found for it.
struct Bound {
  const OptionSpec* spec = nullptr;
  CLI::Option* option = nullptr;
  std::vector<std::string> values;
};

std::string Names(const OptionSpec& spec) {
  return spec.letter != 0 ? fmt::format("-{},--{}", spec.letter, spec.name) : fmt::format("--{}", spec.name);
}

std::unexpected<Error> UnknownOption(const CommandSpec& command, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  std::vector<std::string> near;
  for (const OptionSpec& spec : OptionTable()) {
    if ((spec.commands & command.bit) != 0) near.push_back(fmt::format("--{}", spec.name));
  }
  const std::string nearest = fx::NearestName(name, near);
  const std::string hint = !nearest.empty() ? fmt::format("did you mean {}?", nearest)
                                            : fmt::format("burin help {} lists the options", command.name);
  return Fail(ErrorKind::kUsage, fmt::format("burin {}: unknown option {}; {}", command.name, name, hint));
}

Result<void> CheckChoice(const OptionSpec& spec, const std::string& value) {
  std::string_view rest = spec.choices;
  while (!rest.empty()) {
    const std::size_t bar = rest.find('|');
    if (rest.substr(0, bar) == value) return {};
    rest = bar == std::string_view::npos ? std::string_view() : rest.substr(bar + 1);
  }
  return Fail(ErrorKind::kUsage, fmt::format("--{} {}: expected one of {}", spec.name, value, spec.choices));
}

Result<void> Apply(const Bound& bound, Settings& settings) {
  const OptionSpec& spec = *bound.spec;
  if (spec.value.empty()) {
    return bound.option->count() > 0 ? spec.apply(settings, "") : Result<void>();
  }
  const std::size_t first = spec.repeat == Repeat::kLast && !bound.values.empty() ? bound.values.size() - 1 : 0;
  for (std::size_t i = first; i < bound.values.size(); ++i) {
    if (!spec.choices.empty()) {
      if (auto good = CheckChoice(spec, bound.values[i]); !good) return good;
    }
    if (auto good = spec.apply(settings, bound.values[i]); !good) return good;
  }
  return {};
}

/// The option of a message of CLI11's such as "--size: 1 required TEXT missing"; null when it names none.
const OptionSpec* OptionIn(const CommandSpec& command, const std::string& message) {
  for (const OptionSpec& spec : OptionTable()) {
    if ((spec.commands & command.bit) == 0) continue;
    // "--NAME: ...", but "NAME was given a disallowed flag override".
    const std::size_t at = message.starts_with("--") ? 2 : 0;
    if (message.compare(at, spec.name.size(), spec.name) != 0) continue;
    const char next = at + spec.name.size() < message.size() ? message[at + spec.name.size()] : ' ';
    if (next == ':' || next == ' ') return &spec;
  }
  return nullptr;
}

std::unexpected<Error> Malformed(const CommandSpec& command, const CLI::ParseError& error) {
  const std::string message = error.what();
  if (const OptionSpec* spec = OptionIn(command, message)) {
    return Fail(ErrorKind::kUsage, spec->value.empty()
                                       ? fmt::format("burin {}: --{} takes no value", command.name, spec->name)
                                       : fmt::format("burin {}: --{} needs a value: --{} {}", command.name, spec->name,
                                                     spec->name, spec->value));
  }
  return Fail(ErrorKind::kUsage, fmt::format("burin {}: {}", command.name, message));
}

}  // namespace

Result<Settings> ParseArguments(const CommandSpec& command, std::span<const std::string> words) {
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  Settings settings;
  std::vector<Bound> bounds(OptionTable().size());
  std::size_t used = 0;
  for (const OptionSpec& spec : OptionTable()) {
    if ((spec.commands & command.bit) == 0) continue;
    Bound& bound = bounds[used++];
    bound.spec = &spec;
    bound.option = spec.value.empty() ? app.add_flag(Names(spec)) : app.add_option(Names(spec), bound.values);
    if (!spec.value.empty()) {
      bound.option->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    } else {
      bound.option->disable_flag_override();
    }
  }
  bounds.resize(used);
  try {
    std::vector<std::string> reversed(words.rbegin(), words.rend());  // as CLI11 takes them
    app.parse(std::move(reversed));
  } catch (const CLI::ParseError& error) {
    return Malformed(command, error);
  }
  bool options_ended = false;
  for (const std::string& word : app.remaining()) {
    if (!options_ended && word == "--") {
      options_ended = true;
      continue;
    }
    if (!options_ended && word.size() > 1 && word.front() == '-') return UnknownOption(command, word);
    settings.arguments.push_back(word);
  }
  for (const Bound& bound : bounds) {
    if (auto good = Apply(bound, settings); !good) return std::unexpected(good.error());
  }
  return settings;
}

}  // namespace burin::cli
