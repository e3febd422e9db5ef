// SPDX-License-Identifier: Apache-2.0
#include "cli/parse.h"

#include <gmock/gmock.h>

namespace burin::cli {
namespace {

using testing::ElementsAre;
using testing::Pair;

Settings Parsed(const std::string& command, const std::vector<std::string>& words) {
  auto settings = ParseArguments(*FindCommand(command), words);
  EXPECT_TRUE(settings) << (settings ? "" : settings.error().message);
  return settings.value_or(Settings());
}

std::string Refusal(const std::string& command, const std::vector<std::string>& words) {
  const auto settings = ParseArguments(*FindCommand(command), words);
  if (settings) return "accepted";
  EXPECT_EQ(settings.error().kind, ErrorKind::kUsage);
  return settings.error().message;
}

TEST(Parse, TakesARenderCommandApart) {
  const Settings settings =
      Parsed("render", {"a.fx",         "b.fx",  "scene.glb",  "-o",    "out.####.png", "--size", "64x48",
                        "--frames=1-3", "--fps", "30000/1001", "-Ione", "-I",           "two",    "-DX=2",
                        "--define",     "Y",     "--param",    "w=1,2", "--param",      "v=0",    "--keep-going"});
  EXPECT_THAT(settings.arguments, ElementsAre("a.fx", "b.fx", "scene.glb"));
  EXPECT_EQ(settings.job.output, "out.####.png");
  EXPECT_EQ(settings.job.size, std::pair(64, 48));
  EXPECT_THAT(settings.job.frames, ElementsAre(1, 2, 3));
  EXPECT_EQ(settings.job.fps->denominator, 1001);
  EXPECT_THAT(settings.job.include_folders, ElementsAre("one", "two"));
  EXPECT_THAT(settings.job.definitions, ElementsAre(Pair("X", "2"), Pair("Y", "1")));
  EXPECT_THAT(settings.job.parameters, ElementsAre(Pair("w", "1,2"), Pair("v", "0")));
  EXPECT_TRUE(settings.job.keep_going);
}

TEST(Parse, ADashIsAFileAndNegativeValuesAreValues) {
  const Settings settings = Parsed("render", {"e.fx", "-", "-o", "-", "--frames", "-3--1", "--orbit", "-45"});
  EXPECT_THAT(settings.arguments, ElementsAre("e.fx", "-"));
  EXPECT_EQ(settings.job.output, "-");
  EXPECT_THAT(settings.job.frames, ElementsAre(-3, -2, -1));
  EXPECT_EQ(settings.job.orbit_deg, -45.0);
}

TEST(Parse, WordsAfterTwoDashesAreNoOptions) {
  EXPECT_THAT(Parsed("render", {"-o", "a.png", "--", "-odd.png"}).arguments, ElementsAre("-odd.png"));
}

TEST(Parse, TheLastOfARepeatedOptionCounts) {
  EXPECT_EQ(Parsed("render", {"--size", "1x1", "--size", "2x2"}).job.size, std::pair(2, 2));
}

TEST(Parse, ThereIsOneSampleAPixelUnlessMoreAreAskedFor) {
  EXPECT_EQ(Parsed("render", {}).job.samples, 1);
  EXPECT_EQ(Parsed("render", {"--samples", "1"}).job.samples, 1);
  EXPECT_EQ(Parsed("render", {"--samples=4"}).job.samples, 4);
  EXPECT_EQ(Parsed("render", {"--samples", "16"}).job.samples, 16);
}

TEST(Parse, UnknownOptionsAreRefusedWithTheNearest) {
  EXPECT_EQ(Refusal("render", {"--sise", "1x1"}), "burin render: unknown option --sise; did you mean --size?");
  EXPECT_EQ(Refusal("render", {"--fames=1"}), "burin render: unknown option --fames; did you mean --frames?");
  EXPECT_EQ(Refusal("render", {"--zzzzzzzzzz"}),
            "burin render: unknown option --zzzzzzzzzz; burin help render lists the options");
  EXPECT_EQ(Refusal("check", {"--size", "1x1"}),
            "burin check: unknown option --size; burin help check lists the options");
  EXPECT_EQ(Refusal("render", {"-z"}), "burin render: unknown option -z; burin help render lists the options");
}

TEST(Parse, MissingAndSuperfluousValuesAreNamed) {
  EXPECT_EQ(Refusal("render", {"--size"}), "burin render: --size needs a value: --size WxH");
  EXPECT_EQ(Refusal("render", {"a.fx", "-o"}), "burin render: --output needs a value: --output FILE");
  EXPECT_EQ(Refusal("render", {"--mkdir=yes"}), "burin render: --mkdir takes no value");
}

TEST(Parse, MalformedValuesAreRefusedByOption) {
  EXPECT_EQ(Refusal("render", {"--size", "10"}),
            "--size 10: expected WIDTHxHEIGHT in pixels, both at least 1, such as 1920x1080");
  EXPECT_EQ(Refusal("render", {"--size", "0x10"}),
            "--size 0x10: expected WIDTHxHEIGHT in pixels, both at least 1, such as 1920x1080");
  EXPECT_EQ(Refusal("render", {"--size", "99999999999x1"}),
            "--size 99999999999x1: expected WIDTHxHEIGHT in pixels, both at least 1, such as 1920x1080");
  EXPECT_EQ(Refusal("render", {"--progress", "loud"}), "--progress loud: expected one of bar|plain|json|openjd|none");
  EXPECT_EQ(Refusal("render", {"--depth", "12"}), "--depth 12: expected one of 8|16|32");
  EXPECT_EQ(Refusal("render", {"--samples", "2"}), "--samples 2: expected one of 1|4|16");
  EXPECT_EQ(Refusal("render", {"--samples", "many"}), "--samples many: expected one of 1|4|16");
  EXPECT_EQ(Refusal("render", {"--quality", "101"}), "--quality 101: expected a whole number from 1 to 100");
  EXPECT_EQ(Refusal("render", {"--orbit", "nan"}), "--orbit nan: expected a number");
  EXPECT_EQ(Refusal("render", {"--param", "x"}), "--param x: expected NAME=VALUE");
  EXPECT_EQ(Refusal("render", {"--texture", "x"}), "--texture x: expected NAME=FILE");
  EXPECT_EQ(Refusal("render", {"--attributes", "a,,b"}), "--attributes a,,b: expected names separated by commas");
  EXPECT_EQ(Refusal("render", {"--fps", "0"}),
            "--fps 0: expected frames a second above 0 and at most 1000, such as 24, 23.976 or 30000/1001");
}

TEST(Parse, QuietTurnsProgressOffUnlessItWasAskedFor) {
  EXPECT_EQ(Parsed("render", {"-q"}).progress, ProgressMode::kNone);
  EXPECT_EQ(Parsed("render", {"-q", "--progress", "json"}).progress, ProgressMode::kJson);
  EXPECT_EQ(Parsed("render", {"-q"}).log_level, LogLevel::kError);
  EXPECT_EQ(Parsed("render", {"-v"}).log_level, LogLevel::kInfo);
}

TEST(OptionTable, NamesAndLettersAreUnique) {
  for (const OptionSpec& a : OptionTable()) {
    for (const OptionSpec& b : OptionTable()) {
      if (&a == &b || (a.commands & b.commands) == 0) continue;
      EXPECT_NE(a.name, b.name);
      EXPECT_TRUE(a.letter == 0 || a.letter != b.letter) << a.name << " " << b.name;
    }
  }
}

}  // namespace
}  // namespace burin::cli
