// SPDX-License-Identifier: Apache-2.0
// Random and damaged streams end in an error or in frames of the size that the header told; never in anything else.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>

#include "core/base/crc32.h"
#include "core/video/matroska.h"
#include "core/video/y4m.h"
#include "core/video/y4m_header.h"
#include "core/video/ycbcr.h"
#include "tests/unit/video/stream_file.h"

namespace burin::video {
namespace {

constexpr unsigned kSeed = 99;

void ReadThrough(const std::string& content) {
  const test::StreamFile file(content);
  const auto reader = OpenY4mReader(file.descriptor(), "stream");
  if (!reader) {
    ASSERT_EQ(reader.error().kind, ErrorKind::kInput) << "seed " << kSeed;
    return;
  }
  image::Image frame;
  for (int frames = 0; frames < 100; ++frames) {
    const auto got = (*reader)->Next(frame);
    if (!got || !*got) return;
    ASSERT_EQ(frame.pixels.size(), static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height) * 4);
  }
}

TEST(Y4mGarbage, RandomHeadersNeverFault) {
  std::mt19937 random(kSeed);
  constexpr std::array<const char*, 14> kTokens{"W",    "H",         "F",    "I",     "A",  "C", "X",
                                                "C420", "C444alpha", "C410", "Cmono", "It", " ", "W9"};
  for (int i = 0; i < 3000; ++i) {
    std::string content = "YUV4MPEG2";
    for (unsigned t = 0; t < random() % 8; ++t) {
      content += " ";
      content += kTokens[random() % kTokens.size()];
      if (random() % 2 == 0) content += std::to_string(random() % 20);
      if (random() % 5 == 0) content += static_cast<char>(random());
      if (random() % 9 == 0) content += ":" + std::to_string(random() % 3);
    }
    content += "\nFRAME\n" + std::string(random() % 2000, 'p') + "FRAME\n";
    ReadThrough(content);
  }
}

TEST(Y4mGarbage, DamagedStreamsNeverFault) {
  std::mt19937 random(kSeed);
  std::string whole = "YUV4MPEG2 W9 H7 F25:1 It C420jpeg\n";
  for (int i = 0; i < 4; ++i) whole += "FRAME\n" + std::string(9 * 7 + 2 * 5 * 4, static_cast<char>('a' + i));
  for (int i = 0; i < 3000; ++i) {
    std::string content = whole;
    for (unsigned hit = 0; hit < 1 + random() % 5; ++hit)
      content[random() % content.size()] = static_cast<char>(random());
    if (random() % 3 == 0) content.resize(random() % content.size());
    ReadThrough(content);
  }
}

TEST(MatroskaGarbage, NeverFaultsAndEnds) {
  std::mt19937 random(kSeed);
  // An EBML header, a segment of an info, tracks and a cluster of two blocks.
  std::string whole("\x1A\x45\xDF\xA3\x8B\x42\x82\x88matroska", 16);
  whole += std::string("\x18\x53\x80\x67\xB2", 5);
  whole += std::string("\x15\x49\xA9\x66\x93\x73\xA4\x90", 8) + std::string(16, 'u');
  whole += std::string("\x16\x54\xAE\x6B\x8A\xAE\x88\x73\xC5\x85", 10) + "trackpad";
  whole.resize(whole.size() - 3);
  whole += std::string("\x1F\x43\xB6\x75\x86\xA3\x81.\xA3\x81.", 11);
  const FrameRate rate{24, 1};
  {
    const test::StreamFile file(whole);
    const auto frames = SettleMatroska(file.descriptor(), "a.mkv", rate, MatroskaKind::kWebm);
    ASSERT_TRUE(frames.has_value()) << frames.error().message;
    EXPECT_EQ(*frames, 2);
    const std::string settled = file.Content();
    EXPECT_EQ(settled.find("uuuu"), std::string::npos);
    EXPECT_EQ(settled.find("track"), std::string::npos);
    EXPECT_EQ(settled.substr(5, 11), std::string("\x42\x82\x84webm\xEC\x82\0\0", 11));
    EXPECT_FALSE(MatroskaIsCutOff(file.descriptor()));
  }
  {
    const test::StreamFile file(whole.substr(0, whole.size() - 1));
    EXPECT_TRUE(MatroskaIsCutOff(file.descriptor()));
    EXPECT_FALSE(SettleMatroska(file.descriptor(), "a.mkv", rate, MatroskaKind::kMatroska).has_value());
  }
  for (int i = 0; i < 3000; ++i) {
    std::string content = whole;
    for (unsigned hit = 0; hit < 1 + random() % 4; ++hit)
      content[random() % content.size()] = static_cast<char>(random());
    if (random() % 4 == 0) content.resize(random() % content.size());
    const test::StreamFile file(content);
    static_cast<void>(MatroskaIsCutOff(file.descriptor()));
    static_cast<void>(SettleMatroska(file.descriptor(), "a.mkv", rate, MatroskaKind::kWebm));
    ASSERT_EQ(file.Content().size(), content.size()) << "seed " << kSeed;
  }
}

// Every colour that comes from R'G'B' goes through 4:4:4 with an error of at most two: 219 steps for 256 values.
TEST(Ycbcr, RandomColoursComeBackWithinTwo) {
  std::mt19937 random(kSeed);
  const YcbcrLayout layout = LayoutOf(1021, 3, Chroma::k444);
  std::vector<std::uint8_t> rgba(layout.luma_bytes() * 4);
  for (std::uint8_t& v : rgba) v = static_cast<std::uint8_t>(random());
  std::vector<std::uint8_t> planes(layout.frame_bytes()), back(rgba.size());
  YcbcrFromRgba(layout, rgba, planes);
  RgbaFromYcbcr(layout, false, planes, back);
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    if (i % 4 == 3) {
      ASSERT_EQ(back[i], 255);
    } else {
      ASSERT_NEAR(back[i], rgba[i], 2) << "seed " << kSeed << " sample " << i;
    }
  }
}

// Against the formulas of BT.601 in floating point.
TEST(Ycbcr, FixedPointIsTheRoundedFormula) {
  std::mt19937 random(kSeed);
  const YcbcrLayout layout = LayoutOf(997, 1, Chroma::k444);
  std::vector<std::uint8_t> rgba(layout.luma_bytes() * 4), planes(layout.frame_bytes());
  for (std::uint8_t& v : rgba) v = static_cast<std::uint8_t>(random());
  YcbcrFromRgba(layout, rgba, planes);
  constexpr double kRounding = 0.51;  // half, and a little for coefficients of 16 bits
  for (std::size_t i = 0; i < 997; ++i) {
    const double r = rgba[4 * i] / 255.0, g = rgba[4 * i + 1] / 255.0, b = rgba[4 * i + 2] / 255.0;
    const double y = 0.299 * r + 0.587 * g + 0.114 * b;
    ASSERT_NEAR(planes[i], 16.0 + 219.0 * y, kRounding);
    ASSERT_NEAR(planes[997 + i], 128.0 + 224.0 * (b - y) / 1.772, kRounding);
    ASSERT_NEAR(planes[2 * 997 + i], 128.0 + 224.0 * (r - y) / 1.402, kRounding);
  }
}

}  // namespace
}  // namespace burin::video
