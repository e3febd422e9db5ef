// SPDX-License-Identifier: Apache-2.0
#include "core/gl/readback.h"

#include <gmock/gmock.h>

#include "tests/gl/gl/context_fixture.h"

namespace burin::gl {
namespace {

using image::SampleType;

class ReadbackTest : public ContextTest {};

image::Image Grey(int value, int size = 4) {
  return MakeImage<std::uint8_t>(size, size, 4, SampleType::kU8, [&](std::size_t) { return value; });
}

TEST_F(ReadbackTest, FinishesInTheOrderOfStart) {
  Texture texture = Must(Texture::Create(PlainFormat(Numeric::kUnorm, 8, 4), 4, 4, 1, "frame"));
  ReadbackRing ring(3);
  EXPECT_TRUE(ring.empty());
  for (int value = 0; value < 3; ++value) {
    texture.Upload(Grey(value));  // the texture is overwritten while copies are under way
    ring.Start(texture, SampleType::kU8, 4, image::Encoding::kDisplay);
  }
  EXPECT_TRUE(ring.full());
  for (int value = 0; value < 20; ++value) {
    const image::Image image = ring.Finish();
    EXPECT_EQ(image.pixels, Grey(value).pixels);
    EXPECT_EQ(image.encoding, image::Encoding::kDisplay);
    EXPECT_FALSE(ring.full());
    texture.Upload(Grey(value + 3));
    ring.Start(texture, SampleType::kU8, 4, image::Encoding::kDisplay);
  }
}

TEST_F(ReadbackTest, SizesAndTypesMayChange) {
  ReadbackRing ring(2);
  for (const int size : {3, 17, 1, 64}) {
    Texture texture = Must(Texture::Create(PlainFormat(Numeric::kUnorm, 8, 4), size, size, 1, "frame"));
    texture.Upload(Grey(51, size));
    ring.Start(texture, SampleType::kF32, 1, image::Encoding::kData);
    ring.Start(texture, SampleType::kU16, 3, image::Encoding::kData);
    const image::Image floats = ring.Finish();
    EXPECT_EQ(floats.width, size);
    EXPECT_THAT(floats.As<float>(),
                testing::AllOf(testing::SizeIs(size * size), testing::Each(testing::FloatNear(0.2f, 1e-6f))));
    const image::Image shorts = ring.Finish();
    EXPECT_THAT(shorts.As<std::uint16_t>(), testing::AllOf(testing::SizeIs(size * size * 3), testing::Each(13107)));
  }
}

TEST_F(ReadbackTest, SwizzlesDoNotApply) {
  const image::Image grey = MakeImage<std::uint8_t>(1, 1, 1, SampleType::kU8, [](std::size_t) { return 9; });
  Texture texture = Must(Texture::Create(FormatFor(grey), 1, 1, 1, "grey"));
  texture.Upload(grey);
  const image::Image image = Read(texture, SampleType::kU8, 4, image::Encoding::kData);
  EXPECT_THAT(image.As<std::uint8_t>(), testing::ElementsAre(9, 0, 0, 255));
}

}  // namespace
}  // namespace burin::gl
