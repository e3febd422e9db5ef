// SPDX-License-Identifier: Apache-2.0
#include "cli/help.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace burin::cli {
namespace {

constexpr std::size_t kHelpColumn = 24;

std::string OptionHeading(const OptionSpec& spec) {
  std::string heading =
      spec.letter != 0 ? fmt::format("  -{}, --{}", spec.letter, spec.name) : fmt::format("      --{}", spec.name);
  if (!spec.value.empty()) heading += fmt::format(" {}", spec.value);
  return heading;
}

std::string OptionText(const OptionSpec& spec) {
  std::string text = OptionHeading(spec);
  if (text.size() + 2 > kHelpColumn) {
    text += '\n';
    text.append(kHelpColumn, ' ');
  } else {
    text.append(kHelpColumn - text.size(), ' ');
  }
  return text + Wrapped(spec.help, kHelpColumn) + "\n";
}

/// Headings in the order in which the table first names them.
std::vector<std::string_view> Groups(unsigned bit) {
  std::vector<std::string_view> groups;
  for (const OptionSpec& spec : OptionTable()) {
    if ((spec.commands & bit) == 0) continue;
    if (std::ranges::find(groups, spec.group) == groups.end()) groups.push_back(spec.group);
  }
  return groups;
}

}  // namespace

std::string Wrapped(std::string_view text, std::size_t indent, std::size_t width) {
  std::string out;
  std::size_t column = indent;
  bool line_start = true;
  const auto new_line = [&] {
    out += '\n';
    out.append(indent, ' ');
    column = indent;
    line_start = true;
  };
  while (!text.empty()) {
    const std::size_t end = text.find_first_of(" \n");
    const std::string_view word = text.substr(0, end);
    if (!line_start && column + 1 + word.size() > width) new_line();
    if (!line_start) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    line_start = false;
    if (end == std::string_view::npos) break;
    if (text[end] == '\n') new_line();
    text.remove_prefix(end + 1);
  }
  return out;
}

std::string OverviewText() {
  std::string text =
      "burin renders glTF scenes and filters images and videos, without a display, through\n"
      "extended DirectX 9 effect files that declare G-buffer attributes.\n\n"
      "Usage: burin COMMAND [OPTION ...] [FILE ...]\n\nCommands:\n";
  for (const CommandSpec& command : CommandTable()) {
    text += fmt::format("  {:<12}{}\n", command.name, command.summary);
  }
  text += "\nExamples:\n";
  for (const Example& example : CommandTable().front().examples.first(3)) {
    text += fmt::format("  {}\n", example.command);
  }
  text +=
      "\nburin help COMMAND tells about one command, burin --version its version.\n"
      "burin(1), burin-fx(7) and burin-attributes(7) are the manual.\n";
  return text;
}

std::string HelpText(const CommandSpec& command) {
  std::string text =
      fmt::format("Usage: burin {} [OPTION ...]{}{}\n\n{}\n", command.name, command.arguments.empty() ? "" : " ",
                  command.arguments, Wrapped(command.description, 0));
  for (const std::string_view group : Groups(command.bit)) {
    text += fmt::format("\n{}:\n", group);
    for (const OptionSpec& spec : OptionTable()) {
      if ((spec.commands & command.bit) != 0 && spec.group == group) text += OptionText(spec);
    }
  }
  text += "\nExamples:\n";
  for (const Example& example : command.examples) {
    text += fmt::format("  # {}\n  {}\n", example.purpose, example.command);
  }
  if (command.bit == kRender) {
    text +=
        "\nExit status: 0 done; 1 failed; 2 usage; 3 the effect, scene, image or video has\n"
        "errors; 4 no usable GL device; 128+n on signal n.\n";
  }
  return text;
}

}  // namespace burin::cli
