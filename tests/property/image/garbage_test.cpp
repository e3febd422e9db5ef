// SPDX-License-Identifier: Apache-2.0
// Damaged files either read as a picture of sane size or give an error; never anything else.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string_view>
#include <vector>

#include "core/image/convert.h"
#include "core/image/image_module.h"
#include "core/image/jpeg_end.h"
#include "core/image/png_stream.h"
#include "core/image/tiff_stream.h"
#include "tests/unit/base/temporary_folder.h"

namespace burin::image {
namespace {

constexpr unsigned kSeed = 1234;
constexpr int kDamagedCopies = 150;

void Damage(std::vector<std::byte>& bytes, std::mt19937& random) {
  const std::size_t hits = 1 + random() % 8;
  for (std::size_t i = 0; i < hits && !bytes.empty(); ++i) {
    // Half of the hits go to the front, where the structure is.
    const std::size_t range = random() % 2 == 0 ? std::min<std::size_t>(bytes.size(), 200) : bytes.size();
    bytes[random() % range] = static_cast<std::byte>(random());
  }
  if (random() % 4 == 0) bytes.resize(random() % (bytes.size() + 1));
}

TEST(DamagedImages, ReadOrFailCleanly) {
  RecordProperty("seed", static_cast<int>(kSeed));
  const auto module = LoadImageModule();
  ASSERT_TRUE(module.has_value()) << module.error().message;
  const test::TemporaryFolder folder;
  std::mt19937 random(kSeed);
  int read = 0;
  int refused = 0;
  for (const char* name : {"a.png", "a.jpg", "a.tif", "b.exr", "b.hdr"}) {
    Image image = MakeImage(31, 23, 4, SampleType::kU8, Encoding::kDisplay);
    for (std::byte& byte : image.pixels) byte = static_cast<std::byte>(random());
    if (name[0] == 'b') {
      image = ToType(image, SampleType::kF32);
      image.encoding = Encoding::kSceneLinear;
    }
    ASSERT_TRUE((*module)->Write(folder.File(name), image, {}).has_value());
    const auto whole = test::ReadAllBytes(folder.File(name));
    for (int i = 0; i < kDamagedCopies; ++i) {
      auto bytes = whole;
      Damage(bytes, random);
      const auto result = (*module)->ReadMemory(bytes, name);
      if (result) {
        ++read;
        ASSERT_EQ(result->pixels.size(), result->RowBytes() * static_cast<std::size_t>(result->height))
            << "seed " << kSeed;
      } else {
        ++refused;
        ASSERT_EQ(result.error().kind, ErrorKind::kInput) << "seed " << kSeed;
        ASSERT_TRUE(result.error().message.starts_with("cannot read '")) << result.error().message;
      }
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(read, 0);
}

TEST(DamagedImages, StreamChecksEndOnAnyBytes) {
  std::mt19937 random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    std::vector<std::byte> bytes(random() % 300);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random() % 3 == 0 ? 0xFF : random());
    if (bytes.size() > 16 && i % 2 == 0) {
      constexpr std::string_view kTiff("II*\0\x08\0\0\0", 8);
      std::ranges::copy(std::as_bytes(std::span(kTiff)), bytes.begin());
    }
    static_cast<void>(ReachesJpegEnd(bytes));
    static_cast<void>(PngPicture(bytes));
    static_cast<void>(TiffIsWhole(bytes));
    const std::size_t size = bytes.size();
    RemoveTiffDate(bytes);
    ASSERT_EQ(bytes.size(), size);
  }
}

}  // namespace
}  // namespace burin::image
