// SPDX-License-Identifier: Apache-2.0
#include "core/video/video_module.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/unit/base/temporary_folder.h"
#include "tests/unit/video/stream_file.h"

namespace burin::video {
namespace {

using image::Image;
using test::SmoothFrame;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Videos : public testing::Test {
 protected:
  void SetUp() override {
    const auto module = LoadVideoModule();
    ASSERT_TRUE(module.has_value()) << module.error().message;
    module_ = *module;
  }

  void WriteVideo(const std::string& name, int frames, int width = 64, int height = 48,
                  FrameRate rate = {24000, 1001}) {
    auto writer = module_->OpenWriter(folder_.File(name), {width, height, rate, Chroma::k420});
    ASSERT_TRUE(writer.has_value()) << writer.error().message;
    for (int i = 0; i < frames; ++i) ASSERT_TRUE((*writer)->Write(SmoothFrame(width, height, i)).has_value());
    const auto finished = (*writer)->Finish();
    ASSERT_TRUE(finished.has_value()) << finished.error().message;
  }

  // The frames that could be read, and the error that ended them.
  struct Frames {
    VideoInfo info;
    std::vector<Image> frames;
    std::string error;
  };
  Frames ReadVideo(const std::string& path) {
    Frames result;
    const auto reader = module_->OpenReader(path);
    if (!reader) {
      EXPECT_EQ(reader.error().kind, ErrorKind::kInput);
      result.error = reader.error().message;
      return result;
    }
    result.info = (*reader)->info();
    for (;;) {
      Image frame;
      const auto got = (*reader)->Next(frame);
      if (!got) result.error = got.error().message;
      if (!got || !*got) return result;
      result.frames.push_back(std::move(frame));
    }
  }

  void Cut(const std::string& name, double part) {
    const auto bytes = test::ReadAllBytes(folder_.File(name));
    test::WriteAllBytes(folder_.File(name),
                        std::span(bytes).first(static_cast<std::size_t>(static_cast<double>(bytes.size()) * part)));
  }

  Error OpenError(const std::string& path, int width, int height) {
    const auto writer = module_->OpenWriter(path, {width, height, {24, 1}, Chroma::k420});
    return writer ? Error{} : writer.error();
  }

  VideoModule* module_ = nullptr;
  test::TemporaryFolder folder_;
};

TEST(VideoModule, LoadsOnceAndTellsItsVersion) {
  const auto module = LoadVideoModule();
  ASSERT_TRUE(module.has_value()) << module.error().message;
  EXPECT_EQ(*module, *LoadVideoModule());
  EXPECT_TRUE((*module)->Versions().starts_with("OpenCV 4.")) << (*module)->Versions();
}

TEST(VideoModule, KnowsVideoPaths) {
  EXPECT_TRUE(IsVideoPath("a/b.MKV"));
  EXPECT_TRUE(IsVideoPath("clip.webm"));
  EXPECT_FALSE(IsVideoPath("clip.y4m.png"));
  EXPECT_FALSE(IsVideoPath("mkv"));
}

TEST_F(Videos, Ffv1IsLossless) {
  for (const char* name : {"a.mkv", "a.avi"}) {
    WriteVideo(name, 5);
    const Frames read = ReadVideo(folder_.File(name));
    EXPECT_EQ(read.error, "");
    EXPECT_EQ(read.info.rate.numerator, 24000) << name;
    EXPECT_EQ(read.info.rate.denominator, 1001) << name;
    EXPECT_EQ(read.info.frame_count, 5) << name;
    ASSERT_EQ(read.frames.size(), 5U) << name;
    for (int i = 0; i < 5; ++i) {
      EXPECT_TRUE(read.frames[static_cast<std::size_t>(i)].pixels == SmoothFrame(64, 48, i).pixels)
          << name << " frame " << i;
    }
  }
}

TEST_F(Videos, LossyFormatsStayNearAndKeepEveryFrame) {
  constexpr int kLossy = 12;  // of smooth pictures
  for (const char* name : {"a.mp4", "a.mov", "a.m4v", "a.webm"}) {
    WriteVideo(name, 12);
    const Frames read = ReadVideo(folder_.File(name));
    EXPECT_EQ(read.error, "") << name;
    ASSERT_EQ(read.frames.size(), 12U) << name;
    EXPECT_EQ(read.info.rate.numerator, 24000) << name;
    for (int i = 0; i < 12; ++i) {
      const Image expected = SmoothFrame(64, 48, i);
      const Image& frame = read.frames[static_cast<std::size_t>(i)];
      ASSERT_EQ(frame.pixels.size(), expected.pixels.size());
      for (std::size_t s = 0; s < expected.pixels.size(); ++s) {
        ASSERT_NEAR(frame.As<std::uint8_t>()[s], expected.As<std::uint8_t>()[s], kLossy) << name << " frame " << i;
      }
    }
  }
}

TEST_F(Videos, WritingTwiceGivesTheSameBytes) {
  for (const std::string extension : {".mkv", ".avi", ".mp4", ".mov", ".webm"}) {
    WriteVideo("a" + extension, 4);
    usleep(1'100'000);  // a clock time would differ
    WriteVideo("b" + extension, 4);
    EXPECT_TRUE(test::ReadAllBytes(folder_.File("a" + extension)) == test::ReadAllBytes(folder_.File("b" + extension)))
        << extension;
  }
}

TEST_F(Videos, MatroskaChecksumsHold) {
  if (!test::HasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  for (const char* name : {"a.mkv", "a.webm"}) {
    WriteVideo(name, 4);
    const std::string log = folder_.File("log");
    ASSERT_EQ(std::system(("ffmpeg -nostdin -v error -err_detect crccheck+explode -i " + folder_.File(name) +
                           " -f null - 2>" + log)
                              .c_str()),
              0);
    EXPECT_TRUE(test::ReadAllBytes(log).empty()) << name;
  }
  const auto webm = test::ReadAllBytes(folder_.File("a.webm"));
  EXPECT_NE(std::string_view(reinterpret_cast<const char*>(webm.data()), 64).find("webm"), std::string_view::npos);
}

TEST_F(Videos, OddSizesAreRefusedWithAlternatives) {
  for (const char* name : {"a.mkv", "a.mp4"}) {
    const Error error = OpenError(folder_.File(name), 65, 48);
    EXPECT_EQ(error.kind, ErrorKind::kUsage);
    EXPECT_EQ(error.message,
              "cannot write '" + folder_.File(name) +
                  "': OpenCV writes videos of even width and height only, not 65x48; choose an even --size, write "
                  "an image sequence (name.####.png), or y4m to - and pipe it into ffmpeg");
  }
  EXPECT_THAT(folder_.Names(), IsEmpty());
}

TEST_F(Videos, UnknownContainersAreRefusedWithAlternatives) {
  const Error error = OpenError("a.mpg", 64, 48);
  EXPECT_EQ(error.kind, ErrorKind::kUsage);
  EXPECT_EQ(error.message,
            "cannot write 'a.mpg': videos are written as .mkv or .avi (FFV1, lossless), .mp4 or .mov (H.264) and .webm "
            "(VP9); for "
            "others write y4m to - and pipe it into ffmpeg");
}

TEST_F(Videos, UnwritablePathIsAnError) {
  const Error error = OpenError("/no/such/a.mkv", 64, 48);
  EXPECT_EQ(error.kind, ErrorKind::kFailed);
  EXPECT_EQ(error.message, "cannot write '/no/such/a.mkv': the folder '/no/such' does not exist");
}

TEST_F(Videos, AnotherSizeOrTypeIsAnErrorNotADroppedFrame) {
  auto writer = module_->OpenWriter(folder_.File("a.mkv"), {64, 48, {24, 1}, Chroma::k420});
  ASSERT_TRUE(writer.has_value());
  ASSERT_TRUE((*writer)->Write(SmoothFrame(64, 48, 0)).has_value());
  EXPECT_EQ((*writer)->Write(SmoothFrame(64, 50, 0)).error().message,
            "cannot write '" + folder_.File("a.mkv") +
                "': frame 2 is 64x50 with 4 channels of 8 bits, the video takes 64x48 8-bit RGB or RGBA");
  EXPECT_FALSE((*writer)->Write(image::ToType(SmoothFrame(64, 48, 0), image::SampleType::kU16)).has_value());
  EXPECT_TRUE((*writer)->Write(image::ToChannels(SmoothFrame(64, 48, 1), 3)).has_value());
}

TEST_F(Videos, UnfinishedFilesDisappear) {
  {
    auto writer = module_->OpenWriter(folder_.File("a.mkv"), {64, 48, {24, 1}, Chroma::k420});
    ASSERT_TRUE((*writer)->Write(SmoothFrame(64, 48, 0)).has_value());
    EXPECT_EQ(folder_.Names().size(), 1U);
  }
  EXPECT_THAT(folder_.Names(), IsEmpty());
  auto writer = module_->OpenWriter(folder_.File("a.mkv"), {64, 48, {24, 1}, Chroma::k420});
  EXPECT_EQ((*writer)->Finish().error().message, "cannot write '" + folder_.File("a.mkv") + "': it got no frames");
}

TEST_F(Videos, FullDiskIsAnErrorAndLeavesNothing) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // OpenCV's threads don't live through a fork
  for (const char* name : {"a.mkv", "a.avi", "a.mp4"}) {
    const auto write_with_limit = [&] {
      signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{20000, 20000};
      setrlimit(RLIMIT_FSIZE, &limit);
      std::string error;
      if (auto writer = module_->OpenWriter(folder_.File(name), {256, 256, {24, 1}, Chroma::k420}); writer) {
        Image noise = SmoothFrame(256, 256, 0);
        std::uint32_t state = 1;
        for (int i = 0; i < 20; ++i) {
          for (std::uint8_t& v : noise.As<std::uint8_t>())
            v = static_cast<std::uint8_t>((state = state * 1664525 + 1013904223) >> 24);
          static_cast<void>((*writer)->Write(noise));
        }
        if (const auto finished = (*writer)->Finish(); !finished) error = finished.error().message;
      }
      const bool refused = error.starts_with("cannot write '" + folder_.File(name) + "': ");
      const bool nothing_left = folder_.Names().empty();
      std::filesystem::remove_all(folder_.path());  // the child's own
      _exit(refused && nothing_left ? 0 : 1);
    };
    EXPECT_EXIT(write_with_limit(), testing::ExitedWithCode(0), "") << name;
  }
}

TEST_F(Videos, TruncatedFilesNameTheFrame) {
  for (const char* name : {"a.mkv", "a.avi"}) {
    WriteVideo(name, 30);
    Cut(name, 0.6);
    const Frames read = ReadVideo(folder_.File(name));
    EXPECT_FALSE(read.frames.empty()) << name;
    EXPECT_LT(read.frames.size(), 30U) << name;
    EXPECT_THAT(read.error, StartsWith("cannot read '" + folder_.File(name) + "': it breaks off after frame " +
                                       std::to_string(read.frames.size()) + ", but says that it has 30"));
  }
  WriteVideo("a.mp4", 30);
  Cut("a.mp4", 0.3);  // its index is at the end
  EXPECT_EQ(ReadVideo(folder_.File("a.mp4")).error,
            "cannot read '" + folder_.File("a.mp4") + "': it is no whole video (moov atom not found)");
}

TEST_F(Videos, WhatIsNoVideoIsAnError) {
  const auto error = [&](const std::string& content) {
    test::WriteText(folder_.File("a.mp4"), content);
    return ReadVideo(folder_.File("a.mp4")).error;
  };
  EXPECT_EQ(error(""), "cannot read '" + folder_.File("a.mp4") + "': it is empty");
  EXPECT_THAT(error("no video at all"), StartsWith("cannot read '" + folder_.File("a.mp4") + "': it "));
  EXPECT_EQ(ReadVideo(folder_.File("none.mp4")).error,
            "cannot read '" + folder_.File("none.mp4") + "': No such file or directory");
  EXPECT_EQ(ReadVideo(folder_.path()).error, "cannot read '" + folder_.path() + "': it is a folder");
}

TEST_F(Videos, ColonInANameIsNoProtocol) {
  WriteVideo("file:a.mkv", 2);
  EXPECT_EQ(ReadVideo(folder_.File("file:a.mkv")).frames.size(), 2U);
}

TEST_F(Videos, RotationIsHonoured) {
  if (!test::HasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  WriteVideo("a.mp4", 3);
  ASSERT_EQ(std::system(("ffmpeg -nostdin -v error -y -i " + folder_.File("a.mp4") +
                         " -c copy -metadata:s:v:0 rotate=90 " + folder_.File("r.mp4"))
                            .c_str()),
            0);
  const Frames read = ReadVideo(folder_.File("r.mp4"));
  EXPECT_EQ(read.info.width, 48);
  EXPECT_EQ(read.info.height, 64);
  ASSERT_EQ(read.frames.size(), 3U);
  EXPECT_EQ(read.frames[0].width, 48);
}

TEST_F(Videos, OddSizesAreRead) {
  if (!test::HasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  ASSERT_EQ(
      std::system(("ffmpeg -nostdin -v error -y -f lavfi -i color=red:s=40x30:d=0.2,format=bgr0,crop=33:21 -c:v ffv1 " +
                   folder_.File("odd.mkv"))
                      .c_str()),
      0);
  const Frames read = ReadVideo(folder_.File("odd.mkv"));
  EXPECT_EQ(read.error, "");
  ASSERT_FALSE(read.frames.empty());
  EXPECT_EQ(read.info.width, 33);
  EXPECT_EQ(read.info.height, 21);
  EXPECT_GE(read.frames[0].As<std::uint8_t>()[0], 253);
  EXPECT_LE(read.frames[0].As<std::uint8_t>()[2], 2);
}

TEST_F(Videos, StderrStaysQuiet) {
  WriteVideo("a.mkv", 20);
  Cut("a.mkv", 0.7);
  testing::internal::CaptureStderr();
  EXPECT_NE(ReadVideo(folder_.File("a.mkv")).error, "");
  test::WriteText(folder_.File("b.mp4"), std::string(2000, 'x'));
  EXPECT_NE(ReadVideo(folder_.File("b.mp4")).error, "");
  WriteVideo("c.webm", 2);
  WriteVideo("c.mp4", 2);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(Videos, SharedVideosAreReadToTheirEnd) {
  for (const char* name : {"video/rabbit320.mp4", "video/rabbit320.webm"}) {
    const std::string path = test::SharedData(name);
    if (path.empty()) GTEST_SKIP() << "no shared data";
    const Frames read = ReadVideo(path);
    EXPECT_EQ(read.error, "");
    EXPECT_EQ(read.frames.size(), 234U);
    EXPECT_EQ(read.info.rate.numerator, 30);
    EXPECT_EQ(read.info.width, 320);
  }
}

}  // namespace
}  // namespace burin::video
