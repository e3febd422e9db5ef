// SPDX-License-Identifier: Apache-2.0
#include "core/base/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <utility>

#include "core/base/file_io.h"
#include "tests/unit/base/temporary_folder.h"

namespace burin::base {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::IsEmpty;

void Fill(const AtomicFile& file, std::string_view text) {
  ASSERT_EQ(WriteAll(file.descriptor(), std::as_bytes(std::span(text))), 0);
}

std::string Content(const std::string& path) {
  const auto bytes = test::ReadAllBytes(path);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(AtomicFile, AppearsOnCommitOnly) {
  const TemporaryFolder folder;
  auto file = AtomicFile::Create(folder.File("walk.0001.png"));
  ASSERT_TRUE(file.has_value()) << file.error().message;
  Fill(*file, "pixels");
  EXPECT_FALSE(fs::exists(folder.File("walk.0001.png")));
  ASSERT_TRUE(file->Commit().has_value());
  EXPECT_EQ(Content(folder.File("walk.0001.png")), "pixels");
  EXPECT_THAT(folder.Names(), ElementsAre("walk.0001.png"));
}

TEST(AtomicFile, TemporaryIsHiddenInTheSameFolderWithTheSameExtension) {
  const TemporaryFolder folder;
  const auto file = AtomicFile::Create(folder.File("walk.0001.png"));
  const fs::path temporary = file->temporary_path();
  EXPECT_EQ(temporary.parent_path(), folder.path());
  EXPECT_EQ(temporary.extension(), ".png");
  EXPECT_TRUE(temporary.filename().string().starts_with(".walk.0001.")) << temporary;
}

TEST(AtomicFile, TemporaryTakesAnotherExtensionWhenAsked) {
  const TemporaryFolder folder;
  auto file = AtomicFile::Create(folder.File("a.webm"), ".mkv");
  EXPECT_EQ(fs::path(file->temporary_path()).extension(), ".mkv");
  ASSERT_TRUE(file->Commit().has_value());
  EXPECT_THAT(folder.Names(), ElementsAre("a.webm"));
}

TEST(AtomicFile, IsRemovedWithoutCommit) {
  const TemporaryFolder folder;
  { const auto file = AtomicFile::Create(folder.File("a.png")); }
  EXPECT_THAT(folder.Names(), IsEmpty());
}

TEST(AtomicFile, KeepsTheOldFileWithoutCommit) {
  const TemporaryFolder folder;
  test::WriteText(folder.File("a.txt"), "old");
  {
    const auto file = AtomicFile::Create(folder.File("a.txt"));
    Fill(*file, "new");
  }
  EXPECT_EQ(Content(folder.File("a.txt")), "old");
}

TEST(AtomicFile, ReplacesTheOldFileAndKeepsItsPermissions) {
  const TemporaryFolder folder;
  test::WriteText(folder.File("a.txt"), "old");
  ASSERT_EQ(chmod(folder.File("a.txt").c_str(), 0640), 0);
  auto file = AtomicFile::Create(folder.File("a.txt"));
  Fill(*file, "new");
  ASSERT_TRUE(file->Commit().has_value());
  EXPECT_EQ(Content(folder.File("a.txt")), "new");
  struct stat status {};
  ASSERT_EQ(stat(folder.File("a.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0640U);
}

TEST(AtomicFile, WritesThroughALink) {
  const TemporaryFolder folder;
  fs::create_directory(folder.File("real"));
  fs::create_symlink("real/target.txt", folder.File("link.txt"));
  auto file = AtomicFile::Create(folder.File("link.txt"));
  Fill(*file, "text");
  ASSERT_TRUE(file->Commit().has_value());
  EXPECT_TRUE(fs::is_symlink(folder.File("link.txt")));
  EXPECT_EQ(Content(folder.File("real/target.txt")), "text");
}

TEST(AtomicFile, RefusesALoopOfLinks) {
  const TemporaryFolder folder;
  fs::create_symlink("b", folder.File("a"));
  fs::create_symlink("a", folder.File("b"));
  EXPECT_EQ(AtomicFile::Create(folder.File("a")).error().message,
            "cannot write '" + folder.File("a") + "': Too many levels of symbolic links");
}

TEST(AtomicFile, NamesAMissingFolder) {
  const TemporaryFolder folder;
  const auto file = AtomicFile::Create(folder.File("no/such/a.png"));
  ASSERT_FALSE(file.has_value());
  EXPECT_EQ(file.error().kind, ErrorKind::kFailed);
  EXPECT_EQ(file.error().message, "cannot write '" + folder.File("no/such/a.png") + "': the folder '" +
                                      folder.File("no/such") + "' does not exist");
}

TEST(AtomicFile, RefusesFoldersAndDevices) {
  const TemporaryFolder folder;
  EXPECT_EQ(AtomicFile::Create(folder.path()).error().message, "cannot write '" + folder.path() + "': it is a folder");
  EXPECT_EQ(AtomicFile::Create(folder.path() + "/").error().message,
            "cannot write '" + folder.path() + "/': it names a folder");
  EXPECT_EQ(AtomicFile::Create("/dev/null").error().message, "cannot write '/dev/null': it is not a regular file");
}

// In a child process, which gives up root's right to write everywhere.
TEST(AtomicFile, RefusesAnUnwritableFolder) {
  const TemporaryFolder folder;
  ASSERT_EQ(chmod(folder.path().c_str(), 0555), 0);
  constexpr uid_t kNobody = 65534;
  EXPECT_EXIT(
      {
        if (geteuid() == 0 && setuid(kNobody) != 0) _exit(2);
        const auto file = AtomicFile::Create(folder.File("a.png"));
        _exit(!file && file.error().message == "cannot write '" + folder.File("a.png") + "': Permission denied" ? 0
                                                                                                                : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST(AtomicFile, TakesTheLongestFileName) {
  const TemporaryFolder folder;
  const std::string name = std::string(251, 'n') + ".png";
  auto file = AtomicFile::Create(folder.File(name));
  ASSERT_TRUE(file.has_value()) << file.error().message;
  ASSERT_TRUE(file->Commit().has_value());
  EXPECT_THAT(folder.Names(), ElementsAre(name));
}

TEST(AtomicFile, SurvivesAMove) {
  const TemporaryFolder folder;
  auto first = AtomicFile::Create(folder.File("a.txt"));
  AtomicFile second = std::move(*first);
  Fill(second, "moved");
  EXPECT_FALSE(first->Commit().has_value());
  ASSERT_TRUE(second.Commit().has_value());
  EXPECT_EQ(Content(folder.File("a.txt")), "moved");
  EXPECT_FALSE(second.Commit().has_value());
}

TEST(Temporaries, RemovalTakesLiveOnesAndLeavesFinishedOnes) {
  const TemporaryFolder folder;
  auto finished = AtomicFile::Create(folder.File("finished.txt"));
  ASSERT_TRUE(finished->Commit().has_value());
  const auto live = AtomicFile::Create(folder.File("live.txt"));
  ASSERT_EQ(folder.Names().size(), 2U);
  RemoveTemporaries();
  EXPECT_THAT(folder.Names(), ElementsAre("finished.txt"));
}

TEST(Temporaries, GiveBackTheirSlots) {
  const TemporaryFolder folder;
  for (int i = 0; i < 2000; ++i) {
    const TemporaryId id = RegisterTemporary(folder.File("x"));
    ASSERT_NE(id, kNotRegistered);
    UnregisterTemporary(id);
  }
}

TEST(Temporaries, RefuseWhatDoesNotFit) { EXPECT_EQ(RegisterTemporary(std::string(5000, 'a')), kNotRegistered); }

}  // namespace
}  // namespace burin::base
