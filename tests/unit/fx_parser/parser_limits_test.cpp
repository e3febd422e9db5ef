// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

constexpr int kHuge = 20000;

std::string Repeat(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

// The codes of all messages, in order.
std::string Codes(const std::string& text) {
  const auto parsed = ParseText(text);
  std::string codes;
  for (const Diagnostic& diagnostic : parsed->diagnostics.all()) codes += diagnostic.code + " ";
  return codes;
}

TEST(ParserLimits, TakesNestingUpToTheLimit) {
  const int depth = kMaxNesting - 2;
  EXPECT_EQ(Codes("float x = " + Repeat("(", depth) + "1" + Repeat(")", depth) + ";"), "");
  EXPECT_EQ(Codes("void f() { " + Repeat("{", depth - 1) + Repeat("}", depth - 1) + "}"), "");
}

TEST(ParserLimits, RefusesDeepNestingOfEveryKind) {
  EXPECT_EQ(Codes("float x = " + Repeat("(", kHuge) + "1" + Repeat(")", kHuge) + ";"), "B1201 ");
  EXPECT_EQ(Codes("float x = " + Repeat("-", kHuge) + "1;"), "B1201 ");
  EXPECT_EQ(Codes("float x = " + Repeat("- ", kHuge) + "1;"), "B1201 ");
  EXPECT_EQ(Codes("float x = " + Repeat("{", kHuge) + Repeat("}", kHuge) + ";"), "B1201 ");
  EXPECT_EQ(Codes("float x = " + Repeat("a[", kHuge) + "1" + Repeat("]", kHuge) + ";"), "B1201 ");
  EXPECT_EQ(Codes("float x = " + Repeat("f(", kHuge) + "1" + Repeat(")", kHuge) + ";"), "B1201 ");
  EXPECT_EQ(Codes("float x = " + Repeat("a ? b : ", kHuge) + "1;"), "B1201 ");
  EXPECT_EQ(Codes("float x = " + Repeat("a ? ", kHuge) + "1;"), "B1201 ");
  EXPECT_EQ(Codes("float x = " + Repeat("(float)", kHuge) + "1;"), "B1201 ");
  EXPECT_EQ(Codes("float x = " + Repeat("a = ", kHuge) + "1;"), "B1201 ");
  EXPECT_EQ(Codes("void f() { " + Repeat("{", kHuge) + Repeat("}", kHuge) + "}").substr(0, 6), "B1201 ");
  EXPECT_EQ(Codes("void f() { " + Repeat("if (a) ", kHuge) + ";}").substr(0, 6), "B1201 ");
  EXPECT_EQ(Codes("void f() { " + Repeat("if (a) ; else ", kHuge) + ";}").substr(0, 6), "B1201 ");
  EXPECT_EQ(Codes("void f() { " + Repeat("do ", kHuge) + ";}").substr(0, 6), "B1201 ");
  EXPECT_EQ(Codes("void f() { " + Repeat("switch (a) { case 1: ", kHuge) + Repeat("}", kHuge) + "}").substr(0, 6),
            "B1201 ");
  EXPECT_EQ(Codes(Repeat("struct { ", kHuge) + Repeat("};", kHuge)).substr(0, 6), "B1201 ");
  EXPECT_EQ(Codes(Repeat("namespace a { ", kHuge)).substr(0, 6), "B1201 ");
  EXPECT_EQ(Codes("float x = " + Repeat("compile a f(", kHuge) + ";"), "B1201 ");
  EXPECT_EQ(Codes("sampler x = " + Repeat("sampler_state { a = ", kHuge) + ";").substr(0, 6), "B1201 ");
  EXPECT_EQ(Codes("string s = " + Repeat("\"a\" (", kHuge) + "\"b\";"), "B1201 ");
}

TEST(ParserLimits, RefusesExpressionsThatMakeHighTrees) {
  EXPECT_EQ(Codes("float x = 1" + Repeat(" + 1", kMaxExpressionHeight - 1) + ";"), "");
  EXPECT_EQ(Codes("float x = 1" + Repeat(" + 1", kHuge) + ";"), "B1201 ");
  EXPECT_EQ(Codes("float x = a" + Repeat(".b", kHuge) + ";"), "B1201 ");
  EXPECT_EQ(Codes("float x = a" + Repeat("[0]", kHuge) + ";"), "B1201 ");
  EXPECT_EQ(Codes("void f() { a" + Repeat(", a", kHuge) + "; }"), "B1201 ");
  EXPECT_EQ(Codes("float x = a" + Repeat("++", kHuge) + ";"), "B1201 ");
}

TEST(ParserLimits, TakesLongListsAndLongStrings) {
  EXPECT_EQ(Codes("float x[] = { 1" + Repeat(", 1", kHuge) + " };"), "");
  EXPECT_EQ(Codes("string s = \"a\"" + Repeat(" \"a\"", kHuge) + ";"), "");
  EXPECT_EQ(Codes("void f() { " + Repeat("a = 1; ", kHuge) + "}"), "");
}

}  // namespace
}  // namespace burin::fx::test
