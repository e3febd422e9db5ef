// SPDX-License-Identifier: Apache-2.0
#pragma once
// The one table of options: parsing, --help, shell completion and the test of the manual pages all follow it.

#include <span>
#include <string>
#include <string_view>

#include "cli/settings.h"
#include "core/base/error.h"

namespace burin::cli {

/// Commands as bits, for OptionSpec::commands.
enum CommandBit : unsigned {
  kRender = 1u << 0,
  kCheck = 1u << 1,
  kInfo = 1u << 2,
  kEffects = 1u << 3,
  kVersion = 1u << 4,
  kHelp = 1u << 5,
  kCompletion = 1u << 6,
  kTessellate = 1u << 7,
};

enum class Repeat { kLast, kCollect };  ///< what a second use does: replaces the first, or adds to it

struct OptionSpec {
  std::string_view name;     ///< without the dashes; once a command
  char letter;               ///< short form, 0: none
  std::string_view value;    ///< "WxH"; empty: the option takes none
  unsigned commands;         ///< of CommandBit
  std::string_view group;    ///< heading in --help
  std::string_view help;     ///< sentences; wrapped where they are shown
  std::string_view choices;  ///< "bar|plain|json": what the value may be; empty: free
  Repeat repeat;
  /// Stores the value (empty for an option without one). Errors: kUsage, naming the option and what was expected.
  Result<void> (*apply)(Settings&, const std::string& value);
};

[[nodiscard]] std::span<const OptionSpec> OptionTable();

}  // namespace burin::cli
