// SPDX-License-Identifier: Apache-2.0
#include "core/video/y4m.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/unit/base/temporary_folder.h"
#include "tests/unit/video/stream_file.h"

namespace burin::video {
namespace {

using image::Image;
using test::StreamFile;
using testing::ElementsAre;
using testing::HasSubstr;

std::string HeaderError(const std::string& stream) {
  const StreamFile file(stream);
  const auto reader = OpenY4mReader(file.descriptor(), "-");
  if (reader) return "it was read";
  EXPECT_EQ(reader.error().kind, ErrorKind::kInput);
  return reader.error().message;
}

VideoInfo Info(const std::string& header) {
  const StreamFile file(header + "\n");
  const auto reader = OpenY4mReader(file.descriptor(), "-");
  EXPECT_TRUE(reader.has_value()) << reader.error().message;
  return reader ? (*reader)->info() : VideoInfo{};
}

std::vector<int> FirstFrame(const std::string& stream) {
  const StreamFile file(stream);
  const auto reader = OpenY4mReader(file.descriptor(), "-");
  EXPECT_TRUE(reader.has_value()) << reader.error().message;
  Image frame;
  const auto got = (*reader)->Next(frame);
  EXPECT_TRUE(got.has_value() && *got) << (got ? "no frame" : got.error().message);
  std::vector<int> samples;
  for (const std::uint8_t v : frame.As<std::uint8_t>()) samples.push_back(v);
  return samples;
}

std::string FrameError(const std::string& stream) {
  const StreamFile file(stream);
  const auto reader = OpenY4mReader(file.descriptor(), "clip.y4m");
  EXPECT_TRUE(reader.has_value()) << reader.error().message;
  Image frame;
  for (;;) {
    const auto got = (*reader)->Next(frame);
    if (!got) return got.error().message;
    if (!*got) return "it ended";
  }
}

TEST(Y4mHeader, TellsSizeRateAndChroma) {
  const VideoInfo info = Info("YUV4MPEG2 W1920 H1080 F30000:1001 Ip A1:1 C420jpeg XYSCSS=420JPEG");
  EXPECT_EQ(info.width, 1920);
  EXPECT_EQ(info.height, 1080);
  EXPECT_EQ(info.rate.numerator, 30000);
  EXPECT_EQ(info.rate.denominator, 1001);
  EXPECT_EQ(info.chroma, Chroma::k420);
  EXPECT_FALSE(info.frame_count.has_value());
  EXPECT_EQ(Info("YUV4MPEG2 W2 H2 F25:1 C444").chroma, Chroma::k444);
  EXPECT_EQ(Info("YUV4MPEG2 W2 H2 F25:1 C422 It").chroma, Chroma::k422);
  EXPECT_EQ(Info("YUV4MPEG2 W2 H2").chroma, Chroma::k420);
}

TEST(Y4mHeader, UnknownRateIsTwentyFive) {
  EXPECT_EQ(Info("YUV4MPEG2 W2 H2 F0:0").rate.numerator, 25);
  EXPECT_EQ(Info("YUV4MPEG2 W2 H2").rate.numerator, 25);
}

TEST(Y4mHeader, RefusesWhatItIsNot) {
  EXPECT_EQ(HeaderError(""), "cannot read '-': it is empty, not a YUV4MPEG2 stream");
  EXPECT_EQ(HeaderError("RIFF\x01\x02 garbage\n"),
            "cannot read '-': it is no YUV4MPEG2 stream: it begins with 'RIFF?? garbage'");
  EXPECT_EQ(HeaderError("YUV4MPEG2 W2 H2"), "cannot read '-': the stream breaks off in its header");
  EXPECT_EQ(HeaderError("YUV4MPEG2 H2\n"), "cannot read '-': its header has no width");
  EXPECT_EQ(HeaderError("YUV4MPEG2 W2\n"), "cannot read '-': its header has no height");
  EXPECT_EQ(HeaderError("YUV4MPEG2 W-2 H2\n"), "cannot read '-': its header has the size 'W-2'");
  EXPECT_EQ(HeaderError("YUV4MPEG2 W2x H2\n"), "cannot read '-': its header has the size 'W2x'");
  EXPECT_EQ(HeaderError("YUV4MPEG2 W99999999999 H2\n"), "cannot read '-': its header has the size 'W99999999999'");
  EXPECT_EQ(HeaderError("YUV4MPEG2 W2147483647 H2147483647\n"),
            "cannot read '-': its size 2147483647x2147483647 is over 268435456 pixels");
  EXPECT_EQ(HeaderError("YUV4MPEG2 W2 H2 F25\n"), "cannot read '-': its frame rate 'F25' is no ratio like F30000:1001");
  EXPECT_EQ(HeaderError("YUV4MPEG2 W2 H2 F25:0\n"),
            "cannot read '-': its frame rate 'F25:0' is no ratio like F30000:1001");
  EXPECT_EQ(HeaderError("YUV4MPEG2 W2 H2 Ix\n"), "cannot read '-': its interlacing 'Ix' is none of Ip, It, Ib, Im");
  EXPECT_EQ(HeaderError("YUV4MPEG2 W2 H2 C420p10 XYSCSS=420P10\n"),
            "cannot read '-': its colour space 'C420p10' is not read; 8-bit C420, C422, C444 and Cmono are (ffmpeg's "
            "-pix_fmt "
            "yuv420p, yuv422p, yuv444p, gray)");
  EXPECT_EQ(HeaderError("YUV4MPEG2 " + std::string(5000, 'X')),
            "cannot read '-': its header is longer than 4096 bytes");
}

// Values of BT.601-7: black Y 16, white 235, and 8-bit red as (81, 90, 240).
TEST(Y4mReader, LimitedRangeFollowsBt601) {
  const std::string header = "YUV4MPEG2 W3 H1 F25:1 C444\nFRAME\n";
  const std::string planes =
      "\x10\xEB\x51"
      "\x80\x80\x5A"
      "\x80\x80\xF0";
  EXPECT_THAT(FirstFrame(header + planes), ElementsAre(0, 0, 0, 255, 255, 255, 255, 255, 254, 0, 0, 255));
}

TEST(Y4mReader, FullRangeFollowsJfif) {
  const std::string header = "YUV4MPEG2 W3 H1 F25:1 C444 XCOLORRANGE=FULL\nFRAME\n";
  const std::string planes = std::string("\0\xFF\x4C", 3) + "\x80\x80\x55" + "\x80\x80\xFF";
  EXPECT_THAT(FirstFrame(header + planes), ElementsAre(0, 0, 0, 255, 255, 255, 255, 255, 254, 0, 0, 255));
}

TEST(Y4mReader, MonoIsGrey) {
  EXPECT_THAT(FirstFrame("YUV4MPEG2 W2 H1 F25:1 Cmono\nFRAME\n\x10\xEB"),
              ElementsAre(0, 0, 0, 255, 255, 255, 255, 255));
}

TEST(Y4mReader, AlphaPlaneIsSkipped) {
  const std::string frame = "FRAME\n\x10\x80\x80\x33";
  EXPECT_THAT(FirstFrame("YUV4MPEG2 W1 H1 F25:1 C444alpha\n" + frame + frame), ElementsAre(0, 0, 0, 255));
}

// Which chroma row colours a picture row: progressive pairs rows, interlaced pairs every other one.
TEST(Y4mReader, InterlacedChromaBelongsToItsField) {
  const std::string luma(4, '\x80');
  const std::string planes = luma + "\x80\x80" + "\x80\xF0";  // second chroma row is red
  const auto red_rows = [&](const std::string& header, const std::string& frame) {
    const auto samples = FirstFrame("YUV4MPEG2 W1 H4 F25:1 C420jpeg " + header + "\n" + frame + "\n" + planes);
    std::vector<int> rows;
    for (int row = 0; row < 4; ++row) rows.push_back(samples[static_cast<std::size_t>(row) * 4] > 200);
    return rows;
  };
  EXPECT_THAT(red_rows("Ip", "FRAME"), ElementsAre(0, 0, 1, 1));
  EXPECT_THAT(red_rows("It", "FRAME"), ElementsAre(0, 1, 0, 1));
  EXPECT_THAT(red_rows("Im", "FRAME Ippi"), ElementsAre(0, 1, 0, 1));
  EXPECT_THAT(red_rows("Im", "FRAME Ippp"), ElementsAre(0, 0, 1, 1));
}

TEST(Y4mReader, SubsampledChromaCoversItsPixels) {
  for (const auto& [tag, planes] : {std::pair<std::string, std::string>{"411",
                                                                        "\x80\x80\x80\x80\x80"
                                                                        "\x80\x80"
                                                                        "\xF0\x80"},
                                    {"422",
                                     "\x80\x80\x80\x80\x80"
                                     "\x80\x80\x80"
                                     "\xF0\xF0\x80"}}) {
    const auto samples = FirstFrame("YUV4MPEG2 W5 H1 F25:1 C" + tag + "\nFRAME\n" + planes);
    for (std::size_t x = 0; x < 5; ++x) EXPECT_EQ(samples[4 * x] > 200, x < 4) << tag << " " << x;
  }
}

TEST(Y4mReader, NamesTheFrameThatBreaksOff) {
  const std::string header = "YUV4MPEG2 W2 H2 F25:1\n";
  const std::string frame = "FRAME\nYYYYUV";
  EXPECT_EQ(FrameError(header + frame + frame), "it ended");
  EXPECT_EQ(FrameError(header), "it ended");
  EXPECT_EQ(FrameError(header + frame + "FRAME\nYYYY"), "cannot read 'clip.y4m': the stream breaks off in frame 2");
  EXPECT_EQ(FrameError(header + frame + frame + "FRA"), "cannot read 'clip.y4m': the stream breaks off in frame 3");
  EXPECT_EQ(FrameError(header + "FRAME Ixx"), "cannot read 'clip.y4m': the stream breaks off in frame 1");
  EXPECT_EQ(FrameError(header + frame + "junk\n"), "cannot read 'clip.y4m': frame 2 does not begin with FRAME");
  EXPECT_EQ(FrameError(header + "FRAME " + std::string(5000, 'X')),
            "cannot read 'clip.y4m': the header of frame 1 is longer than 4096 bytes");
}

// 16384 x 16384 would be 400 MB of planes and 1 GB of pixels; nothing of that may be set aside for 60 bytes.
TEST(Y4mReader, BelievesAHugeSizeOnlyAsDataArrives) {
  EXPECT_EQ(FrameError("YUV4MPEG2 W16384 H16384 F25:1\nFRAME\nshort"),
            "cannot read 'clip.y4m': the stream breaks off in frame 1");
}

TEST(Y4mReader, ReadsFromAPipeAsItComes) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  const std::string first = "YUV4MPEG2 W2 H2 F25:1\nFRAME\nYYYYUVFRAME\n";
  ASSERT_EQ(write(ends[1], first.data(), first.size()), static_cast<ssize_t>(first.size()));
  const auto reader = OpenY4mReader(ends[0], "-");
  ASSERT_TRUE(reader.has_value());
  Image frame;
  EXPECT_TRUE((*reader)->Next(frame).value_or(false));  // before the second frame's data is there
  ASSERT_EQ(write(ends[1], "YYYYUV", 6), 6);
  EXPECT_TRUE((*reader)->Next(frame).value_or(false));
  close(ends[1]);
  EXPECT_FALSE((*reader)->Next(frame).value_or(true));
  close(ends[0]);
}

VideoWriteOptions Options(int width, int height, Chroma chroma) { return {width, height, {24000, 1001}, chroma}; }

TEST(Y4mWriter, WritesHeaderAndPlanes) {
  const StreamFile file;
  const auto writer = OpenY4mWriter(file.descriptor(), "-", Options(1, 1, Chroma::k444));
  ASSERT_TRUE(writer.has_value());
  Image frame = image::MakeImage(1, 1, 4, image::SampleType::kU8, image::Encoding::kDisplay);
  frame.As<std::uint8_t>()[0] = 255;  // red
  ASSERT_TRUE((*writer)->Write(frame).has_value());
  ASSERT_TRUE((*writer)->Finish().has_value());
  EXPECT_EQ(file.Content(), "YUV4MPEG2 W1 H1 F24000:1001 Ip A1:1 C444 XCOLORRANGE=LIMITED\nFRAME\n\x51\x5A\xF0");
}

TEST(Y4mWriter, TakesRgbToo) {
  Image rgb = image::ToChannels(test::SmoothFrame(6, 5, 1), 3);
  const StreamFile a, b;
  ASSERT_TRUE((*OpenY4mWriter(a.descriptor(), "-", Options(6, 5, Chroma::k420)))->Write(rgb).has_value());
  ASSERT_TRUE((*OpenY4mWriter(b.descriptor(), "-", Options(6, 5, Chroma::k420)))
                  ->Write(test::SmoothFrame(6, 5, 1))
                  .has_value());
  EXPECT_EQ(a.Content(), b.Content());
}

TEST(Y4mWriter, RefusesOtherSizesAndTypes) {
  const StreamFile file;
  const auto writer = OpenY4mWriter(file.descriptor(), "-", Options(4, 4, Chroma::k444));
  const auto refused = (*writer)->Write(test::SmoothFrame(4, 5, 0));
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().message,
            "cannot write '-': frame 1 is 4x5 with 4 channels of 8 bits, the stream takes 4x4 8-bit RGB or RGBA");
  EXPECT_FALSE((*writer)->Write(image::ToType(test::SmoothFrame(4, 4, 0), image::SampleType::kU16)).has_value());
}

TEST(Y4mWriter, ClosedPipeIsAnError) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  const auto writer = OpenY4mWriter(ends[1], "-", Options(4, 4, Chroma::k444));
  ASSERT_TRUE(writer.has_value());
  close(ends[0]);
  const auto written = (*writer)->Write(test::SmoothFrame(4, 4, 0));
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().kind, ErrorKind::kFailed);
  EXPECT_EQ(written.error().message, "cannot write '-': its reader has closed the pipe (frame 1)");
  close(ends[1]);
}

TEST(Y4m, ColoursComeBackWithinRounding) {
  for (const auto& [chroma, tolerance] : {std::pair{Chroma::k444, 2}, {Chroma::k422, 4}, {Chroma::k420, 5}}) {
    for (const auto& [width, height] : {std::pair{64, 48}, {63, 47}, {1, 1}, {1, 9}, {2, 1}}) {
      const Image frame = test::SmoothFrame(width, height, 3);
      const StreamFile file;
      ASSERT_TRUE((*OpenY4mWriter(file.descriptor(), "-", Options(width, height, chroma)))->Write(frame).has_value());
      file.Rewind();
      Image read;
      ASSERT_TRUE((*OpenY4mReader(file.descriptor(), "-"))->Next(read).value_or(false));
      ASSERT_EQ(read.pixels.size(), frame.pixels.size());
      int worst = 0;
      for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        worst = std::max(worst, std::abs(int{frame.As<std::uint8_t>()[i]} - int{read.As<std::uint8_t>()[i]}));
      }
      // 4:2:0 averages neighbours, which differ by up to 4 in the large picture; tiny ones change quickly.
      EXPECT_LE(worst, width > 9 ? tolerance : 60) << width << "x" << height;
    }
  }
}

// Decoding and encoding again keeps every plane sample to within one, whatever the subsampling.
TEST(Y4m, StreamPassedThroughStaysTheSameWithinOne) {
  for (const Chroma chroma : {Chroma::k420, Chroma::k422, Chroma::k444}) {
    const StreamFile first, second;
    const Image frame = test::SmoothFrame(33, 21, 5);
    ASSERT_TRUE((*OpenY4mWriter(first.descriptor(), "-", Options(33, 21, chroma)))->Write(frame).has_value());
    first.Rewind();
    Image read;
    ASSERT_TRUE((*OpenY4mReader(first.descriptor(), "-"))->Next(read).value_or(false));
    ASSERT_TRUE((*OpenY4mWriter(second.descriptor(), "-", Options(33, 21, chroma)))->Write(read).has_value());
    const std::string a = first.Content(), b = second.Content();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_LE(std::abs(int{static_cast<std::uint8_t>(a[i])} - int{static_cast<std::uint8_t>(b[i])}), 1) << i;
    }
  }
}

// ffmpeg's own conversion of the same colours, both ways.
TEST(Y4m, AgreesWithFfmpeg) {
  if (!test::HasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const test::TemporaryFolder folder;
  const Image frame = test::SmoothFrame(64, 48, 2);
  test::WriteAllBytes(folder.File("in.rgb"), frame.pixels);
  const std::string raw = " -f rawvideo -pix_fmt rgba -s 64x48 -r 24 ";
  const std::string quiet = "ffmpeg -nostdin -v error -y ";
  const std::string accurate = " -sws_flags accurate_rnd+full_chroma_int+full_chroma_inp ";
  ASSERT_EQ(std::system((quiet + raw + "-i " + folder.File("in.rgb") + accurate + "-pix_fmt yuv444p -f yuv4mpegpipe " +
                         folder.File("theirs.y4m"))
                            .c_str()),
            0);
  constexpr int kTolerance = 2;  // of two roundings each way
  const int theirs = open(folder.File("theirs.y4m").c_str(), O_RDONLY);
  Image read;
  ASSERT_TRUE((*OpenY4mReader(theirs, "theirs"))->Next(read).value_or(false));
  close(theirs);
  const int ours = open(folder.File("ours.y4m").c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_TRUE((*OpenY4mWriter(ours, "ours", Options(64, 48, Chroma::k444)))->Write(frame).has_value());
  close(ours);
  ASSERT_EQ(std::system((quiet + "-i " + folder.File("ours.y4m") + accurate + "-f rawvideo -pix_fmt rgba " +
                         folder.File("out.rgb"))
                            .c_str()),
            0);
  const auto back = test::ReadAllBytes(folder.File("out.rgb"));
  ASSERT_EQ(back.size(), frame.pixels.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    const int original = frame.As<std::uint8_t>()[i];
    ASSERT_NEAR(original, read.As<std::uint8_t>()[i], kTolerance) << i;
    ASSERT_NEAR(original, std::to_integer<int>(back[i]), kTolerance) << i;
  }
}

}  // namespace
}  // namespace burin::video
