// SPDX-License-Identifier: Apache-2.0
// Each attribute in each kind of target: encodings, ids, backgrounds, grouping.
#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include <cstring>

#include "tests/gl/gbuffer/scene_fixture.h"

namespace burin::gbuffer {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::FloatNear;
using testing::Pointwise;

constexpr float kHalfStep8 = 0.5f / 255.0f + 1e-6f;

auto Near(std::vector<float> values, float tolerance) { return Pointwise(FloatNear(tolerance), values); }

class StorageTest : public GbufferTest {
 protected:
  static TestScene Wall(const scene::Material& material = {}) {
    TestScene test;
    test.AddNode(test.AddMesh(Square(test.AddMaterial(material))), Translate(0, 0, -5));
    return test;
  }
  // 21 x 21 small squares, each a node of its own.
  static TestScene Grid() {
    TestScene test;
    const int mesh = test.AddMesh(Square());
    for (int i = 0; i < 441; ++i) {
      const float x = (static_cast<float>(i % 21) + 0.5f) / 10.5f - 1.0f;
      const float y = 1.0f - (static_cast<float>(i / 21) + 0.5f) / 10.5f;
      test.AddNode(mesh, Translate(x, y, -5) * glm::scale(glm::mat4(1.0f), glm::vec3(1.0f / 21)));
    }
    return test;
  }
  static gl::Format WithSwizzle(gl::Format format, std::array<std::int32_t, 4> swizzle, int components) {
    format.swizzle = swizzle;
    format.components = components;
    return format;
  }
};

TEST_F(StorageTest, SignedAttributesAreHalvedInUnsignedFormats) {
  EXPECT_THAT(Render(Wall(), Orthographic(), Attribute::kNormal, Unorm(), 4, 4).At(1, 1),
              Near({0.5f, 0.5f, 1, 1}, kHalfStep8));
  EXPECT_THAT(Render(Wall(), Orthographic(), Attribute::kNormal, Float(4, 16), 4, 4).At(1, 1), ElementsAre(0, 0, 1, 1));
}

TEST_F(StorageTest, UnsignedFormatsClamp) {
  EXPECT_THAT(Render(Wall(), Orthographic(), Attribute::kDepth, Unorm(), 4, 4).At(1, 1), ElementsAre(1, 1, 1, 1));
}

TEST_F(StorageTest, HalvesStayFinite) {
  TestScene test;
  scene::Material material = Unlit({1e6f, 1, 1, 1});
  test.AddNode(test.AddMesh(Square(test.AddMaterial(material))), Translate(0, 0, -5));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kColor, Float(4, 16), 4, 4).At(1, 1),
              ElementsAre(65504, 1, 1, 1));
  EXPECT_THAT(Render(TestScene(), Orthographic(), Attribute::kDepth, Float(1, 16), 4, 4).At(1, 1)[0], 65504);
}

TEST_F(StorageTest, DisplayTargetsHoldSrgb) {
  const TestScene test = Wall(Unlit({0.5f, 0.0f, 1.0f, 1.0f}));
  const std::vector<float> stored =
      Render(test, Orthographic(), Attribute::kColor, Unorm(), 4, 4, image::Encoding::kDisplay).At(1, 1);
  EXPECT_THAT(stored, Near({188.0f / 255, 0, 1, 1}, 1e-6f));  // sRGB of 0.5 is 187.5 of 255
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kAlbedo, Unorm(), 4, 4, image::Encoding::kDisplay).At(1, 1),
              stored);
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kColor, Unorm(), 4, 4).At(1, 1),
              Near({128.0f / 255, 0, 1, 1}, 1e-6f));
}

TEST_F(StorageTest, IntensityIsTheLumaOfWhatIsStored) {
  const TestScene test = Wall(Unlit({0.5f, 0.25f, 1.0f, 1.0f}));
  const float linear = 0.2126f * 0.5f + 0.7152f * 0.25f + 0.0722f;
  const float display = 0.2126f * 0.735357f + 0.7152f * 0.537099f + 0.0722f;  // sRGB of 0.5 and 0.25
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kIntensity, Float(), 4, 4).At(1, 1),
              Near({linear, linear, linear, 1}, 1e-5f));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kIntensity, Float(), 4, 4, image::Encoding::kDisplay).At(1, 1)[0],
              FloatNear(display, 1e-5f));
}

TEST_F(StorageTest, LuminanceFormatsTakeTheLumaOfColour) {
  const TestScene test = Wall(Unlit({1.0f, 0.0f, 0.0f, 1.0f}));
  const gl::Format l = WithSwizzle(Float(1), {GL_RED, GL_RED, GL_RED, GL_ONE}, 1);
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kColor, l, 4, 4).At(1, 1)[0], FloatNear(0.2126f, 1e-6f));
  const gl::Format r = WithSwizzle(Float(1), {GL_RED, GL_ONE, GL_ONE, GL_ONE}, 1);
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kColor, r, 4, 4).At(1, 1)[0], 1.0f);
  const gl::Format al = WithSwizzle(Float(4), {GL_RED, GL_RED, GL_RED, GL_ALPHA}, 2);
  const std::vector<float> both = Render(test, Orthographic(), Attribute::kColor, al, 4, 4).At(1, 1);
  EXPECT_THAT(both[0], FloatNear(0.2126f, 1e-6f));
  EXPECT_EQ(both[3], 1.0f);
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kTexcoord, al, 4, 4).At(1, 2)[3], FloatNear(0.625f, 1e-3f));
}

TEST_F(StorageTest, AlphaOnlyFormatsTakeAlphaOrTheOneComponent) {
  const gl::Format a = WithSwizzle(Float(4), {GL_ZERO, GL_ZERO, GL_ZERO, GL_ALPHA}, 1);
  const TestScene test = Wall(Unlit({0.25f, 0.25f, 0.25f, 1.0f}));
  EXPECT_EQ(Render(test, Orthographic(), Attribute::kColor, a, 4, 4).At(1, 1)[3], 1.0f);
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kIntensity, a, 4, 4).At(1, 1)[3], FloatNear(0.25f, 1e-6f));
}

TEST_F(StorageTest, IdsAreExactInEveryFormat) {
  const TestScene test = Grid();
  const auto check = [&](const gl::Format& format, auto&& decode, auto&& expected) {
    const Picture picture = Render(test, Orthographic(), Attribute::kObjectId, format, 63, 63);
    for (int i = 0; i < 441; ++i) {
      ASSERT_EQ(decode(picture.At(3 * (i % 21) + 1, 3 * (i / 21) + 1)), expected(i + 1)) << "object " << i + 1;
    }
  };
  const auto same = [](int id) { return id; };
  const auto digit = [](float value, float most) { return static_cast<int>(std::lround(value * most)); };
  check(
      Float(1, 32), [](const std::vector<float>& p) { return static_cast<int>(p[0]); }, same);
  check(
      Float(4, 16), [](const std::vector<float>& p) { return static_cast<int>(p[0]); }, same);
  check(
      Unorm(1, 16), [&](const std::vector<float>& p) { return digit(p[0], 65535); }, same);
  check(
      Unorm(4, 8), [&](const std::vector<float>& p) { return digit(p[0], 255) + 256 * digit(p[1], 255); }, same);
  check(
      Unorm(2, 8), [&](const std::vector<float>& p) { return digit(p[0], 255) + 256 * digit(p[1], 255); }, same);
  // One component of 8 bits holds 255 ids and starts again at 1.
  check(
      Unorm(1, 8), [&](const std::vector<float>& p) { return digit(p[0], 255); },
      [](int id) { return (id - 1) % 255 + 1; });
  gl::Format rgb565 = Unorm(3, 6);
  rgb565.internal = GL_RGB565;
  check(
      rgb565, [&](const std::vector<float>& p) { return digit(p[0], 31) + 32 * digit(p[1], 63); }, same);
}

TEST_F(StorageTest, EveryBackgroundIsTheTablesInEveryFormat) {
  const TestScene empty;
  for (const AttributeInfo& info : AllAttributes()) {
    const std::vector<float> raw = Render(empty, Orthographic(), info.attribute, Float(), 4, 4).At(1, 1);
    const std::vector<float> stored = Render(empty, Orthographic(), info.attribute, Unorm(), 4, 4).At(1, 1);
    for (std::size_t c = 0; c < static_cast<std::size_t>(info.components); ++c) {
      EXPECT_EQ(raw[c], info.background[c]) << info.name;
      const float expected = info.is_signed ? 0.5f * info.background[c] + 0.5f : info.background[c];
      EXPECT_THAT(stored[c], FloatNear(std::clamp(expected, 0.0f, 1.0f), kHalfStep8)) << info.name;
    }
    if (info.components < 4) {
      EXPECT_EQ(raw[3], 0.0f) << info.name;
    }
  }
}

TEST_F(StorageTest, TheFramesBackgroundIsColoursOnly) {
  background_ = {0.25f, 0.125f, 0.0f, 0.5f};  // associated: (0.5, 0.25, 0) half covering
  const TestScene empty;
  EXPECT_THAT(Render(empty, Orthographic(), Attribute::kColor, Float(), 4, 4).At(0, 0),
              ElementsAre(0.25f, 0.125f, 0, 0.5f));
  EXPECT_THAT(Render(empty, Orthographic(), Attribute::kColor, Float(), 4, 4, image::Encoding::kDisplay).At(0, 0),
              Near({0.735357f, 0.537099f, 0, 0.5f}, 1e-5f));
  EXPECT_THAT(Render(empty, Orthographic(), Attribute::kAlpha, Float(), 4, 4).At(0, 0)[0], 0.5f);
  EXPECT_THAT(Render(empty, Orthographic(), Attribute::kIntensity, Float(), 4, 4).At(0, 0)[0],
              FloatNear(0.2126f * 0.25f + 0.7152f * 0.125f, 1e-6f));
  EXPECT_THAT(Render(empty, Orthographic(), Attribute::kAlbedo, Float(), 4, 4).At(0, 0), Each(0.0f));
}

TEST_F(StorageTest, ManyAttributesAtOnceHaveTheBitsOfEachAlone) {
  TestScene test;
  scene::Material glass;
  glass.base_color = {0.2f, 0.9f, 0.4f, 0.6f};
  glass.alpha_mode = scene::AlphaMode::kBlend;
  glass.double_sided = true;
  test.AddNode(test.AddMesh(Sphere()), Translate(-0.4f, 0, -4));
  test.AddNode(test.AddMesh(Sphere(test.AddMaterial(glass), 24)), Translate(0.5f, 0.2f, -3.5f));
  const scene::View view = Perspective(0.8f, 1.0f);
  std::vector<gl::Texture> targets;
  std::vector<Request> requests;
  targets.reserve(2 * AllAttributes().size());
  for (const AttributeInfo& info : AllAttributes()) {
    for (const gl::Format& format : {Unorm(), Float()}) {
      targets.push_back(Must(gl::Texture::Create(format, 33, 31, 1, "target")));
      const bool is_display = format.numeric == gl::Numeric::kUnorm;
      requests.push_back(
          {info.attribute, &targets.back(), is_display ? image::Encoding::kDisplay : image::Encoding::kSceneLinear});
    }
  }
  RenderInto(test, view, requests);
  for (const Request& request : requests) {
    const Picture together = ReadPicture(*request.target);
    const Picture alone = Render(test, view, request.attribute, request.target->format(), 33, 31, request.encoding);
    EXPECT_EQ(std::memcmp(together.values.data(), alone.values.data(), alone.values.size() * sizeof(float)), 0)
        << Info(request.attribute).name;
  }
}

TEST_F(StorageTest, TargetsOfSeveralSizesAreFilledAtTheirOwn) {
  const gl::Texture small = Must(gl::Texture::Create(Float(), 8, 4, 1, "small"));
  const gl::Texture large = Must(gl::Texture::Create(Float(), 24, 12, 1, "large"));
  const Request requests[] = {{Attribute::kScreenPosition, &small}, {Attribute::kScreenPosition, &large}};
  RenderInto(Wall(), Orthographic(), requests);
  EXPECT_THAT(ReadPicture(small).At(7, 3), ElementsAre(7.5f, 3.5f, 0, 1));
  EXPECT_THAT(ReadPicture(large).At(23, 11), ElementsAre(23.5f, 11.5f, 0, 1));
}

}  // namespace
}  // namespace burin::gbuffer
