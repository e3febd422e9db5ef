// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "fx_parser/source/file_system.h"
#include "fx_parser/source/include_resolver.h"
#include "fx_parser/source/source.h"
#include "fx_parser/source/source_text.h"

namespace burin::fx {
namespace {

class SourceFileSystem : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "burin_fx_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) {
    const std::filesystem::path path = folder_ + "/" + name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }

  DiskFileSystem files_;
  std::string folder_;
};

TEST_F(SourceFileSystem, ReadsAFileAsItIs) {
  const std::string text("a\r\n\0\xff", 5);
  EXPECT_EQ(files_.Read(Write("a.fx", text)).value(), text);
  EXPECT_EQ(files_.Read(Write("empty.fx", "")).value(), "");
}

TEST_F(SourceFileSystem, SaysWhyAFileCannotBeRead) {
  EXPECT_EQ(files_.Read(folder_ + "/none").error(), "No such file or directory");
  EXPECT_EQ(files_.Read(folder_).error(), "it is a directory");
  ASSERT_EQ(mkfifo((folder_ + "/pipe").c_str(), 0600), 0);
  EXPECT_EQ(files_.Read(folder_ + "/pipe").error(), "it is not a regular file");
  EXPECT_EQ(files_.Read("/dev/zero").error(), "it is not a regular file");
  EXPECT_EQ(files_.Read(std::string("a\0b", 3)).error(), "the path has a zero byte");
}

TEST_F(SourceFileSystem, ReadsUpTo16MiB) {
  EXPECT_TRUE(files_.Read(Write("full", std::string(16u << 20, 'x'))).has_value());
  EXPECT_EQ(files_.Read(Write("over", std::string((16u << 20) + 1, 'x'))).error(), "it is larger than 16 MiB");
}

TEST_F(SourceFileSystem, FindsFilesWithoutRegardToCase) {
  const std::string path = Write("Shaders/Common/Util.FXH", "");
  EXPECT_EQ(files_.Find(folder_ + "/Shaders/Common/Util.FXH"), path);
  EXPECT_EQ(files_.Find(folder_ + "/shaders/COMMON/util.fxh"), path);
  EXPECT_EQ(files_.Find(folder_ + "/shaders\\common\\util.fxh"), path);
  EXPECT_EQ(files_.Find(folder_ + "/shaders/other/../common/util.fxh"), "");
  EXPECT_EQ(files_.Find(folder_ + "/shaders/../SHADERS/common/util.fxh"),
            folder_ + "/Shaders/../Shaders/Common/Util.FXH");
  EXPECT_EQ(files_.Find(folder_ + "/shaders/common"), "");
  EXPECT_EQ(files_.Find(folder_ + "/none.fxh"), "");
  EXPECT_EQ(files_.Find(""), "");
}

TEST_F(SourceFileSystem, PrefersTheExactCaseAndLooksInEveryFolderOfTheName) {
  const std::string lower = Write("lib/a.fxh", "");
  Write("Lib/b.fxh", "");
  Write("lib/A.FXH", "");
  EXPECT_EQ(files_.Find(folder_ + "/lib/a.fxh"), lower);
  EXPECT_EQ(files_.Find(folder_ + "/lib/B.fxh"), folder_ + "/Lib/b.fxh");
}

TEST_F(SourceFileSystem, GivesUpOnEndlessPaths) {
  std::string path = folder_;
  for (int i = 0; i < 5000; ++i) path += "/.";
  EXPECT_EQ(files_.Find(path + "/nothing"), "");
}

TEST(SourceInMemoryFileSystem, FindsFilesLikeADisk) {
  InMemoryFileSystem files;
  files.files = {{"Lib/A.fxh", "x"}};
  EXPECT_EQ(files.Find("lib\\a.FXH"), "Lib/A.fxh");
  EXPECT_EQ(files.Find("a.fxh"), "");
  EXPECT_EQ(files.Read("Lib/A.fxh").value(), "x");
  EXPECT_EQ(files.Read("lib/a.fxh").error(), "No such file or directory");
}

TEST(SourceIncludeResolver, ResolvesAbsolutePathsAlone) {
  InMemoryFileSystem files;
  files.files = {{"/abs/a.fxh", ""}, {"lib/a.fxh", ""}};
  EXPECT_EQ(ResolveInclude("/abs/a.fxh", "main.fx", {"lib"}, files).path, "/abs/a.fxh");
  EXPECT_EQ(ResolveInclude("C:\\lib\\a.fxh", "main.fx", {"lib"}, files).path, "");
  EXPECT_TRUE(ResolveInclude("/no", "main.fx", {"lib"}, files).searched.empty());
}

TEST(SourceIncludeResolver, ListsEachFolderOnce) {
  const InMemoryFileSystem files;
  const ResolvedInclude resolved = ResolveInclude("x.fxh", "dir/main.fx", {"dir", "lib", "lib", "."}, files);
  EXPECT_EQ(resolved.path, "");
  EXPECT_EQ(resolved.searched, (std::vector<std::string>{"dir", "lib", "."}));
}

TEST(SourceIncludeResolver, KnowsOneFileUnderSeveralSpellings) {
  EXPECT_EQ(PathKey("a/./b/../c.fxh"), "a/c.fxh");
  EXPECT_EQ(PathKey("a\\c.fxh"), "a/c.fxh");
  EXPECT_EQ(PathKey("./c.fxh"), "c.fxh");
}

TEST(SourceText, NormalisesLineEnds) {
  EXPECT_EQ(NormalizeText("a\r\nb\rc\n\r\n").value(), "a\nb\nc\n\n");
  EXPECT_EQ(NormalizeText("\r").value(), "\n");
  EXPECT_EQ(NormalizeText("\xEF\xBB\xBFx").value(), "x");
  EXPECT_EQ(NormalizeText("\xff\x80").value(), "\xff\x80");
}

TEST(SourceText, FollowsLineDirectives) {
  const SourceFile file{"a.fx", "", {}, {{2, 100, ""}, {5, 7, "b.fx"}}};
  EXPECT_EQ(Presume(file, 2).line, 2u);
  EXPECT_EQ(Presume(file, 3).line, 100u);
  EXPECT_EQ(Presume(file, 5).line, 102u);
  EXPECT_EQ(Presume(file, 5).path, "a.fx");
  EXPECT_EQ(Presume(file, 6).line, 7u);
  EXPECT_EQ(Presume(file, 6).path, "b.fx");
}

}  // namespace
}  // namespace burin::fx
