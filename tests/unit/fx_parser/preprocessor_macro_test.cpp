// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

// What the last line of `text` becomes; the messages if there are any.
std::string Expand(const std::string& text) {
  const Preprocessed result = Preprocess(text);
  return result.messages.empty() ? result.text : result.messages;
}

TEST(PreprocessorMacro, ReplacesNames) {
  EXPECT_EQ(Expand("#define A 1 + 2\nA * A"), "1 + 2 * 1 + 2");
  EXPECT_EQ(Expand("#define A\nx A y"), "x y");
  EXPECT_EQ(Expand("#define A B\n#define B 3\nA"), "3");
}

TEST(PreprocessorMacro, ReplacesCallsOnly) {
  EXPECT_EQ(Expand("#define F(x) [x]\nF(1) F (2) F\n(3) F + 1"), "[ 1 ] [ 2 ] [ 3 ] F + 1");
  EXPECT_EQ(Expand("#define F() x\nF() F( )"), "x x");
  EXPECT_EQ(Expand("#define O (x) y\nO"), "( x ) y");
}

TEST(PreprocessorMacro, SplitsArgumentsAtTopLevelCommas) {
  EXPECT_EQ(Expand("#define F(x, y) <x|y>\nF((a, b), c(d, e))"), "< ( a , b ) | c ( d , e ) >");
  EXPECT_EQ(Expand("#define F(x, y) <x|y>\nF(, )"), "< | >");
}

TEST(PreprocessorMacro, ExpandsArgumentsBeforeSubstitution) {
  EXPECT_EQ(Expand("#define ONE 1\n#define F(x) x x\nF(ONE F(ONE))"), "1 1 1 1 1 1");
  EXPECT_EQ(Expand("#define CAT(a, b) a ## b\n#define XCAT(a, b) CAT(a, b)\n#define N 3\nCAT(x, N) XCAT(x, N)"),
            "xN x3");
}

TEST(PreprocessorMacro, LeavesAMacroInsideItselfAlone) {
  EXPECT_EQ(Expand("#define A A + 1\nA"), "A + 1");
  EXPECT_EQ(Expand("#define A B\n#define B A\nA B"), "A B");
  EXPECT_EQ(Expand("#define F(x) F(x + 1)\nF(1)"), "F ( 1 + 1 )");
}

// The worked example of C99 6.10.3.5, paragraph 5.
TEST(PreprocessorMacro, ExpandsTheExampleOfTheStandard) {
  const std::string definitions =
      "#define x 3\n#define f(a) f(x * (a))\n#undef x\n#define x 2\n#define g f\n#define z z[0]\n#define h g(~\n"
      "#define m(a) a(w)\n#define w 0,1\n#define t(a) a\n#define p() int\n#define q(x) x\n#define r(x,y) x ## y\n"
      "#define str(x) # x\n";
  EXPECT_EQ(Expand(definitions + "f(y+1) + f(f(z)) % t(t(g)(0) + t)(1);"),
            "f ( 2 * ( y + 1 ) ) + f ( 2 * ( f ( 2 * ( z [ 0 ] ) ) ) ) % f ( 2 * ( 0 ) ) + t ( 1 ) ;");
  EXPECT_EQ(Expand(definitions + "g(x+(3,4)-w) | h 5) & m\n(f)^m(m);"),
            "f ( 2 * ( 2 + ( 3 , 4 ) - 0 , 1 ) ) | f ( 2 * ( ~ 5 ) ) & f ( 2 * ( 0 , 1 ) ) ^ m ( 0 , 1 ) ;");
  EXPECT_EQ(Expand(definitions + "p() i[q()] = { q(1), r(2,3), r(4,), r(,5), r(,) };"),
            "int i [ ] = { 1 , 23 , 4 , 5 , } ;");
  EXPECT_EQ(Expand(definitions + "str(hello) str( a  \"b\\n\" ) str()"), "\"hello\" \"a \\\"b\\\\n\\\"\" \"\"");
}

TEST(PreprocessorMacro, PastesNumbersAndPunctuators) {
  EXPECT_EQ(Expand("#define P(a, b) a ## b\nP(1, .5) P(+, =) P(vs_, 2_0) P(x, 1)"), "1.5 += vs_2_0 x1");
  EXPECT_EQ(Expand("#define P(a, b, c) a ## b ## c\nP(a, , c) P(, , ) P(a b, c, d e)"), "ac a bcd e");
  EXPECT_EQ(Expand("#define TEX a ## b\nTEX"), "ab");
}

TEST(PreprocessorMacro, GivesSeveralTokensWhereAPasteMakesNone) {
  EXPECT_EQ(Expand("#define P(a, b) a ## b\nP(., x)"), ". x");
}

TEST(PreprocessorMacro, TakesVariadicMacros) {
  EXPECT_EQ(Expand("#define V(...) f(__VA_ARGS__)\nV() V(1) V(1, 2)"), "f ( ) f ( 1 ) f ( 1 , 2 )");
  EXPECT_EQ(Expand("#define V(a, ...) f(a, ## __VA_ARGS__)\nV(1) V(1, 2, 3)"), "f ( 1 ) f ( 1 , 2 , 3 )");
}

TEST(PreprocessorMacro, ContinuesDefinitionsOverLines) {
  EXPECT_EQ(Expand("#define T(n) technique n { \\\n pass P { } \\\n}\nT(A)"), "technique A { pass P { } }");
}

TEST(PreprocessorMacro, TakesArgumentsOverLinesWithDirectivesBetween) {
  EXPECT_EQ(Expand("#define F(x) [x]\nF(a\n#if 0\nb\n#else\nc\n#endif\n)"), "[ a c ]");
}

TEST(PreprocessorMacro, KnowsFileAndLine) {
  EXPECT_EQ(Expand("__FILE__ __LINE__\n#define L __LINE__\n\nL"), "\"main.fx\" 1\n4");
}

TEST(PreprocessorMacro, PredefinesTheHost) { EXPECT_EQ(Expand("DIRECT3D_VERSION BURIN"), "0x900 1"); }

TEST(PreprocessorMacro, TakesDefinitionsOfTheCommandLine) {
  PreprocessOptions options;
  options.definitions = {{"N", "3 + 1"}, {"FLAG", ""}, {"F(x)", "x * x"}, {"DIRECT3D_VERSION", "0xa00"}};
  EXPECT_EQ(Preprocess({{"main.fx", "N FLAG F(2) DIRECT3D_VERSION"}}, options).text, "3 + 1 1 2 * 2 0xa00");
}

TEST(PreprocessorMacro, RefusesDefinitionsThatAreNoNames) {
  PreprocessOptions options;
  options.definitions = {{"9X", "1"}, {"A B", "1"}, {"", "1"}};
  EXPECT_EQ(Preprocess({{"main.fx", ""}}, options).messages,
            "- error: '9X' is not a name that can be defined [B1010]\n"
            "- error: 'A B' is not a name that can be defined [B1010]\n"
            "- error: '' is not a name that can be defined [B1010]\n");
}

TEST(PreprocessorMacro, UndefinesNames) { EXPECT_EQ(Expand("#define A 1\n#undef A\n#undef B\nA"), "A"); }

TEST(PreprocessorMacro, WarnsOfADifferentSecondDefinition) {
  EXPECT_EQ(Expand("#define A 1\n#define A 1\n#define A 2\n"),
            "3:9 warning: macro 'A' is defined again, differently [X1519]\n  2:9 it was defined here\n");
}

TEST(PreprocessorMacro, ReportsArgumentCounts) {
  EXPECT_EQ(Expand("#define F(x, y) x\nF(1, 2, 3)"),
            "2:1 error: macro 'F' takes 2 arguments but is given 3 [B1012]\n  1:9 macro 'F' is defined here\n");
  EXPECT_EQ(Expand("#define F(x, y) x\nF(1)"),
            "2:1 warning: not enough arguments for macro 'F': 2 expected, 1 given [X1516]\n  1:9 macro 'F' is defined "
            "here\n");
  EXPECT_EQ(Expand("#define F() x\nF(1)"),
            "2:1 error: macro 'F' takes 0 arguments but is given 1 [B1012]\n  1:9 macro 'F' is defined here\n");
}

TEST(PreprocessorMacro, ReportsAnUnfinishedCall) {
  EXPECT_EQ(Expand("#define F(x) x\nF(1, (2)\nfloat a;"),
            "2:1 error: missing ')' to end the arguments of macro 'F' [B1011]\n");
}

TEST(PreprocessorMacro, ReportsMalformedDefinitions) {
  EXPECT_EQ(Expand("#define\n#define 3 4\n#define F(x\n#define G(x, x) x\n#define H(3) x\n"),
            "1:2 error: expected a macro name after #define [B1004]\n"
            "2:9 error: expected a macro name after #define, found '3' [B1004]\n"
            "3:9 error: expected ',' or ')' in the parameters of macro 'F' [B1010]\n"
            "4:14 error: macro 'G' has two parameters named 'x' [B1010]\n"
            "5:11 error: expected a name in the parameters of macro 'H' [B1010]\n");
  EXPECT_EQ(Expand("#define A ## b\n#define B b ##\n#define C a ## ## b\n#define D(x) #y\n#define defined 1\n"),
            "1:11 error: '##' needs an operand on each side [B1010]\n"
            "2:13 error: '##' needs an operand on each side [B1010]\n"
            "3:16 error: '##' needs an operand on each side [B1010]\n"
            "4:14 error: '#' must stand before a parameter of macro 'D' [B1010]\n"
            "5:9 error: expected a macro name after #define, found 'defined' [B1004]\n");
}

}  // namespace
}  // namespace burin::fx::test
