// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

TEST(ParserExpression, MultipliesBeforeItAdds) { EXPECT_EQ(DumpExpression("a + b * c - d"), "(- (+ a (* b c)) d)"); }

TEST(ParserExpression, GivesEveryBinaryOperatorItsPrecedence) {
  EXPECT_EQ(DumpExpression("a || b && c | d ^ e & f == g < h << i + j * k"),
            "(|| a (&& b (| c (^ d (& e (== f (< g (<< h (+ i (* j k))))))))))");
  EXPECT_EQ(DumpExpression("a * b + c << d < e == f & g ^ h | i && j || k"),
            "(|| (&& (| (^ (& (== (< (<< (+ (* a b) c) d) e) f) g) h) i) j) k)");
}

TEST(ParserExpression, GroupsEqualPrecedenceFromTheLeft) {
  EXPECT_EQ(DumpExpression("a - b + c"), "(+ (- a b) c)");
  EXPECT_EQ(DumpExpression("a / b % c * d"), "(* (% (/ a b) c) d)");
  EXPECT_EQ(DumpExpression("a <= b >= c > d"), "(> (>= (<= a b) c) d)");
  EXPECT_EQ(DumpExpression("a >> b << c"), "(<< (>> a b) c)");
  EXPECT_EQ(DumpExpression("a != b == c"), "(== (!= a b) c)");
}

TEST(ParserExpression, GroupsConditionalsAndAssignmentsFromTheRight) {
  EXPECT_EQ(DumpExpression("a ? b : c ? d : e"), "(? a b (? c d e))");
  EXPECT_EQ(DumpBody("a = b = c;"), "{ (= a (= b c)) }");
  EXPECT_EQ(DumpBody("a ? b : c, d;"), "{ (, (? a b c) d) }");
}

TEST(ParserExpression, KnowsEveryAssignmentOperator) {
  EXPECT_EQ(DumpBody("a += 1; a -= 1; a *= 1; a /= 1; a %= 1;"), "{ (+= a 1) (-= a 1) (*= a 1) (/= a 1) (%= a 1) }");
  EXPECT_EQ(DumpBody("a <<= 1; a >>= 1; a &= 1; a |= 1; a ^= 1;"),
            "{ (<<= a 1) (>>= a 1) (&= a 1) (|= a 1) (^= a 1) }");
}

TEST(ParserExpression, TakesPrefixAndPostfixOperators) {
  EXPECT_EQ(DumpExpression("-+!~a"), "(- (+ (! (~ a))))");
  EXPECT_EQ(DumpBody("++a; --a; a++; a--;"), "{ (++ a) (-- a) (post++ a) (post-- a) }");
  EXPECT_EQ(DumpExpression("-a.x"), "(- (. a x))");
  EXPECT_EQ(DumpExpression("a - -b"), "(- a (- b))");
}

TEST(ParserExpression, ChainsMembersIndicesAndSwizzles) {
  EXPECT_EQ(DumpExpression("lights[i + 1].color.rgb"), "(. (. ([] lights (+ i 1)) color) rgb)");
  EXPECT_EQ(DumpExpression("m._m00_m11"), "(. m _m00_m11)");
  EXPECT_EQ(DumpExpression("m[0][1]"), "([] ([] m 0) 1)");
  EXPECT_EQ(DumpExpression("f(x).xy"), "(. (call f x) xy)");
}

TEST(ParserExpression, CallsFunctionsAndMethods) {
  EXPECT_EQ(DumpExpression("f()"), "(call f)");
  EXPECT_EQ(DumpExpression("lerp(a, b, g(c))"), "(call lerp a b (call g c))");
  EXPECT_EQ(DumpExpression("t.Sample(s, uv)"), "(call t.Sample s uv)");
}

TEST(ParserExpression, TellsConstructorsFromCalls) {
  EXPECT_EQ(DumpExpression("float4(a, 1)"), "(new float4 a 1)");
  EXPECT_EQ(DumpExpression("half3x3(1, b)"), "(new half3x3 1 b)");
  EXPECT_EQ(DumpExpression("vector<float, 3>(a)"), "(new vector a)");
  EXPECT_EQ(DumpExpression("float4x5(a)"), "(call float4x5 a)");
}

TEST(ParserExpression, TellsCastsFromParentheses) {
  EXPECT_EQ(DumpExpression("(float3)a.b"), "(cast float3 (. a b))");
  EXPECT_EQ(DumpExpression("(float3)-a + b"), "(+ (cast float3 (- a)) b)");
  EXPECT_EQ(DumpExpression("(a) + b"), "(+ a b)");
  EXPECT_EQ(DumpExpression("(float[2])0"), "(cast float[2] 0)");
  EXPECT_EQ(DumpExpression("(matrix<half, 2, 3>)m"), "(cast matrix m)");
  EXPECT_EQ(DumpText("struct S { float x; }; S s = (S)0;"), "(struct S [float x])\n[S s = (cast S 0)]");
}

TEST(ParserExpression, KeepsAVariableThatHidesAType) {
  EXPECT_EQ(DumpText("struct S { float x; };\nvoid f(float S) { S = (S) - 1; }"),
            "(struct S [float x])\n(function void f [float S] { (= S (- S 1)) })");
}

TEST(ParserExpression, ReadsNumbersOfEveryForm) {
  EXPECT_EQ(DumpExpression("{ 1, 1u, 0x1F, 010, 1.5, .5, 2., 1e2, 1.f, 3.h, 2.5F }"),
            "{ 1 1u 31 8 1.5f 0.5f 2f 100f 1f 3h 2.5f }");
}

TEST(ParserExpression, SwizzlesNumbers) {
  EXPECT_EQ(DumpExpression("1.xxx"), "(. 1 xxx)");
  EXPECT_EQ(DumpExpression("0.5.rrrr"), "(. 0.5f rrrr)");
}

TEST(ParserExpression, ReadsBooleansInAnyCase) {
  EXPECT_EQ(DumpExpression("{ true, FALSE, True }"), "{ true false true }");
}

TEST(ParserExpression, JoinsStringsThatStandTogether) {
  EXPECT_EQ(DumpText("string s = \"a\" \"b\" (\"c\") (\"d\" \"e\") ((\"f\"));"), "[string s = \"abcdef\"]");
  EXPECT_EQ(DumpText("string s = (\"a\") \"b\";"), "[string s = \"ab\"]");
}

TEST(ParserExpression, RefusesToJoinAStringWithAnythingElse) {
  EXPECT_EQ(DumpText("string s = \"a\" (\"b\", 1);"), "1:16 error: expected only strings to be joined [X3000]\n");
}

TEST(ParserExpression, ReadsInitialiserLists) {
  EXPECT_EQ(DumpExpression("{ 1, { 2, 3 }, }"), "{ 1 { 2 3 } }");
  EXPECT_EQ(DumpExpression("{ }"), "{ }");
}

TEST(ParserExpression, ReadsCompileExpressions) {
  EXPECT_EQ(DumpText("PixelShader p = compile ps_2_0 Main(true, 2, s);"),
            "[PixelShader p = (compile ps_2_0 Main true 2 s)]");
  EXPECT_EQ(DumpText("VertexShader p = COMPILE arbvp1 Main;"), "[VertexShader p = (compile arbvp1 Main)]");
  EXPECT_EQ(DumpText("PixelShader p = CompileShader(ps_4_0, Main(1));"), "[PixelShader p = (compile ps_4_0 Main 1)]");
}

TEST(ParserExpression, CapturesAsmBlocksWhateverIsInThem) {
  EXPECT_EQ(DumpText("PixelShader p = asm { ps.1.1\n  tex t0 ; it's \"fine\n mov r0, c0.x };"),
            "[PixelShader p = (asm 'ps.1.1\ntex t0 ; it's \"fine\nmov r0, c0.x')]");
  EXPECT_EQ(DumpText("float compile; float asm = compile + 1;"), "[float compile]\n[float asm = (+ compile 1)]");
}

TEST(ParserExpression, TakesContextualWordsAsNames) {
  EXPECT_EQ(DumpBody("float line = 1, point = line; point += sample * texture; linear = triangle; pass = technique;"),
            "{ (var [float line = 1] [float point = line]) (+= point (* sample texture)) (= linear triangle) "
            "(= pass technique) }");
}

TEST(ParserExpression, ReportsAMissingOperand) {
  EXPECT_EQ(DumpExpression("1 +"), "1:14 error: expected an expression, found ';' [X3000]\n");
  EXPECT_EQ(DumpExpression("f(,)"), "1:13 error: expected an expression, found ',' [X3000]\n");
}

TEST(ParserExpression, ReportsAnUnclosedBracketWithItsOpening) {
  EXPECT_EQ(DumpExpression("(1 + 2"), "1:17 error: expected ')', found ';' [X3000]\n  1:11 to match this\n");
  EXPECT_EQ(DumpExpression("f(1 2)"),
            "1:15 error: expected ',' or ')' after the argument, found '2' [X3000]\n  1:12 to match this\n");
  EXPECT_EQ(DumpExpression("a[1"),
            "1:14 error: expected ']' after the index, found ';' [X3000]\n  1:12 to match this\n");
  EXPECT_EQ(DumpExpression("{ 1 2 }"),
            "1:15 error: expected ',' or '}' in the initialiser, found '2' [X3000]\n  1:11 to match this\n");
}

TEST(ParserExpression, ReportsAConditionalWithoutColon) {
  EXPECT_EQ(DumpExpression("a ? b"), "1:16 error: expected ':' of the conditional operator, found ';' [X3000]\n");
}

TEST(ParserExpression, ReportsAMemberWithoutName) {
  EXPECT_EQ(DumpExpression("a.;"), "1:13 error: expected a member or swizzle after '.', found ';' [X3000]\n");
}

TEST(ParserExpression, ReportsMalformedTokensWhereTheyStand) {
  EXPECT_EQ(DumpExpression("1.5q"), "1:11 error: malformed number '1.5q' [B1103]\n");
  EXPECT_EQ(DumpExpression("a @ b"), "1:12 error: expected ';' after declaration of 'x' [X3000]\n");
  EXPECT_EQ(DumpExpression("$a"), "1:11 error: character '$' has no meaning here [B1104]\n");
  EXPECT_EQ(DumpExpression("\x80"), "1:11 error: character byte 0x80 has no meaning here [B1104]\n");
  EXPECT_EQ(DumpExpression("\"abc"), "1:11 error: the string has no closing quote on its line [B1102]\n");
  EXPECT_EQ(DumpExpression("0x1FFFFFFFFFFFFFFFF"),
            "1:11 error: the number '0x1FFFFFFFFFFFFFFFF' needs more than 64 bits [B1103]\n");
}

TEST(ParserExpression, RangesCoverTheWholeExpression) {
  const auto parsed = ParseText("float x = foo(a,\n  b) + 1;");
  const auto& variable = std::get<std::unique_ptr<ast::Variable>>(parsed->module.declarations.at(0));
  const Range& range = variable->initializer->range;
  EXPECT_EQ(range.begin.line, 1u);
  EXPECT_EQ(range.begin.column, 11u);
  EXPECT_EQ(range.end_line, 2u);
  EXPECT_EQ(range.end_column, 9u);
}

}  // namespace
}  // namespace burin::fx::test
