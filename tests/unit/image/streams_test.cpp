// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/crc32.h"
#include "core/image/jpeg_end.h"
#include "core/image/png_stream.h"
#include "core/image/tiff_stream.h"
#include "tests/unit/image/tiny_tiff.h"

namespace burin::image {
namespace {

using Bytes = std::vector<std::byte>;

Bytes Make(std::initializer_list<int> values) {
  Bytes bytes;
  for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

TEST(JpegEnd, FindsTheEndBehindScanData) {
  EXPECT_TRUE(ReachesJpegEnd(Make({0xFF, 0xD8, 0xFF, 0xDA, 0, 3, 1, 7, 0xFF, 0x00, 8, 0xFF, 0xD0, 9, 0xFF, 0xD9})));
  EXPECT_TRUE(ReachesJpegEnd(Make({0xFF, 0xD8, 0xFF, 0xDA, 0, 3, 1, 7, 0xFF, 0xFF, 0xFF, 0xD9, 1, 2, 3})));
}

TEST(JpegEnd, IsNotFooledByAThumbnail) {
  EXPECT_FALSE(ReachesJpegEnd(Make({0xFF, 0xD8, 0xFF, 0xE1, 0, 6, 0xFF, 0xD8, 0xFF, 0xD9, 0xFF, 0xDA, 0, 3, 1, 7, 8})));
}

TEST(JpegEnd, MissesItInTruncatedData) {
  EXPECT_FALSE(ReachesJpegEnd(Make({0xFF, 0xD8})));
  EXPECT_FALSE(ReachesJpegEnd(Make({0xFF, 0xD8, 0xFF, 0xE0})));
  EXPECT_FALSE(ReachesJpegEnd(Make({0xFF, 0xD8, 0xFF, 0xE0, 0xFF, 0xFF, 0xFF, 0xD9})));
  EXPECT_FALSE(ReachesJpegEnd({}));
}

void AddChunk(Bytes& file, std::string_view type, std::size_t length) {
  Bytes body;
  for (const char c : type) body.push_back(static_cast<std::byte>(c));
  body.resize(4 + length, std::byte{1});
  const auto put = [&file](std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) file.push_back(static_cast<std::byte>(value >> shift));
  };
  put(static_cast<std::uint32_t>(length));
  file.insert(file.end(), body.begin(), body.end());
  put(base::Crc32(body));
}

Bytes Png(std::initializer_list<std::string_view> types) {
  Bytes file(8, std::byte{0});
  for (const std::string_view type : types) AddChunk(file, type, type == "IEND" ? 0 : 5);
  return file;
}

TEST(PngStream, KeepsThePicturesChunksOnly) {
  const auto picture =
      PngPicture(Png({"IHDR", "iCCP", "PLTE", "tEXt", "tRNS", "IDAT", "IDAT", "tIME", "eXIf", "IEND"}));
  ASSERT_TRUE(picture.has_value()) << picture.error();
  EXPECT_EQ(*picture, Png({"IHDR", "PLTE", "tRNS", "IDAT", "IDAT", "eXIf", "IEND"}));
}

TEST(PngStream, TellsTruncationAndDamage) {
  Bytes file = Png({"IHDR", "IDAT", "IEND"});
  EXPECT_EQ(PngPicture(std::span(file).first(40)).error(), "the PNG data ends too early, in chunk IDAT");
  EXPECT_EQ(PngPicture(std::span(file).first(file.size() - 12)).error(), "the PNG data ends too early");
  EXPECT_EQ(PngPicture(std::span(file).first(4)).error(), "the PNG data ends too early");
  file[36] = std::byte{2};
  EXPECT_EQ(PngPicture(file).error(), "PNG chunk IDAT is damaged: its checksum is wrong");
}

TEST(TiffStream, KnowsWholeFiles) {
  const Bytes pixels(12, std::byte{3});
  const Bytes file = test::MakeTiff({.width = 2, .height = 2}, pixels);
  EXPECT_TRUE(TiffIsWhole(file));
  EXPECT_TRUE(TiffIsWhole(Make({1, 2, 3, 4, 5, 6, 7, 8})));
  for (std::size_t size = 8; size < file.size(); ++size) {
    ASSERT_FALSE(TiffIsWhole(std::span(file).first(size))) << size;
  }
}

TEST(TiffStream, RefusesDataBehindTheEnd) {
  const Bytes pixels(12, std::byte{3});
  // The height of the strip stays, its byte count says more than the file has.
  Bytes file = test::MakeTiff({.width = 2, .height = 2}, pixels);
  const Bytes needle = Make({279 & 255, 279 >> 8, 4, 0, 1, 0, 0, 0});
  const auto found = std::ranges::search(file, needle);
  ASSERT_FALSE(found.empty());
  *(found.end() + 1) = std::byte{0x7F};
  EXPECT_FALSE(TiffIsWhole(file));
}

TEST(TiffStream, RemovesTheDate) {
  const Bytes pixels(12, std::byte{3});
  const std::string_view year = "2026:01";
  const auto has_year = [&](const Bytes& file) {
    return !std::ranges::search(file, std::as_bytes(std::span(year))).empty();
  };
  Bytes dated = test::MakeTiff({.width = 2, .height = 2, .date = true}, pixels);
  ASSERT_TRUE(has_year(dated));
  RemoveTiffDate(dated);
  EXPECT_FALSE(has_year(dated));
  EXPECT_TRUE(TiffIsWhole(dated));
  // Entries are what they are without the tag; only the padding behind the directory differs.
  Bytes plain = test::MakeTiff({.width = 2, .height = 2}, pixels);
  std::fill_n(plain.begin() + 8 + 12 + 6, 20, std::byte{0});
  plain.resize(dated.size());
  EXPECT_EQ(dated, plain);
}

TEST(TiffStream, LeavesOtherBytesAlone) {
  Bytes bytes = Make({'I', 'I', 42, 0, 255, 255, 255, 255, 1});
  const Bytes before = bytes;
  RemoveTiffDate(bytes);
  EXPECT_EQ(bytes, before);
}

}  // namespace
}  // namespace burin::image
