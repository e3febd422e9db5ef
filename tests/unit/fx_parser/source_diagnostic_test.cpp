// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fx_parser/source/diagnostic.h"

namespace burin::fx {
namespace {

// A set with one file, and a diagnostic on one line of it.
SourceSet OneFile(std::string text) {
  SourceSet sources;
  sources.files.push_back({"toon.fx", std::move(text), {}, {}});
  return sources;
}

Range On(std::uint32_t line, std::uint32_t begin, std::uint32_t end) { return {{0, line, begin, 0}, line, end}; }

std::string Format(std::string text, const Range& range) {
  return FormatDiagnostic({Severity::kError, range, "wrong", "X3000", {}}, OneFile(std::move(text)));
}

TEST(SourceDiagnostics, CountsErrorsAndKeepsOrder) {
  Diagnostics diagnostics;
  diagnostics.Warning({}, "B1", "first");
  EXPECT_FALSE(diagnostics.has_errors());
  diagnostics.Error({}, "B2", "second").notes.push_back({{}, "why"});
  EXPECT_EQ(diagnostics.error_count(), 1);
  ASSERT_EQ(diagnostics.all().size(), 2u);
  EXPECT_EQ(diagnostics.all()[1].notes[0].text, "why");
  EXPECT_EQ(diagnostics.Take().size(), 2u);
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_FALSE(diagnostics.has_errors());
}

TEST(SourceDiagnostics, DropsWhatComesAfterTwentyErrors) {
  Diagnostics diagnostics;
  for (int i = 0; i < 19; ++i) diagnostics.Error({}, "B1", "x");
  EXPECT_FALSE(diagnostics.exhausted());
  diagnostics.Error({}, "B1", "x");
  EXPECT_TRUE(diagnostics.exhausted());
  diagnostics.Error({}, "B1", "late").notes.push_back({{}, "lost"});
  diagnostics.Warning({}, "B1", "late");
  EXPECT_EQ(diagnostics.all().size(), 20u);
  EXPECT_TRUE(diagnostics.all().back().notes.empty());
}

TEST(SourceDiagnostics, KeepsAHundredWarnings) {
  Diagnostics diagnostics;
  for (int i = 0; i < 500; ++i) diagnostics.Warning({}, "B1", "x");
  EXPECT_EQ(diagnostics.all().size(), 100u);
  diagnostics.Error({}, "B1", "still");
  EXPECT_EQ(diagnostics.all().back().text, "still");
}

TEST(SourceFormatDiagnostic, UnderlinesTheRange) {
  EXPECT_EQ(Format("float a;\nfloat four = 4;\n", On(2, 7, 11)),
            "toon.fx:2:7: error: wrong [X3000]\nfloat four = 4;\n      ^~~~\n");
}

TEST(SourceFormatDiagnostic, KeepsTabsUnderTabs) {
  EXPECT_EQ(Format("\tif\t(x)", On(1, 5, 6)), "toon.fx:1:5: error: wrong [X3000]\n\tif\t(x)\n\t  \t^\n");
}

TEST(SourceFormatDiagnostic, PointsBehindTheEndOfALine) {
  EXPECT_EQ(Format("float a", On(1, 8, 9)), "toon.fx:1:8: error: wrong [X3000]\nfloat a\n       ^\n");
}

TEST(SourceFormatDiagnostic, UnderlinesToTheEndOfALineWhenTheRangeGoesOn) {
  EXPECT_EQ(Format("ab cd\nef", {{0, 1, 4, 0}, 2, 2}), "toon.fx:1:4: error: wrong [X3000]\nab cd\n   ^~\n");
}

TEST(SourceFormatDiagnostic, CountsOneCellForACharacterOfSeveralBytes) {
  EXPECT_EQ(Format("\"\xc3\xa9\xe6\xbc\xa2\" x", On(1, 9, 10)),
            "toon.fx:1:9: error: wrong [X3000]\n\"\xc3\xa9\xe6\xbc\xa2\" x\n     ^\n");
}

TEST(SourceFormatDiagnostic, ReplacesBytesThatAreNoText) {
  EXPECT_EQ(Format("a\x93\xfa\x1b[31m b", On(1, 10, 11)),
            "toon.fx:1:10: error: wrong [X3000]\na???[31m b\n         ^\n");
}

TEST(SourceFormatDiagnostic, KeepsControlCharactersFromTheTerminal) {
  SourceSet sources = OneFile("a");
  sources.files[0].path = "\033[2J.fx";
  EXPECT_EQ(FormatDiagnostic({Severity::kError, On(1, 1, 2), "name '\a\xc3\xa9\xc3'", "B1", {}}, sources),
            "?[2J.fx:1:1: error: name '?\xc3\xa9?' [B1]\na\n^\n");
}

TEST(SourceFormatDiagnostic, ShowsAWindowOfALongLine) {
  const std::string formatted = Format(std::string(5000, 'a') + "B" + std::string(5000, 'c'), On(1, 5001, 5002));
  EXPECT_EQ(formatted, "toon.fx:1:5001: error: wrong [X3000]\n..." + std::string(100, 'a') + "B" +
                           std::string(59, 'c') + "...\n" + std::string(103, ' ') + "^\n");
}

TEST(SourceFormatDiagnostic, PrintsWarningsNotesAndPlacelessMessages) {
  const SourceSet sources = OneFile("a\nb");
  EXPECT_EQ(FormatDiagnostic({Severity::kWarning, On(1, 1, 2), "odd", "", {{On(2, 1, 2), "because"}}}, sources),
            "toon.fx:1:1: warning: odd\na\n^\ntoon.fx:2:1: note: because\nb\n^\n");
  EXPECT_EQ(FormatDiagnostic({Severity::kNote, {}, "by the way", "", {}}, sources), "note: by the way\n");
}

TEST(SourceFormatDiagnostic, ShowsTheChainOfIncludes) {
  SourceSet sources = OneFile("#include \"a\"");
  sources.files.push_back({"a.fxh", "\n#include \"b\"", {0, 1, 2, 0}, {}});
  sources.files.push_back({"b.fxh", "oops", {1, 2, 2, 0}, {}});
  EXPECT_EQ(FormatDiagnostic({Severity::kError, {{2, 1, 1, 0}, 1, 5}, "wrong", "X3000", {}}, sources),
            "In file included from a.fxh:2,\n                 from toon.fx:1:\n"
            "b.fxh:1:1: error: wrong [X3000]\noops\n^~~~\n");
}

TEST(SourceFormatDiagnostic, ShowsTheMacrosFromTheInnermostOut) {
  SourceSet sources = OneFile("#define IN x\n#define OUT IN\nOUT");
  sources.expansions.push_back({"OUT", {0, 2, 13, 0}, 0});
  sources.expansions.push_back({"IN", {0, 1, 12, 0}, 1});
  EXPECT_EQ(FormatDiagnostic({Severity::kError, {{0, 3, 1, 2}, 3, 4}, "wrong", "X3000", {}}, sources),
            "toon.fx:3:1: error: wrong [X3000]\nOUT\n^~~\n"
            "toon.fx:1:12: note: in expansion of macro 'IN'\n#define IN x\n           ^\n"
            "toon.fx:2:13: note: in expansion of macro 'OUT'\n#define OUT IN\n            ^\n");
}

TEST(SourceFormatDiagnostic, SaysThatAMacroIsTheHosts) {
  SourceSet sources = OneFile("N");
  sources.expansions.push_back({"N", {}, 0});
  EXPECT_EQ(FormatDiagnostic({Severity::kError, {{0, 1, 1, 1}, 1, 2}, "wrong", "X3000", {}}, sources),
            "toon.fx:1:1: error: wrong [X3000]\nN\n^\nnote: in expansion of macro 'N' (defined by the host)\n");
}

TEST(SourceFormatDiagnostic, ColoursTheWord) {
  const std::string colored =
      FormatDiagnostic({Severity::kError, On(1, 1, 2), "wrong", "X3000", {}}, OneFile("a"), true);
  EXPECT_EQ(colored,
            "\033[1mtoon.fx:1:1:\033[0m \033[1;31merror:\033[0m \033[1mwrong [X3000]\033[0m\na\n\033[1;32m^\033[0m\n");
}

TEST(SourceFormatDiagnostic, SurvivesPlacesOutsideTheText) {
  EXPECT_EQ(Format("a", On(9, 40, 41)), "toon.fx:9:40: error: wrong [X3000]\n\n^\n");
  EXPECT_EQ(Format("a", {{7, 1, 1, 99}, 1, 2}), "error: wrong [X3000]\n");
}

TEST(SourceNearestName, FindsSlips) {
  const std::vector<std::string> names{"float3", "CullMode", "ZEnable", "normal"};
  EXPECT_EQ(NearestName("flaot3", names), "float3");
  EXPECT_EQ(NearestName("CulMode", names), "CullMode");
  EXPECT_EQ(NearestName("zenabel", names), "ZEnable");
  EXPECT_EQ(NearestName("NORMAL", names), "normal");
}

TEST(SourceNearestName, StaysSilentWhereNothingIsNear) {
  EXPECT_EQ(NearestName("teapot", {"float3", "normal"}), "");
  EXPECT_EQ(NearestName("x", {"y", "z"}), "");
  EXPECT_EQ(NearestName("ab", {"AB"}), "AB");
  EXPECT_EQ(NearestName("", {"", "a"}), "");
  EXPECT_EQ(NearestName(std::string(100000, 'a'), {std::string(100000, 'a')}), "");
}

TEST(SourceNearestName, PrefersTheNearer) { EXPECT_EQ(NearestName("tex2Dlad", {"tex2Dgrad", "tex2Dlod"}), "tex2Dlod"); }

}  // namespace
}  // namespace burin::fx
