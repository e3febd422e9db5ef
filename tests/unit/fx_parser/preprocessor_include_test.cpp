// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;

TEST(PreprocessorInclude, ReadsBothQuoteForms) {
  EXPECT_EQ(
      Preprocess({{"main.fx", "#include \"a.fxh\"\n#include <b.fxh> // b\nx"}, {"a.fxh", "a"}, {"b.fxh", "b\n"}}).text,
      "a\nb\nx");
}

TEST(PreprocessorInclude, LooksBesideTheIncludingFileFirstThenInTheFolders) {
  const Files files{{"main.fx", "#include \"sub/a.fxh\""},
                    {"sub/a.fxh", "#include \"b.fxh\"\n#include \"c.fxh\""},
                    {"sub/b.fxh", "near"},
                    {"lib/b.fxh", "far"},
                    {"lib/c.fxh", "first"},
                    {"more/c.fxh", "second"}};
  PreprocessOptions options;
  options.include_folders = {"lib", "more/"};
  EXPECT_EQ(Preprocess(files, options).text, "near\nfirst");
}

TEST(PreprocessorInclude, FindsWindowsPaths) {
  EXPECT_EQ(
      Preprocess({{"main.fx", "#include \"Lib\\Common.FXH\"\n#include <.\\lib\\common.fxh>"}, {"lib/common.fxh", "x"}})
          .text,
      "x\nx");
}

TEST(PreprocessorInclude, TakesNamesFromMacros) {
  EXPECT_EQ(
      Preprocess({{"main.fx", "#define Q \"a.fxh\"\n#define P <a.fxh>\n#include Q\n#include P"}, {"a.fxh", "x"}}).text,
      "x\nx");
}

TEST(PreprocessorInclude, NamesTheFoldersSearched) {
  PreprocessOptions options;
  options.include_folders = {"lib", "/usr/share/fx"};
  EXPECT_EQ(Preprocess({{"main.fx", "#include \"no.fxh\""}}, options).messages,
            "1:10 error: include file 'no.fxh' not found; searched in '.', 'lib', '/usr/share/fx' [X1507]\n");
}

TEST(PreprocessorInclude, RefusesMalformedIncludes) {
  EXPECT_EQ(Preprocess("#include\n#include \"a\n#include <a\n#include \"\"\n#include 3\n").messages,
            "1:2 error: expected \"file\" or <file> after #include [B1004]\n"
            "2:10 error: expected '\"' after the file name of #include [B1004]\n"
            "3:10 error: expected '>' after the file name of #include [B1004]\n"
            "4:10 error: #include has an empty file name [B1004]\n"
            "5:10 error: expected \"file\" or <file> after #include [B1004]\n");
}

TEST(PreprocessorInclude, ShowsTheCycle) {
  EXPECT_EQ(
      Preprocess(
          {{"main.fx", "#include \"a.fxh\""}, {"a.fxh", "\n#include \"b.fxh\""}, {"b.fxh", "#include \"./A.fxh\""}})
          .messages,
      "b.fxh:1:10 error: include cycle: 'a.fxh' -> 'b.fxh' -> 'a.fxh' [B1002]\n");
  EXPECT_EQ(Preprocess({{"main.fx", "#include \"main.fx\""}}).messages,
            "1:10 error: include cycle: 'main.fx' -> 'main.fx' [B1002]\n");
}

TEST(PreprocessorInclude, FindsACycleThatDefinesMacros) {
  EXPECT_EQ(Preprocess({{"main.fx", "#include \"a.fxh\""}, {"a.fxh", "#define A 1\n#include \"a.fxh\""}}).messages,
            "a.fxh:2:10 error: include cycle: 'a.fxh' -> 'a.fxh' [B1002]\n");
}

TEST(PreprocessorInclude, TakesGuardedFilesThatIncludeEachOther) {
  const Preprocessed result = Preprocess({{"main.fx", "#include \"a.fxh\"\n#include \"b.fxh\"\nx"},
                                          {"a.fxh", "#ifndef A\n#define A\n#include \"b.fxh\"\na\n#endif"},
                                          {"b.fxh", "#ifndef B\n#define B\n#include \"a.fxh\"\nb\n#endif"}});
  EXPECT_EQ(result.messages, "");
  EXPECT_EQ(result.text, "b\na\nx");
}

TEST(PreprocessorInclude, TakesAFileThatCountsItself) {
  const Preprocessed result = Preprocess(
      {{"main.fx", "#include \"n.fxh\""},
       {"n.fxh",
        "n\n#ifndef N1\n#define N1\n#include \"n.fxh\"\n#elif !defined(N2)\n#define N2\n#include \"n.fxh\"\n#endif"}});
  EXPECT_EQ(result.messages, "");
  EXPECT_EQ(result.text, "n\nn\nn");
}

TEST(PreprocessorInclude, ReadsAPragmaOnceFileOnce) {
  EXPECT_EQ(Preprocess({{"main.fx", "#include \"a.fxh\"\n#include \"x/../a.fxh\"\n#include \"A.fxh\""},
                        {"a.fxh", "#pragma once\na\n#include \"a.fxh\""}})
                .text,
            "a");
}

TEST(PreprocessorInclude, ReadsCrLfBomAndForeignBytes) {
  const Preprocessed result = Preprocess({{"main.fx", "\xEF\xBB\xBF#include \"a.fxh\"\r\nx\r\n"},
                                          {"a.fxh", "// \x93\xfa\x96\x7b\r\n#define A \\\r\n 1\r\nA"}});
  EXPECT_EQ(result.messages, "");
  EXPECT_EQ(result.text, "1\nx");
}

TEST(PreprocessorInclude, RefusesWhatIsNoText) {
  EXPECT_EQ(Preprocess({{"main.fx", "#include \"a.fxh\""},
                        {"a.fxh", std::string("\xFF\xFE"
                                              "f\0",
                                              4)}})
                .messages,
            "1:10 error: cannot read include file 'a.fxh': the file is UTF-16; save it as UTF-8 [X1507]\n");
  EXPECT_EQ(Preprocess({{"main.fx", std::string("a\0b", 3)}}).messages,
            "- error: cannot read effect file 'main.fx': the file is not text (it has a zero byte) [X1507]\n");
}

TEST(PreprocessorInclude, LimitsTheDepth) {
  Files files{{"main.fx", "#include \"f0\""}};
  for (int i = 0; i < 100; ++i)
    files.emplace_back("f" + std::to_string(i), "#include \"f" + std::to_string(i + 1) + "\"");
  files.emplace_back("f100", "x");
  EXPECT_EQ(Preprocess(files).messages, "f63:1:2 error: includes are nested more than 64 deep [B1003]\n");
}

TEST(PreprocessorInclude, LimitsTheNumberOfFiles) {
  Files files{{"main.fx", "#include \"f0\""}};
  for (int i = 0; i < 30; ++i) {
    const std::string next = "#include \"f" + std::to_string(i + 1) + "\"\n";
    files.emplace_back("f" + std::to_string(i), next + next);
  }
  files.emplace_back("f30", "");
  const std::string messages = Preprocess(files).messages;
  EXPECT_NE(messages.find("error: more than 4096 files are included [B1003]"), std::string::npos) << messages;
}

TEST(PreprocessorInclude, LimitsTheTextRead) {
  std::string main;
  for (int i = 0; i < 4; ++i) main += "#include \"big\"\n";
  EXPECT_EQ(Preprocess({{"main.fx", main}, {"big", std::string(9u << 20, ' ')}}).messages,
            "4:2 error: the effect and its includes have more than 32 MiB of text [B1003]\n");
}

}  // namespace
}  // namespace burin::fx::test
