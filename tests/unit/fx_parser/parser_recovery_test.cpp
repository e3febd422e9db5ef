// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

TEST(ParserRecovery, ReportsFaultsOfAllKindsInOneRun) {
  const auto parsed = ParseText(
      "float a = 1\n"
      "float4 b = { 1, 2 3 };\n"
      "foo4 c;\n"
      "struct S { float x }\n"
      "float f(float y {\n"
      "  return y;\n"
      "}\n"
      "float g() {\n"
      "  float z = (1 + ;\n"
      "  z = 2;\n"
      "  return z +;\n"
      "}\n"
      "technique T {\n"
      "  pass P { ZEnable = ; }\n"
      "}\n");
  EXPECT_EQ(parsed->Messages(),
            "1:12 error: expected ';' after declaration of 'a' [X3000]\n"
            "2:19 error: expected ',' or '}' in the initialiser, found '3' [X3000]\n  2:12 to match this\n"
            "3:1 error: unknown type 'foo4' [X3000]\n"
            "4:19 error: expected ';' after member 'x' [X3000]\n"
            "4:21 error: expected ';' after struct 'S' [X3000]\n"
            "5:17 error: expected ',' or ')' in the parameters of 'f', found '{' [X3000]\n  5:8 to match this\n"
            "9:18 error: expected an expression, found ';' [X3000]\n"
            "11:13 error: expected an expression, found ';' [X3000]\n"
            "14:22 error: expected an expression, found ';' [X3000]\n");
}

TEST(ParserRecovery, KeepsTheDeclarationsAroundAFault) {
  const auto parsed = ParseText("float a;\nfloat b = = 2;\nfloat c;\nvoid f() { x = ; y = 1; }\nfloat d;");
  EXPECT_EQ(parsed->diagnostics.error_count(), 2);
  EXPECT_EQ(Dump(parsed->module), "[float a]\n[float c]\n(function void f { ; (= y 1) })\n[float d]");
}

TEST(ParserRecovery, FindsTheNextDeclarationAfterUnbalancedBraces) {
  const auto parsed = ParseText("float a = { 1, { 2;\nfloat b;\ntechnique T { pass P { } }");
  EXPECT_EQ(parsed->diagnostics.error_count(), 1);
  EXPECT_EQ(Dump(parsed->module), "[float b]\n(technique T (pass P))");
}

TEST(ParserRecovery, StopsAfterTwentyErrors) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += "float x" + std::to_string(i) + " = ;\n";
  const auto parsed = ParseText(text);
  EXPECT_EQ(parsed->diagnostics.error_count(), 20);
  EXPECT_EQ(parsed->diagnostics.all().back().range.begin.line, 20u);
}

TEST(ParserRecovery, ShowsFaultsThroughIncludesAndMacros) {
  const auto parsed =
      ParseFiles({{"main.fx", "float a;\n#include \"lib/inner.fxh\"\nfloat b;\n"},
                  {"lib/inner.fxh", "#define DECLARE(name) \\\n  float name = ;\n\n\tDECLARE(speed)\n"}});
  EXPECT_EQ(parsed->Formatted(),
            "In file included from main.fx:2:\n"
            "lib/inner.fxh:4:2: error: expected an expression, found ';' [X3000]\n"
            "\tDECLARE(speed)\n"
            "\t^~~~~~~\n"
            "lib/inner.fxh:2:16: note: in expansion of macro 'DECLARE'\n"
            "  float name = ;\n"
            "               ^\n");
}

TEST(ParserRecovery, SaysNothingAboutTheRestAfterAMissingInclude) {
  const auto parsed = ParseFiles({{"main.fx", "#include \"types.fxh\"\nLight l;\n#include <more.fxh>\n"}});
  EXPECT_EQ(parsed->Messages(),
            "1:10 error: include file 'types.fxh' not found; searched in '.' [X1507]\n"
            "3:10 error: include file 'more.fxh' not found; searched in '.' [X1507]\n");
  EXPECT_TRUE(parsed->module.declarations.empty());
}

TEST(ParserRecovery, ReportsAMissingMainFile) {
  const auto parsed = ParseFiles({});
  EXPECT_EQ(parsed->Formatted(), "error: cannot read effect file 'main.fx': No such file or directory [X1507]\n");
}

TEST(ParserRecovery, AcceptsAnEmptyFile) {
  EXPECT_EQ(DumpText(""), "");
  EXPECT_EQ(DumpText("// nothing\n"), "");
}

}  // namespace
}  // namespace burin::fx::test
