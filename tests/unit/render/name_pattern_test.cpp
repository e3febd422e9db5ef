// SPDX-License-Identifier: Apache-2.0
#include "core/render/name_pattern.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace burin::render {
namespace {

using testing::ElementsAre;

NamePattern Pattern(std::string_view text) {
  auto pattern = NamePattern::Parse(text);
  EXPECT_TRUE(pattern) << text;
  return pattern.value_or(NamePattern());
}

std::string Refusal(std::string_view text) {
  const auto pattern = NamePattern::Parse(text);
  return pattern ? "accepted" : pattern.error().message;
}

TEST(NamePattern, WritesTheNumberInEveryForm) {
  EXPECT_EQ(Pattern("walk.####.png").Format(7), "walk.0007.png");
  EXPECT_EQ(Pattern("walk.%04d.png").Format(7), "walk.0007.png");
  EXPECT_EQ(Pattern("walk.{frame:04}.png").Format(7), "walk.0007.png");
  EXPECT_EQ(Pattern("walk{frame}.png").Format(7), "walk7.png");
  EXPECT_EQ(Pattern("walk%d.png").Format(123), "walk123.png");
  EXPECT_EQ(Pattern("a/b/#.exr").Format(0), "a/b/0.exr");
}

TEST(NamePattern, NumbersThatAreTooLongAreWrittenInFull) { EXPECT_EQ(Pattern("f##.png").Format(12345), "f12345.png"); }

TEST(NamePattern, TheSignIsNoDigit) { EXPECT_EQ(Pattern("f####.png").Format(-3), "f-0003.png"); }

TEST(NamePattern, ANameWithoutAPlaceIsItself) {
  const NamePattern plain = Pattern("out.png");
  EXPECT_FALSE(plain.has_token());
  EXPECT_EQ(plain.Format(9), "out.png");
  EXPECT_FALSE(Pattern("100%.png").has_token());
  EXPECT_FALSE(Pattern("{name}.png").has_token());
  EXPECT_FALSE(Pattern("{frame:x}.png").has_token());
  EXPECT_FALSE(Pattern("50%x.png").has_token());
}

TEST(NamePattern, MoreThanOnePlaceIsRefused) {
  EXPECT_EQ(Refusal("a##.%04d.png"), "'a##.%04d.png': a second place for the frame number, '%04d'; expected one");
  EXPECT_EQ(Refusal("####/a.png"),
            "'####/a.png': the frame number '####' stands in a folder's name; expected it in the file's name");
  EXPECT_EQ(Refusal("%010d.png"), "'%010d.png': '%010d' asks for more than 9 digits");
  EXPECT_EQ(Refusal("%99999999999d.png"), "'%99999999999d.png': '%99999999999d' asks for more than 9 digits");
}

TEST(NamePattern, MatchesOnlyNamesThatItWrites) {
  const NamePattern pattern = Pattern("f.####.png");
  EXPECT_EQ(pattern.Match("f.0007.png"), 7);
  EXPECT_EQ(pattern.Match("f.-0007.png"), -7);
  EXPECT_EQ(pattern.Match("f.12345.png"), 12345);
  EXPECT_EQ(pattern.Match("f.7.png"), std::nullopt);
  EXPECT_EQ(pattern.Match("f.00007.png"), std::nullopt);
  EXPECT_EQ(pattern.Match("f.0007.jpg"), std::nullopt);
  EXPECT_EQ(pattern.Match("f..png"), std::nullopt);
  EXPECT_EQ(pattern.Match("f.png"), std::nullopt);
  EXPECT_EQ(pattern.Match("f.00a7.png"), std::nullopt);
}

class FramesOnDisk : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("burin_name_pattern_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    for (const char* name : {"f.0010.png", "f.0002.png", "f.0001.png", "f.3.png", "g.0005.png"}) {
      std::ofstream(folder_ / name) << "x";
    }
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

TEST_F(FramesOnDisk, AreFoundInOrder) {
  const auto frames = Pattern(folder_.string() + "/f.####.png").FindFrames();
  ASSERT_TRUE(frames);
  EXPECT_THAT(*frames, ElementsAre(1, 2, 10));
  const auto odd = Pattern(folder_.string() + "//f.%04d.png").FindFrames();
  ASSERT_TRUE(odd);
  EXPECT_THAT(*odd, ElementsAre(1, 2, 10));
}

TEST_F(FramesOnDisk, AMissingFolderIsNamed) {
  const std::string name = folder_.string() + "/none/f.####.png";
  const auto frames = Pattern(name).FindFrames();
  ASSERT_FALSE(frames);
  EXPECT_EQ(frames.error().kind, ErrorKind::kInput);
  EXPECT_EQ(frames.error().message,
            "'" + name + "': cannot read the folder '" + folder_.string() + "/none': No such file or directory");
}

}  // namespace
}  // namespace burin::render
