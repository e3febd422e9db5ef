// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

TEST(ParserStatement, ReadsDeclarations) {
  EXPECT_EQ(DumpBody("float a = 1, b[2]; const int n = 3; static float s;"),
            "{ (var [float a = 1] [float b[2]]) (var [const int n = 3]) (var [static float s]) }");
  EXPECT_EQ(DumpBody("vector<float, 3> v = 0; typedef float2 uv; uv t = (uv)0;"),
            "{ (var [vector v = 0]) (var (typedef float2 uv)) (var [uv t = (cast uv 0)]) }");
  EXPECT_EQ(DumpBody("struct L { float x; } l; struct M { float y; }; M m;"),
            "{ (var (struct L) [L l]) (var (struct M)) (var [M m]) }");
}

TEST(ParserStatement, BindsElseToTheNearestIf) {
  EXPECT_EQ(DumpBody("if (a) if (b) x = 1; else x = 2;"), "{ (if a (if b (= x 1) else (= x 2))) }");
  EXPECT_EQ(DumpBody("if (a) { } else if (b) ; else return;"), "{ (if a { } else (if b ; else (return))) }");
}

TEST(ParserStatement, ReadsLoops) {
  EXPECT_EQ(DumpBody("for (int i = 0, j; i < 4; ++i) a += i;"),
            "{ (for (var [int i = 0] [int j]) (< i 4) (++ i) (+= a i)) }");
  EXPECT_EQ(DumpBody("for (;;) break;"), "{ (for ; nothing nothing (break)) }");
  EXPECT_EQ(DumpBody("for (i = 0, j = 1; a; b, c) { continue; }"),
            "{ (for (, (= i 0) (= j 1)) a (, b c) { (continue) }) }");
  EXPECT_EQ(DumpBody("while (a) b; do { c; } while (d);"), "{ (while a b) (do { c } d) }");
}

TEST(ParserStatement, KeepsAttributes) {
  EXPECT_EQ(
      DumpBody("[unroll] for (;;) { } [branch] if (a) { } [loop] while (b) { } [unroll(8)] [fastopt] for (;;) { }"),
      "{ [unroll](for ; nothing nothing { }) [branch](if a { }) [loop](while b { }) "
      "[unroll(8)][fastopt](for ; nothing nothing { }) }");
}

TEST(ParserStatement, ReadsSwitches) {
  EXPECT_EQ(DumpBody("switch (n) { case 0: case 1 + 1: a = 1; break; default: { b; } }"),
            "{ (switch n (case 0) (case (+ 1 1) (= a 1) (break)) (default { b })) }");
}

TEST(ParserStatement, ReadsJumps) {
  EXPECT_EQ(DumpBody("discard; return; return a, b; ;"), "{ (discard) (return) (return (, a b)) ; }");
}

TEST(ParserStatement, ReportsAMissingSemicolonOnceAndGoesOn) {
  EXPECT_EQ(DumpBody("a = 1\nb = 2;\nc = 3 d = 4;\nreturn\n"),
            "2:6 error: expected ';' after expression [X3000]\n"
            "4:6 error: expected ';' after expression [X3000]\n"
            "5:7 error: expected ';' after return [X3000]\n");
}

TEST(ParserStatement, ReportsFaultsInHeadersAndStillReadsTheBody) {
  EXPECT_EQ(DumpBody("for (int i = 0 i < 3; ++i) { a = ; }\nif (b { c = ; }\nwhile () d = ;"),
            "2:15 error: expected ';' after declaration of 'i' [X3000]\n"
            "2:34 error: expected an expression, found ';' [X3000]\n"
            "3:7 error: expected ')' after the condition, found '{' [X3000]\n  3:4 to match this\n"
            "4:8 error: expected an expression, found ')' [X3000]\n"
            "4:14 error: expected an expression, found ';' [X3000]\n");
}

TEST(ParserStatement, ReportsWordsWithoutTheirPartner) {
  EXPECT_EQ(DumpBody("else a = 1;"), "2:1 error: 'else' without 'if' [X3000]\n");
  EXPECT_EQ(DumpBody("case 1: ;"), "2:1 error: 'case' stands inside a switch [X3000]\n");
  EXPECT_EQ(DumpBody("do { } a;"), "2:8 error: expected 'while' after the body of 'do', found 'a' [X3000]\n");
  EXPECT_EQ(DumpBody("switch (a) { b = 1; case 1: break; }"),
            "2:14 error: expected 'case' or 'default', found 'b' [X3000]\n");
  EXPECT_EQ(DumpBody("switch (a) { case 1 break; }"),
            "2:21 error: expected ':' after the value of 'case', found 'break' [X3000]\n");
}

TEST(ParserStatement, ReportsAnUnknownTypeOnce) {
  EXPECT_EQ(DumpBody("flota3 x = 1; x.y = 2;"), "2:1 error: unknown type 'flota3'; did you mean 'float3'? [X3000]\n");
}

}  // namespace
}  // namespace burin::fx::test
