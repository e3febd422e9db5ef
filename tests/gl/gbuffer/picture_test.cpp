// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include <cmath>

#include "tests/gl/gbuffer/scene_fixture.h"

namespace burin::gbuffer {
namespace {

using image::Encoding;
using image::SampleType;
using testing::Each;
using testing::ElementsAre;
using testing::FloatNear;
using testing::Pointwise;

auto Near(std::vector<float> values, float tolerance = 1e-5f) { return Pointwise(FloatNear(tolerance), values); }

class PictureTest : public GbufferTest {
 protected:
  static void SetUpTestSuite() {
    GbufferTest::SetUpTestSuite();
    renderer_ = Must(PictureRenderer::Create());
  }
  static void TearDownTestSuite() {
    renderer_.reset();
    GbufferTest::TearDownTestSuite();
  }

  static gl::Texture Upload(const image::Image& image) {
    gl::Texture texture = Must(gl::Texture::Create(gl::FormatFor(image), image.width, image.height, 1, "picture"));
    texture.Upload(image);
    return texture;
  }
  static gl::Texture Pixel(std::vector<float> rgba) {
    return Upload(gl::MakeImage<float>(1, 1, 4, SampleType::kF32, [&](std::size_t i) { return rgba[i]; }));
  }
  static gl::Texture Run(const gl::Texture& picture, Encoding from, Attribute attribute, const gl::Format& format,
                         int width, int height, Encoding to) {
    gl::Texture target = Must(gl::Texture::Create(format, width, height, 1, "target"));
    const Request request{attribute, &target, to};
    const Result<void> result = renderer_->Render(picture, from, std::span(&request, 1));
    EXPECT_TRUE(result.has_value()) << result.error().message;
    return target;
  }
  static std::vector<float> One(const gl::Texture& picture, Encoding from, Attribute attribute, Encoding to,
                                const gl::Format& format = Float()) {
    return ReadPicture(Run(picture, from, attribute, format, 1, 1, to)).At(0, 0);
  }

  static inline std::unique_ptr<PictureRenderer> renderer_;
};

TEST_F(PictureTest, TheSameSizeAndFormatIsCopiedBitForBit) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(37, 19), std::pair(640, 1)}) {
    const image::Image image = gl::MakeImage<std::uint8_t>(width, height, 4, SampleType::kU8,
                                                           [](std::size_t i) { return i * 2654435761u >> 13; });
    const gl::Texture target =
        Run(Upload(image), Encoding::kDisplay, Attribute::kColor, Unorm(), width, height, Encoding::kDisplay);
    EXPECT_EQ(gl::Read(target, SampleType::kU8, 4, Encoding::kDisplay).pixels, image.pixels);
  }
}

TEST_F(PictureTest, OtherFormatsOfTheSamePrecisionKeepEveryValueToo) {
  const image::Image image =
      gl::MakeImage<std::uint8_t>(16, 16, 3, SampleType::kU8, [](std::size_t i) { return i / 3; });
  const gl::Texture target =
      Run(Upload(image), Encoding::kDisplay, Attribute::kVideo, Unorm(4, 16), 16, 16, Encoding::kDisplay);
  EXPECT_EQ(gl::Read(target, SampleType::kU8, 3, Encoding::kDisplay).pixels, image.pixels);
}

TEST_F(PictureTest, NotANumberIsCopiedToo) {
  const gl::Texture picture = Pixel({std::nanf(""), -3, INFINITY, 1});
  const std::vector<float> copy = One(picture, Encoding::kSceneLinear, Attribute::kColor, Encoding::kSceneLinear);
  EXPECT_TRUE(std::isnan(copy[0]));
  EXPECT_EQ(copy[1], -3.0f);
  EXPECT_EQ(copy[2], INFINITY);
}

TEST_F(PictureTest, DisplayBecomesSceneLinearWithAssociatedAlphaAndBack) {
  // sRGB of 0.5 is 0.735357.
  EXPECT_THAT(One(Pixel({0.735357f, 1, 0.02f, 0.5f}), Encoding::kDisplay, Attribute::kColor, Encoding::kSceneLinear),
              Near({0.25f, 0.5f, 0.5f * 0.02f / 12.92f, 0.5f}));
  EXPECT_THAT(One(Pixel({0.25f, 0.5f, 0, 0.5f}), Encoding::kSceneLinear, Attribute::kColor, Encoding::kDisplay),
              Near({0.735357f, 1, 0, 0.5f}));
  EXPECT_THAT(One(Pixel({0, 0, 0, 0}), Encoding::kSceneLinear, Attribute::kColor, Encoding::kDisplay), Each(0.0f));
}

TEST_F(PictureTest, DataIsNeverConverted) {
  EXPECT_THAT(One(Pixel({0.5f, 0.25f, 2, 0.5f}), Encoding::kData, Attribute::kColor, Encoding::kDisplay, Float(4, 16)),
              Near({0.5f, 0.25f, 2, 0.5f}));
}

TEST_F(PictureTest, IntensityAndAlphaFollow) {
  const gl::Texture picture = Pixel({0.5f, 0.25f, 1, 0.75f});
  const float luma = 0.2126f * 0.5f + 0.7152f * 0.25f + 0.0722f;
  EXPECT_THAT(One(picture, Encoding::kDisplay, Attribute::kIntensity, Encoding::kDisplay), Near({luma, luma, luma, 1}));
  EXPECT_THAT(One(picture, Encoding::kDisplay, Attribute::kAlpha, Encoding::kDisplay), Near({0.75f, 0.75f, 0.75f, 1}));
}

TEST_F(PictureTest, GreyPicturesAreGrey) {
  const gl::Texture picture =
      Upload(gl::MakeImage<std::uint8_t>(1, 1, 1, SampleType::kU8, [](std::size_t) { return 51; }));
  EXPECT_THAT(One(picture, Encoding::kDisplay, Attribute::kColor, Encoding::kDisplay), Near({0.2f, 0.2f, 0.2f, 1}));
}

TEST_F(PictureTest, OtherAttributesHoldTheirBackground) {
  const gl::Texture picture = Pixel({0.5f, 0.25f, 1, 0.75f});
  for (const AttributeInfo& info : AllAttributes()) {
    if (info.attribute == Attribute::kColor || info.attribute == Attribute::kVideo ||
        info.attribute == Attribute::kIntensity || info.attribute == Attribute::kAlpha) {
      continue;
    }
    EXPECT_EQ(One(picture, Encoding::kDisplay, info.attribute, Encoding::kDisplay)[0], info.background[0]) << info.name;
  }
  EXPECT_THAT(One(picture, Encoding::kDisplay, Attribute::kNormal, Encoding::kDisplay, Unorm(4, 16)),
              Near({0.5f, 0.5f, 0.5f, 0}, 1e-5f));
}

TEST_F(PictureTest, SizesAreMatchedBilinearly) {
  const gl::Texture picture = Upload(gl::MakeImage<float>(2, 1, 4, SampleType::kF32, [](std::size_t i) {
    return i < 4 ? 1.0f : i == 7 ? 1.0f : 0.0f;
  }));
  const Picture wide =
      ReadPicture(Run(picture, Encoding::kSceneLinear, Attribute::kColor, Float(), 4, 1, Encoding::kSceneLinear));
  EXPECT_THAT(wide.At(0, 0)[0], 1.0f);
  EXPECT_THAT(wide.At(1, 0)[0], FloatNear(0.75f, 1e-6f));
  EXPECT_THAT(wide.At(2, 0)[0], FloatNear(0.25f, 1e-6f));
  EXPECT_THAT(wide.At(3, 0)[0], 0.0f);
}

TEST_F(PictureTest, HiddenColoursDoNotLeakWhenSizesDiffer) {
  // White beside a fully transparent red.
  constexpr std::array<float, 8> kPixels = {1, 1, 1, 1, 1, 0, 0, 0};
  const gl::Texture picture =
      Upload(gl::MakeImage<float>(2, 1, 4, SampleType::kF32, [&](std::size_t i) { return kPixels[i]; }));
  const Picture one =
      ReadPicture(Run(picture, Encoding::kDisplay, Attribute::kColor, Float(), 1, 1, Encoding::kDisplay));
  EXPECT_THAT(one.At(0, 0), Near({1, 1, 1, 0.5f}));
}

TEST_F(PictureTest, SeveralRequestsOfSeveralSizesAtOnce) {
  const gl::Texture picture = Pixel({0.5f, 0.25f, 1, 0.75f});
  std::vector<gl::Texture> targets;
  std::vector<Request> requests;
  targets.reserve(24);
  for (int i = 0; i < 24; ++i) {
    targets.push_back(Must(gl::Texture::Create(Float(), 1 + i % 2, 1, 1, "target")));
    requests.push_back({i % 3 == 0 ? Attribute::kColor : Attribute::kAlpha, &targets.back(), Encoding::kDisplay});
  }
  ASSERT_TRUE(renderer_->Render(picture, Encoding::kDisplay, requests).has_value());
  for (int i = 0; i < 24; ++i) {
    EXPECT_THAT(ReadPicture(targets[static_cast<std::size_t>(i)]).At(0, 0)[0],
                FloatNear(i % 3 == 0 ? 0.5f : 0.75f, 1e-6f));
  }
}

TEST_F(PictureTest, LeftoverStatesOfAnEffectDoNotMatter) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_ZERO);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 0, 0);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT_AND_BACK);
  glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  EXPECT_THAT(One(Pixel({0.5f, 0.25f, 1, 1}), Encoding::kDisplay, Attribute::kAlpha, Encoding::kDisplay), Each(1.0f));
}

TEST_F(PictureTest, AnAliasReadsAsTheTargetWould) {
  const gl::Texture picture = Pixel({0.5f, 0.25f, 1, 0.75f});
  const auto can = [&](const gl::Format& format, Attribute attribute, Encoding to) {
    const gl::Texture target = Must(gl::Texture::Create(format, 1, 1, 1, "target"));
    return PictureRenderer::CanAlias(picture, Encoding::kDisplay, {attribute, &target, to});
  };
  EXPECT_TRUE(can(Float(), Attribute::kColor, Encoding::kDisplay));
  EXPECT_TRUE(can(Float(), Attribute::kVideo, Encoding::kDisplay));
  EXPECT_FALSE(can(Float(), Attribute::kColor, Encoding::kSceneLinear));
  EXPECT_FALSE(can(Float(), Attribute::kAlpha, Encoding::kDisplay));
  EXPECT_FALSE(can(Float(4, 16), Attribute::kColor, Encoding::kDisplay));
  gl::Format opaque = Float();
  opaque.swizzle[3] = GL_ONE;
  EXPECT_FALSE(can(opaque, Attribute::kColor, Encoding::kDisplay));
}

}  // namespace
}  // namespace burin::gbuffer
