// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

TEST(PreprocessorDirective, ReportsErrorAndStops) {
  const Preprocessed result = Preprocess("a\n#error don't \"do this\nb\n#error again");
  EXPECT_EQ(result.messages, "2:2 error: #error: don't \"do this [B1005]\n");
  EXPECT_EQ(Preprocess("#error\n").messages, "1:2 error: #error [B1005]\n");
}

TEST(PreprocessorDirective, WarnsAndGoesOn) {
  const Preprocessed result = Preprocess("#warning slow path\na");
  EXPECT_EQ(result.messages, "1:2 warning: #warning: slow path [B1006]\n");
  EXPECT_EQ(result.text, "a");
}

TEST(PreprocessorDirective, SuggestsNearDirectives) {
  EXPECT_EQ(Preprocess("#inlcude \"a\"\n#foobar\n#(\n").messages,
            "1:2 error: unknown directive '#inlcude'; did you mean '#include'? [B1004]\n"
            "2:2 error: unknown directive '#foobar' [B1004]\n"
            "3:2 error: expected a directive after '#', found '(' [B1004]\n");
}

TEST(PreprocessorDirective, TakesSpacesAroundTheHashAndEmptyDirectives) {
  EXPECT_EQ(Preprocess("  #  define A 1\n#\n/* c */ # /* d */ define B 2\nA B\n# 12 \"x.fx\"\nc").text, "1 2\nc");
}

TEST(PreprocessorDirective, LeavesAHashInTheMiddleOfALine) {
  EXPECT_EQ(Preprocess("a # define b").text, "a # define b");
}

TEST(PreprocessorDirective, IgnoresKnownPragmasAndWarnsOfOthers) {
  EXPECT_EQ(
      Preprocess("#pragma warning(disable : 3571)\n#pragma\n#pragma reshade showstatistics\n#pragma shiny\n").messages,
      "4:9 warning: 'shiny': unknown pragma ignored [X3568]\n");
}

TEST(PreprocessorDirective, ReportsAMalformedPackMatrix) {
  EXPECT_EQ(Preprocess("#pragma pack_matrix(diagonal)\n").messages,
            "1:2 error: expected #pragma pack_matrix(row_major) or (column_major) [B1004]\n");
}

TEST(PreprocessorDirective, ShowsTheLinesThatLineClaims) {
  const auto parsed = ParseText("#line 100 \"made.fx\"\nfloat a = ;\n#line 7\nfloat b = __LINE__ +;\n");
  EXPECT_EQ(parsed->Formatted(),
            "made.fx:100:11: error: expected an expression, found ';' [X3000]\n"
            "float a = ;\n"
            "          ^\n"
            "made.fx:7:21: error: expected an expression, found ';' [X3000]\n"
            "float b = __LINE__ +;\n"
            "                    ^\n");
  EXPECT_EQ(Preprocess("#line 100 \"made.fx\"\n__LINE__ __FILE__").text, "100 \"made.fx\"");
  EXPECT_EQ(Preprocess("#line x\n").messages,
            "1:2 error: expected a line number and perhaps a file name after #line [B1004]\n");
}

}  // namespace
}  // namespace burin::fx::test
