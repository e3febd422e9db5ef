// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

std::string Kept(const std::string& text) {
  const Preprocessed result = Preprocess(text);
  return result.messages.empty() ? result.text : result.messages;
}

// "yes" or "no", or the messages.
std::string If(const std::string& condition) { return Kept("#if " + condition + "\nyes\n#else\nno\n#endif\n"); }

TEST(PreprocessorCondition, ComparesAndCalculates) {
  EXPECT_EQ(If("DIRECT3D_VERSION >= 0xa00"), "no");
  EXPECT_EQ(If("1 + 2 * 3 == 7 && 7 / 2 == 3 && 7 % 2 == 1 && -7 / 2 == -3"), "yes");
  EXPECT_EQ(If("(1 << 4) == 16 && (256 >> 4) == 0x10 && (6 & 3) == 2 && (6 | 3) == 7 && (6 ^ 3) == 5 && ~0 == -1"),
            "yes");
  EXPECT_EQ(If("1 < 2 && 2 <= 2 && 3 > 2 && 3 >= 3 && 1 != 2"), "yes");
  EXPECT_EQ(If("!1 || +0 || -0"), "no");
  EXPECT_EQ(If("1 ? 0 : 1"), "no");
  EXPECT_EQ(If("0 ? 1 : 0 ? 1 : 2"), "yes");
  EXPECT_EQ(If("10u == 012 && 012 == 10"), "yes");
}

TEST(PreprocessorCondition, WrapsInsteadOfOverflowing) {
  EXPECT_EQ(If("0x7FFFFFFFFFFFFFFF + 1 < 0"), "yes");
  EXPECT_EQ(If("(-0x7FFFFFFFFFFFFFFF - 1) / -1 < 0"), "yes");
  EXPECT_EQ(If("1 << 64 == 0 && 1 << -1 == 0"), "yes");
}

TEST(PreprocessorCondition, TakesUnknownNamesAsZeroAndTrueAsOne) {
  EXPECT_EQ(If("FOO"), "no");
  EXPECT_EQ(If("true && !false"), "yes");
}

TEST(PreprocessorCondition, KnowsDefined) {
  EXPECT_EQ(If("defined BURIN && defined(BURIN) && !defined(FOO)"), "yes");
  EXPECT_EQ(Kept("#define HAS defined(BURIN)\n#if HAS\nyes\n#endif"), "yes");
  EXPECT_EQ(Kept("#define A B\n#if defined(A) && !defined(B)\nyes\n#endif"), "yes");
}

TEST(PreprocessorCondition, ExpandsMacros) {
  EXPECT_EQ(Kept("#define V(x) (x > 3)\n#define N 4\n#if V(N)\nyes\n#endif"), "yes");
}

TEST(PreprocessorCondition, DoesNotDivideWhereItNeedNotLook) {
  EXPECT_EQ(If("0 && 1 / 0"), "no");
  EXPECT_EQ(If("1 || 1 % 0"), "yes");
  EXPECT_EQ(If("1 ? 2 : 1 / 0"), "yes");
}

TEST(PreprocessorCondition, ReportsFaultyExpressions) {
  EXPECT_EQ(Preprocess("#if 1 / 0\n#endif").messages, "1:7 error: division by zero in a condition [B1007]\n");
  EXPECT_EQ(Preprocess("#if\n#endif").messages, "1:2 error: #if has no expression [B1007]\n");
  EXPECT_EQ(Preprocess("#if 1 +\n#endif").messages, "1:2 error: #if: the expression ends too early [B1007]\n");
  EXPECT_EQ(Preprocess("#if (1\n#endif").messages, "1:2 error: expected ')' in a condition [B1007]\n");
  EXPECT_EQ(Preprocess("#if 1 2\n#endif").messages, "1:7 error: unexpected '2' in a condition [B1007]\n");
  EXPECT_EQ(Preprocess("#if 1.5 > 1\n#endif").messages,
            "1:5 warning: a condition takes whole numbers: '1.5' counts as 1 [B1007]\n");
  EXPECT_EQ(Preprocess("#if defined\n#endif").messages, "1:5 error: expected a macro name after 'defined' [B1007]\n");
  EXPECT_EQ(Preprocess("#if \"a\"\n#endif").messages, "1:5 error: unexpected \"a\" in a condition [B1007]\n");
  EXPECT_EQ(Preprocess("#if 1 ? 2\n#endif").messages, "1:2 error: expected ':' in a condition [B1007]\n");
}

TEST(PreprocessorCondition, TakesTheFirstGroupThatHolds) {
  const std::string text = "#if N == 1\none\n#elif N == 2\ntwo\n#elif N >= 2\nmany\n#else\nnone\n#endif\n";
  EXPECT_EQ(Kept("#define N 1\n" + text), "one");
  EXPECT_EQ(Kept("#define N 2\n" + text), "two");
  EXPECT_EQ(Kept("#define N 3\n" + text), "many");
  EXPECT_EQ(Kept(text), "none");
}

TEST(PreprocessorCondition, NestsGroups) {
  EXPECT_EQ(Kept("#ifdef BURIN\n#ifndef FOO\na\n#else\nb\n#endif\n#else\n#if 1\nc\n#endif\nd\n#endif\ne"), "a\ne");
}

TEST(PreprocessorCondition, LooksAtNothingInSkippedGroups) {
  EXPECT_EQ(
      Kept("#if 0\n#include \"none\"\n#error no\n#foo\n#if 1 +\n#elif (\n#endif\n\"open ' @ 2D\n#else\nok\n#endif"),
      "ok");
  EXPECT_EQ(Kept("#if 1\nok\n#elif 1 / 0\n#endif"), "ok");
}

TEST(PreprocessorCondition, ToleratesTextAfterEndif) {
  EXPECT_EQ(Kept("#ifdef BURIN // yes\nok\n#endif BURIN\n#ifdef BURIN x\nok\n#endif"), "ok\nok");
}

TEST(PreprocessorCondition, ReportsUnbalancedGroups) {
  EXPECT_EQ(Preprocess("#if 1\n#ifdef A\n#endif\n").messages, "1:2 error: #if without #endif [B1008]\n");
  EXPECT_EQ(Preprocess("#endif\n#else\n#elif 1\n").messages,
            "1:2 error: #endif without #if [B1008]\n2:2 error: #else without #if [B1008]\n3:2 error: #elif without #if "
            "[B1008]\n");
  EXPECT_EQ(Preprocess("#if 1\n#else\n#else\n#elif 1\n#endif").messages,
            "3:2 error: a second #else [B1008]\n  1:2 the group begins here\n"
            "4:2 error: #elif after #else [B1008]\n  1:2 the group begins here\n");
}

TEST(PreprocessorCondition, BalancesGroupsWithinEachFile) {
  const Preprocessed result =
      Preprocess({{"main.fx", "#if 1\n#include \"a.fxh\"\n#endif\nx"}, {"a.fxh", "#endif\n#ifdef BURIN\n"}});
  EXPECT_EQ(result.messages,
            "a.fxh:1:2 error: #endif without #if [B1008]\na.fxh:2:2 error: #ifdef without #endif [B1008]\n");
  EXPECT_EQ(result.text, "x");
}

}  // namespace
}  // namespace burin::fx::test
