// SPDX-License-Identifier: Apache-2.0
#include "core/image/convert.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "core/image/half.h"
#include "core/image/orientation.h"

namespace burin::image {
namespace {

using testing::ElementsAre;

template <class T>
Image Make(int width, int height, int channels, SampleType type, const std::vector<T>& samples,
           Encoding encoding = Encoding::kDisplay) {
  Image image = MakeImage(width, height, channels, type, encoding);
  EXPECT_EQ(image.pixels.size(), samples.size() * sizeof(T));
  std::memcpy(image.pixels.data(), samples.data(), image.pixels.size());
  return image;
}

template <class T>
std::vector<T> Samples(const Image& image) {
  return {image.As<T>().begin(), image.As<T>().end()};
}

TEST(Convert, EightToSixteenBitsAndBackIsExact) {
  std::vector<std::uint8_t> all(256);
  for (int i = 0; i < 256; ++i) all[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(i);
  const Image image = Make(256, 1, 1, SampleType::kU8, all);
  const Image wide = ToType(image, SampleType::kU16);
  EXPECT_EQ(wide.As<std::uint16_t>()[255], 65535);
  EXPECT_EQ(wide.As<std::uint16_t>()[128], 128 * 257);
  EXPECT_EQ(Samples<std::uint8_t>(ToType(wide, SampleType::kU8)), all);
  for (const SampleType type : {SampleType::kF16, SampleType::kF32}) {
    EXPECT_EQ(Samples<std::uint8_t>(ToType(ToType(image, type), SampleType::kU8)), all);
  }
}

TEST(Convert, SixteenBitsThroughFloatsIsExact) {
  std::vector<std::uint16_t> all(65536);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint16_t>(i);
  const Image image = Make(256, 256, 1, SampleType::kU16, all);
  EXPECT_EQ(Samples<std::uint16_t>(ToType(ToType(image, SampleType::kF32), SampleType::kU16)), all);
}

TEST(Convert, SixteenToEightBitsRoundsToNearest) {
  for (int i = 0; i <= 65535; i += 7) {
    const Image image = Make<std::uint16_t>(1, 1, 1, SampleType::kU16, {static_cast<std::uint16_t>(i)});
    ASSERT_EQ(ToType(image, SampleType::kU8).As<std::uint8_t>()[0], std::lround(i / 257.0)) << i;
  }
}

TEST(Convert, FloatsClampAndNanBecomesZero) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const Image image = Make<float>(8, 1, 1, SampleType::kF32, {-1.0F, 0.0F, 0.5F, 1.0F, 2.0F, nan, infinity, -infinity});
  EXPECT_THAT(Samples<std::uint8_t>(ToType(image, SampleType::kU8)), ElementsAre(0, 0, 128, 255, 255, 0, 255, 0));
  EXPECT_THAT(Samples<std::uint16_t>(ToType(image, SampleType::kU16)),
              ElementsAre(0, 0, 32768, 65535, 65535, 0, 65535, 0));
}

TEST(Convert, FloatsKeepNanAndInfinityAsHalves) {
  const Image image = Make<float>(2, 1, 1, SampleType::kF32, {std::numeric_limits<float>::quiet_NaN(), INFINITY});
  const Image half = ToType(image, SampleType::kF16);
  EXPECT_TRUE(std::isnan(FloatFromHalf(half.As<std::uint16_t>()[0])));
  EXPECT_EQ(half.As<std::uint16_t>()[1], 0x7C00);
}

TEST(Convert, IdsAreNumbersNotFractions) {
  const Image ids = Make<std::uint32_t>(3, 1, 1, SampleType::kU32, {7, 300, 4000000000U}, Encoding::kData);
  EXPECT_THAT(Samples<float>(ToType(ids, SampleType::kF32)), ElementsAre(7.0F, 300.0F, 4000000000.0F));
  EXPECT_THAT(Samples<std::uint8_t>(ToType(ids, SampleType::kU8)), ElementsAre(7, 255, 255));
  EXPECT_THAT(Samples<std::uint16_t>(ToType(ids, SampleType::kU16)), ElementsAre(7, 300, 65535));
  const Image small = Make<std::uint8_t>(2, 1, 1, SampleType::kU8, {7, 255}, Encoding::kData);
  EXPECT_THAT(Samples<std::uint32_t>(ToType(small, SampleType::kU32)), ElementsAre(7U, 255U));
  const Image odd = Make<float>(3, 1, 1, SampleType::kF32, {-5.0F, 1e20F, std::nanf("")});
  EXPECT_THAT(Samples<std::uint32_t>(ToType(odd, SampleType::kU32)), ElementsAre(0U, 4294967040U, 0U));
}

TEST(Convert, GreySpreadsAndAlphaIsAdded) {
  const Image grey = Make<std::uint8_t>(2, 1, 1, SampleType::kU8, {10, 20});
  EXPECT_THAT(Samples<std::uint8_t>(ToChannels(grey, 4)), ElementsAre(10, 10, 10, 255, 20, 20, 20, 255));
  const Image grey_alpha = Make<std::uint8_t>(1, 1, 2, SampleType::kU8, {10, 99});
  EXPECT_THAT(Samples<std::uint8_t>(ToChannels(grey_alpha, 4)), ElementsAre(10, 10, 10, 99));
  const Image half = Make<std::uint16_t>(1, 1, 1, SampleType::kF16, {0x3800});
  EXPECT_THAT(Samples<std::uint16_t>(ToChannels(half, 2)), ElementsAre(0x3800, 0x3C00));
}

TEST(Convert, AlphaIsDroppedAndColourWeighedToGrey) {
  const Image rgba = Make<std::uint8_t>(2, 1, 4, SampleType::kU8, {1, 2, 3, 4, 255, 0, 0, 9});
  EXPECT_THAT(Samples<std::uint8_t>(ToChannels(rgba, 3)), ElementsAre(1, 2, 3, 255, 0, 0));
  EXPECT_THAT(Samples<std::uint8_t>(ToChannels(rgba, 2)), ElementsAre(2, 4, 54, 9));
  const Image data = Make<float>(1, 1, 3, SampleType::kF32, {0.5F, 9.0F, 9.0F}, Encoding::kData);
  EXPECT_THAT(Samples<float>(ToChannels(data, 1)), ElementsAre(0.5F));
}

TEST(Convert, LongRowsGoThroughEveryBlock) {
  std::vector<std::uint16_t> halves(10001);
  for (std::size_t i = 0; i < halves.size(); ++i) halves[i] = static_cast<std::uint16_t>(i % 0x3C01);
  const Image image = Make(10001, 1, 1, SampleType::kF16, halves);
  const Image bytes = ToType(image, SampleType::kU8);
  for (std::size_t i = 0; i < halves.size(); ++i) {
    ASSERT_EQ(bytes.As<std::uint8_t>()[i], std::lround(FloatFromHalf(halves[i]) * 255.0F)) << i;
  }
}

TEST(Convert, PremultiplyKeepsGlows) {
  std::vector<float> pixels{0.5F, 1.0F, 2.0F, 0.5F, 3.0F, 3.0F, 3.0F, 0.0F};
  Premultiply(pixels);
  EXPECT_THAT(pixels, ElementsAre(0.25F, 0.5F, 1.0F, 0.5F, 3.0F, 3.0F, 3.0F, 0.0F));
  Unpremultiply(pixels);
  EXPECT_THAT(pixels, ElementsAre(0.5F, 1.0F, 2.0F, 0.5F, 3.0F, 3.0F, 3.0F, 0.0F));
}

TEST(Convert, FlipsRows) {
  Image image = Make<std::uint8_t>(2, 3, 1, SampleType::kU8, {1, 2, 3, 4, 5, 6});
  FlipRows(image);
  EXPECT_THAT(Samples<std::uint8_t>(image), ElementsAre(5, 6, 3, 4, 1, 2));
}

// The picture is   1 2 3   and each row gives how the tag's value would have stored it, by the table in TIFF 6.0.
//                  4 5 6
TEST(Orientation, EveryTagValueComesOutUpright) {
  struct Case {
    int tag, width, height;
    std::vector<std::uint8_t> stored;
  };
  const std::vector<Case> cases{
      {1, 3, 2, {1, 2, 3, 4, 5, 6}},  // row 0 top, column 0 left
      {2, 3, 2, {3, 2, 1, 6, 5, 4}},  // top, right
      {3, 3, 2, {6, 5, 4, 3, 2, 1}},  // bottom, right
      {4, 3, 2, {4, 5, 6, 1, 2, 3}},  // bottom, left
      {5, 2, 3, {1, 4, 2, 5, 3, 6}},  // row 0 left, column 0 top
      {6, 2, 3, {3, 6, 2, 5, 1, 4}},  // right, top
      {7, 2, 3, {6, 3, 5, 2, 4, 1}},  // right, bottom
      {8, 2, 3, {4, 1, 5, 2, 6, 3}},  // left, bottom
      {99, 3, 2, {1, 2, 3, 4, 5, 6}},
  };
  for (const Case& c : cases) {
    const Image upright = Upright(Make(c.width, c.height, 1, SampleType::kU8, c.stored), c.tag);
    EXPECT_EQ(upright.width, 3) << c.tag;
    EXPECT_EQ(upright.height, 2) << c.tag;
    EXPECT_THAT(Samples<std::uint8_t>(upright), ElementsAre(1, 2, 3, 4, 5, 6)) << c.tag;
  }
}

}  // namespace
}  // namespace burin::image
