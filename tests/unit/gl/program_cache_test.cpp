// SPDX-License-Identifier: Apache-2.0
#include "core/gl/program_cache.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace burin::gl {
namespace {

namespace fs = std::filesystem;

class ProgramCacheTest : public testing::Test {
 protected:
  ProgramCacheTest() {
    folder_ = testing::TempDir() + "burin_cache_" + std::to_string(getpid());
    fs::remove_all(folder_);
  }
  ~ProgramCacheTest() override { fs::remove_all(folder_); }

  static ProgramBinary Binary() { return {.format = 42, .bytes = {std::byte{1}, std::byte{2}, std::byte{3}}}; }

  std::string folder_;
};

std::string Contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void Overwrite(const std::string& path, const std::string& contents) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << contents;
}

TEST_F(ProgramCacheTest, GivesBackWhatWasStored) {
  const ProgramCache cache(folder_ + "/deep/er");
  EXPECT_FALSE(cache.Load("key").has_value());
  cache.Store("key", Binary());
  const auto loaded = cache.Load("key");
  ASSERT_TRUE(loaded.has_value());
  EXPECT_EQ(loaded->format, 42u);
  EXPECT_EQ(loaded->bytes, Binary().bytes);
  EXPECT_FALSE(cache.Load("other").has_value());
}

TEST_F(ProgramCacheTest, RefusesEveryDamagedByteAndEveryTruncation) {
  const ProgramCache cache(folder_);
  cache.Store("key", Binary());
  const std::string whole = Contents(cache.PathOf("key"));
  ASSERT_EQ(whole.size(), 32u + 3u + 3u);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (i >= 8 && i < 12) continue;  // the binary format: the driver's to refuse
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    Overwrite(cache.PathOf("key"), damaged);
    EXPECT_FALSE(cache.Load("key").has_value()) << "byte " << i;
  }
  for (std::size_t size = 0; size < whole.size(); ++size) {
    Overwrite(cache.PathOf("key"), whole.substr(0, size));
    EXPECT_FALSE(cache.Load("key").has_value()) << "cut to " << size;
  }
  Overwrite(cache.PathOf("key"), whole + "x");
  EXPECT_FALSE(cache.Load("key").has_value());
}

TEST_F(ProgramCacheTest, AnotherKeyOfTheSameNameIsNoHit) {
  const ProgramCache cache(folder_);
  cache.Store("key", Binary());
  fs::rename(cache.PathOf("key"), cache.PathOf("yek"));
  EXPECT_FALSE(cache.Load("yek").has_value());
}

TEST_F(ProgramCacheTest, LeavesNoTemporaries) {
  const ProgramCache cache(folder_);
  for (int i = 0; i < 5; ++i) cache.Store("key" + std::to_string(i), Binary());
  for (const auto& entry : fs::directory_iterator(folder_)) EXPECT_EQ(entry.path().extension(), ".bin");
}

TEST_F(ProgramCacheTest, DropsOldEntriesWhenThereAreMany) {
  const ProgramCache cache(folder_);
  fs::create_directories(folder_);
  for (std::size_t i = 0; i < ProgramCache::kMaxEntries; ++i) Overwrite(cache.PathOf(std::to_string(i)), "old");
  cache.Store("new", Binary());
  EXPECT_TRUE(cache.Load("new").has_value());
  const auto count = std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  EXPECT_EQ(static_cast<std::size_t>(count), (ProgramCache::kMaxEntries + 1) - (ProgramCache::kMaxEntries + 1) / 2);
}

TEST_F(ProgramCacheTest, AnUnwritableFolderIsNoError) {
  Overwrite(folder_, "a file in the way");
  const ProgramCache cache(folder_ + "/programs");
  cache.Store("key", Binary());
  EXPECT_FALSE(cache.Load("key").has_value());
}

TEST(ProgramCacheFolder, FollowsTheEnvironment) {
  const auto with = [](const char* off, const char* xdg, const char* home) {
    off != nullptr ? setenv("BURIN_NO_CACHE", off, 1) : unsetenv("BURIN_NO_CACHE");
    xdg != nullptr ? setenv("XDG_CACHE_HOME", xdg, 1) : unsetenv("XDG_CACHE_HOME");
    home != nullptr ? setenv("HOME", home, 1) : unsetenv("HOME");
    const ProgramCache cache = ProgramCache::Default();
    return cache.enabled() ? fs::path(cache.PathOf("k")).parent_path().string() : std::string("off");
  };
  EXPECT_EQ(with("1", "/x", "/h"), "off");
  EXPECT_EQ(with(nullptr, "/x", "/h"), "/x/burin/programs");
  EXPECT_EQ(with("", "", "/h"), "/h/.cache/burin/programs");
  EXPECT_EQ(with("0", "relative", "/h"), "/h/.cache/burin/programs");
  EXPECT_EQ(with(nullptr, nullptr, nullptr), "off");
  setenv("BURIN_NO_CACHE", "1", 1);
}

}  // namespace
}  // namespace burin::gl
