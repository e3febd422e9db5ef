// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <stdlib.h>

#include <filesystem>
#include <thread>

#include "core/base/cpu.h"
#include "core/base/crc32.h"
#include "core/base/module.h"
#include "core/base/path.h"
#include "core/base/program_paths.h"
#include "tests/unit/base/temporary_folder.h"

namespace burin::base {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ScopedVariable {
 public:
  ScopedVariable(const char* name, const std::string& value) : name_(name) { setenv(name, value.c_str(), 1); }
  ~ScopedVariable() { unsetenv(name_); }
  ScopedVariable(const ScopedVariable&) = delete;
  ScopedVariable& operator=(const ScopedVariable&) = delete;

 private:
  const char* name_;
};

TEST(Cpu, ThreadsFollowTheAffinityMask) {
  std::thread([] {  // the mask is a thread's: the other tests keep theirs
    cpu_set_t all;
    CPU_ZERO(&all);
    ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
    EXPECT_EQ(AvailableThreads(), CPU_COUNT(&all));
    int first = 0;
    while (!CPU_ISSET(first, &all)) ++first;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    EXPECT_EQ(AvailableThreads(), 1);
  })
      .join();
}

TEST(Path, LowerExtension) {
  EXPECT_EQ(LowerExtension("a/B.Exr"), "exr");
  EXPECT_EQ(LowerExtension("walk.0001.PNG"), "png");
  EXPECT_EQ(LowerExtension("folder.d/name"), "");
  EXPECT_EQ(LowerExtension(".hidden"), "");
  EXPECT_EQ(LowerExtension("a."), "");
  EXPECT_EQ(LowerExtension(""), "");
}

TEST(ProgramPaths, SplitsSearchPaths) {
  EXPECT_THAT(SplitSearchPath("/a:b::c:"), ElementsAre("/a", "b", "c"));
  EXPECT_THAT(SplitSearchPath(""), IsEmpty());
}

TEST(ProgramPaths, EffectFoldersComeFromTheEnvironmentFirst) {
  const TemporaryFolder folder;
  fs::create_directory(folder.File("mine"));
  const ScopedVariable variable("BURIN_EFFECTS_PATH", folder.File("missing") + ":" + folder.File("mine"));
  const auto folders = EffectFolders();
  ASSERT_FALSE(folders.empty());
  EXPECT_EQ(folders.front(), fs::canonical(folder.File("mine")).string());
}

TEST(ProgramPaths, BuildTreeFindsTheSourceEffects) {
  const char* source = std::getenv("BURIN_SOURCE_DIR");
  if (source == nullptr || !fs::exists(std::string(source) + "/effects")) GTEST_SKIP() << "no source folder given";
  EXPECT_THAT(EffectFolders(), testing::Contains(fs::canonical(std::string(source) + "/effects").string()));
}

TEST(Module, NamesEveryPathThatItTried) {
  const TemporaryFolder folder;
  test::WriteText(folder.File("burin_none_module.so"), "no shared object");
  const ScopedVariable variable("BURIN_MODULE_PATH", "/nowhere:" + folder.path());
  const auto loaded = LoadModuleFunction("burin_none_module", "Make");
  ASSERT_FALSE(loaded.has_value());
  EXPECT_EQ(loaded.error().kind, ErrorKind::kFailed);
  EXPECT_THAT(
      loaded.error().message,
      testing::StartsWith("cannot load the module 'burin_none_module' (set BURIN_MODULE_PATH to its folder); tried:"
                          "\n  /nowhere/burin_none_module.so: no such file\n  " +
                          folder.File("burin_none_module.so") + ": "));
  EXPECT_THAT(loaded.error().message, HasSubstr("/lib/burin/burin_none_module.so: no such file"));
}

// "123456789" is the check value that CRC catalogues give; the others come from zlib's crc32().
TEST(Crc32, MatchesKnownValues) {
  const auto crc = [](std::string_view text) { return Crc32(std::as_bytes(std::span(text))); };
  EXPECT_EQ(crc("123456789"), 0xCBF43926U);
  EXPECT_EQ(crc(""), 0U);
  EXPECT_EQ(crc("IEND"), 0xAE426082U);
  EXPECT_EQ(crc("The quick brown fox jumps over the lazy dog"), 0x414FA339U);
}

TEST(Crc32, GoesOn) {
  const std::string_view text = "a text in two parts";
  const auto bytes = std::as_bytes(std::span(text));
  EXPECT_EQ(Crc32(bytes.subspan(7), Crc32(bytes.first(7))), Crc32(bytes));
}

}  // namespace
}  // namespace burin::base
