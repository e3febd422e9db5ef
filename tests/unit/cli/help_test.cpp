// SPDX-License-Identifier: Apache-2.0
#include "cli/help.h"

#include <gmock/gmock.h>

#include <sstream>

#include "cli/completion.h"

namespace burin::cli {
namespace {

using testing::HasSubstr;

TEST(Help, TheOverviewListsEveryCommand) {
  const std::string text = OverviewText();
  for (const CommandSpec& command : CommandTable()) {
    EXPECT_THAT(text, HasSubstr("  " + std::string(command.name))) << command.name;
    EXPECT_THAT(text, HasSubstr(std::string(command.summary)));
  }
}

TEST(Help, ACommandShowsUsageOptionsAndExamples) {
  const std::string text = HelpText(*FindCommand("render"));
  EXPECT_THAT(text, testing::StartsWith("Usage: burin render [OPTION ...] [EFFECT.fx ...] [SOURCE] -o OUT\n"));
  EXPECT_THAT(text, HasSubstr("\nOutput:\n  -o, --output FILE     Where the result goes;"));
  EXPECT_THAT(text, HasSubstr("\n      --size WxH        Size of the frame in pixels."));
  EXPECT_THAT(text, HasSubstr("\nExamples:\n  # a scene through a shipped effect\n  burin render edges/dilated_edges"));
  EXPECT_THAT(text, HasSubstr("\nExit status: 0 done; 1 failed; 2 usage;"));
}

TEST(Help, ACommandShowsItsOwnOptionsOnly) {
  const std::string text = HelpText(*FindCommand("check"));
  EXPECT_THAT(text, HasSubstr("--include"));
  EXPECT_THAT(text, testing::Not(HasSubstr("--size")));
}

TEST(Help, FitsIn80Columns) {
  for (const CommandSpec& command : CommandTable()) {
    std::istringstream lines(HelpText(command));
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("  ffmpeg") || line.starts_with("  burin")) continue;  // examples are not broken
      EXPECT_LE(line.size(), 80u) << line;
    }
  }
}

TEST(Wrapped, BreaksBetweenWordsOnly) {
  EXPECT_EQ(Wrapped("one two three", 2, 9), "one two\n  three");
  EXPECT_EQ(Wrapped("a\nb", 0, 80), "a\nb");
  EXPECT_EQ(Wrapped("unbreakable", 0, 4), "unbreakable");
}

TEST(Completion, KnowsCommandsOptionsAndChoices) {
  const std::string script = BashCompletion();
  EXPECT_THAT(script,
              HasSubstr("compgen -W 'render check info tessellate effects version help completion --help --version'"));
  EXPECT_THAT(script, HasSubstr("--progress) mapfile -t COMPREPLY < <(compgen -W 'bar plain json openjd none'"));
  EXPECT_THAT(script, HasSubstr("--output|-o) mapfile -t COMPREPLY < <(compgen -f"));
}

}  // namespace
}  // namespace burin::cli
