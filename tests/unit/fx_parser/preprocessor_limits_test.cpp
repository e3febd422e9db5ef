// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

std::string Level(int i) { return std::string("L") + std::to_string(i); }

TEST(PreprocessorLimits, StopsAMacroThatDoublesItself) {
  std::string text = "#define L0 x\n";
  for (int i = 1; i < 64; ++i) text += "#define " + Level(i) + " " + Level(i - 1) + " " + Level(i - 1) + "\n";
  EXPECT_EQ(Preprocess(text + "\nL63").messages, "66:1 error: macros expand to more than 1048576 tokens [B1003]\n");
}

TEST(PreprocessorLimits, StopsArgumentsThatDoubleThemselves) {
  std::string call = "x";
  for (int i = 0; i < 64; ++i) call = "D(" + call + ")";
  const Preprocessed result = Preprocess("#define D(a) a a\n" + call);
  EXPECT_NE(result.messages.find("error: macros expand to more than 1048576 tokens [B1003]"), std::string::npos)
      << result.messages;
}

TEST(PreprocessorLimits, StopsNamesThatDoubleTheirLength) {
  std::string text = "#define CAT(a, b) a ## b\n#define X(a) CAT(a, a)\n";
  std::string call = "abcdefgh";
  for (int i = 0; i < 60; ++i) call = "X(" + call + ")";
  const Preprocessed result = Preprocess(text + call);
  EXPECT_NE(result.messages.find("macros make more than 16 MiB of text [B1003]"), std::string::npos) << result.messages;
}

TEST(PreprocessorLimits, StopsAChainOfMacros) {
  std::string text = "#define L0 x\n";
  for (int i = 1; i < 1000; ++i) text += "#define " + Level(i) + " " + Level(i - 1) + "\n";
  EXPECT_EQ(Preprocess(text + "L999").messages,
            "1001:1 error: macros expand inside one another more than 200 levels deep [B1003]\n");
  EXPECT_EQ(Preprocess(text + "L150").text, "x");
}

TEST(PreprocessorLimits, StopsDeeplyNestedCalls) {
  std::string call = "x";
  for (int i = 0; i < 400; ++i) call = "F(" + call + ")";
  const Preprocessed result = Preprocess("#define F(a) a\n" + call);
  EXPECT_NE(result.messages.find("more than 200 levels deep [B1003]"), std::string::npos) << result.messages;
}

TEST(PreprocessorLimits, StopsATextOfTooManyTokens) {
  std::string text;
  for (int i = 0; i < (1 << 20); ++i) text += "a\n";
  EXPECT_EQ(Preprocess(text).messages, "");
  EXPECT_EQ(Preprocess(text + "a a").messages, "1048577:1 error: the text has more than 1048576 tokens [B1003]\n");
}

TEST(PreprocessorLimits, StopsDeepConditionals) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "#if 1\n";
  EXPECT_EQ(Preprocess(text).messages, "1001:2 error: conditional groups are nested more than 1000 deep [B1003]\n");
}

TEST(PreprocessorLimits, StopsDeepConditions) {
  for (const char* opening : {"(", "!", "- ", "1 ? ", "0 ? 1 : "}) {
    std::string condition;
    for (int i = 0; i < 20000; ++i) condition += opening;
    const Preprocessed result = Preprocess("#if " + condition + "1\n#endif");
    EXPECT_NE(result.messages.find("error: the condition is nested too deeply [B1007]"), std::string::npos)
        << opening << ": " << result.messages;
  }
}

TEST(PreprocessorLimits, TakesALongFlatCondition) {
  std::string condition = "1";
  for (int i = 0; i < 20000; ++i) condition += " + 1";
  EXPECT_EQ(Preprocess("#if " + condition + "\nyes\n#endif").text, "yes");
}

}  // namespace
}  // namespace burin::fx::test
