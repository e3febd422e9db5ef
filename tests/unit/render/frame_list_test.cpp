// SPDX-License-Identifier: Apache-2.0
#include "core/render/frame_list.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <set>

namespace burin::render {
namespace {

using testing::ElementsAre;

std::vector<long> Frames(std::string_view text) {
  const auto frames = ParseFrameList(text);
  EXPECT_TRUE(frames) << text << ": " << (frames ? "" : frames.error().message);
  return frames.value_or(std::vector<long>());
}

std::string Refusal(std::string_view text) {
  const auto frames = ParseFrameList(text);
  if (frames) return "accepted";
  EXPECT_EQ(frames.error().kind, ErrorKind::kUsage);
  return frames.error().message;
}

TEST(FrameList, TakesEveryFormOfTheContract) {
  EXPECT_THAT(Frames("7"), ElementsAre(7));
  EXPECT_THAT(Frames("1-4"), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(Frames("1..4"), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(Frames("1-10x3"), ElementsAre(1, 4, 7, 10));
  EXPECT_THAT(Frames("1-10:4"), ElementsAre(1, 5, 9));
  EXPECT_THAT(Frames("1..5x2"), ElementsAre(1, 3, 5));
  EXPECT_THAT(Frames("-3--1"), ElementsAre(-3, -2, -1));
  EXPECT_THAT(Frames("-1-1"), ElementsAre(-1, 0, 1));
  EXPECT_THAT(Frames("-2..0"), ElementsAre(-2, -1, 0));
  EXPECT_THAT(Frames("1-3,7, 9-10"), ElementsAre(1, 2, 3, 7, 9, 10));
}

TEST(FrameList, SortsAndDropsRepetitions) { EXPECT_THAT(Frames("5,1-3,2,5"), ElementsAre(1, 2, 3, 5)); }

TEST(FrameList, ABareColonIsRefusedWithAHint) {
  EXPECT_EQ(Refusal("1:10"),
            "--frames 1:10: 'a:b' is not a range; write 1-10 for all of them, or 1-10:N for every Nth");
}

TEST(FrameList, MalformedListsAreRefusedByWhatIsWrong) {
  EXPECT_EQ(Refusal("10-1"), "--frames 10-1: the range ends before it begins; write 1-10");
  EXPECT_EQ(Refusal("1-10x0"), "--frames 1-10x0: the step is 0; expected 1 or more");
  EXPECT_EQ(Refusal("1-10x-2"), "--frames 1-10x-2: the step is -2; expected 1 or more");
  EXPECT_EQ(Refusal("1,,2"), "--frames 1,,2: in '': an empty item; expected a frame or a range between the commas");
  EXPECT_EQ(Refusal("1,b"),
            "--frames 1,b: in 'b': expected a frame (7), a range (1-10) or a range with a step (1-10x2)");
  for (const char* text : {"", "-", "--", "1-", "1..", "1-2-3", "1x2", "1-3x", "1-3:", "1.5", "1 2", "0x10", "+1",
                           "99999999999999999999", "1-1000000000"}) {
    EXPECT_NE(Refusal(text), "accepted") << text;
  }
}

TEST(FrameList, HugeRangesAreRefusedBeforeTheyTakeMemory) {
  EXPECT_EQ(Refusal("1-999999999"), "--frames 1-999999999: more than 10000000 frames");
  EXPECT_NE(Refusal("-999999999-999999999"), "accepted");
}

TEST(FrameList, FormatsTheShortestList) {
  const auto text = [](std::vector<long> frames) { return FormatFrameList(frames); };
  EXPECT_EQ(text({}), "");
  EXPECT_EQ(text({4}), "4");
  EXPECT_EQ(text({4, 5}), "4,5");
  EXPECT_EQ(text({1, 2, 3}), "1-3");
  EXPECT_EQ(text({1, 4, 7, 20}), "1-7x3,20");
  EXPECT_EQ(text({-3, -2, -1}), "-3--1");
}

// Any set of frames, written as a list in any of the forms, reads back as itself.
TEST(FrameList, ReadsBackWhatWasWritten) {
  constexpr unsigned kSeed = 20240611;
  RecordProperty("seed", static_cast<int>(kSeed));
  std::mt19937 random(kSeed);
  const auto number = [&random](long low, long high) { return std::uniform_int_distribution<long>(low, high)(random); };
  for (int round = 0; round < 2000; ++round) {
    std::set<long> expected;
    std::string text;
    for (long item = number(1, 5); item > 0; --item) {
      const long first = number(-50, 50);
      const long last = first + number(0, 40);
      const long step = number(1, 7);
      for (long frame = first; frame <= last; frame += step) expected.insert(frame);
      if (!text.empty()) text += number(0, 1) == 0 ? "," : " , ";
      text += std::to_string(first) + (number(0, 1) == 0 ? "-" : "..") + std::to_string(last);
      if (step != 1 || number(0, 1) == 0) text += (number(0, 1) == 0 ? "x" : ":") + std::to_string(step);
    }
    const std::vector<long> frames = Frames(text);
    ASSERT_THAT(frames, testing::ElementsAreArray(expected)) << "seed " << kSeed << ": " << text;
    ASSERT_EQ(Frames(FormatFrameList(frames)), frames) << "seed " << kSeed << ": " << FormatFrameList(frames);
  }
}

TEST(FrameList, NoBytesCrashIt) {
  constexpr unsigned kSeed = 77;
  std::mt19937 random(kSeed);
  const std::string_view alphabet = "0123456789-.,x: \t\"a\xff";
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (auto length = random() % 12; length > 0; --length) text += alphabet[random() % alphabet.size()];
    const auto frames = ParseFrameList(text);
    EXPECT_TRUE(!frames || std::ranges::is_sorted(*frames)) << text;
  }
}

}  // namespace
}  // namespace burin::render
