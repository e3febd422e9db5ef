// SPDX-License-Identifier: Apache-2.0
// Alpha modes, blending and what blended surfaces leave in the other attributes; points and lines.
#include <gmock/gmock.h>

#include "tests/gl/gbuffer/scene_fixture.h"

namespace burin::gbuffer {
namespace {

using testing::ElementsAre;
using testing::FloatNear;
using testing::Pointwise;

auto Near(std::vector<float> values, float tolerance = 1e-5f) { return Pointwise(FloatNear(tolerance), values); }

class AlphaTest : public GbufferTest {
 protected:
  static scene::Material Glass(const glm::vec4& color) {
    scene::Material material = Unlit(color);
    material.alpha_mode = scene::AlphaMode::kBlend;
    return material;
  }
  // Adds a wall of this material at depth z.
  static void AddWall(TestScene& test, const scene::Material& material, float depth) {
    test.AddNode(test.AddMesh(Square(test.AddMaterial(material))), Translate(0, 0, -depth));
  }
  std::vector<float> At(const TestScene& test, Attribute attribute,
                        image::Encoding encoding = image::Encoding::kSceneLinear) {
    return Render(test, Orthographic(), attribute, Float(), 4, 4, encoding).At(1, 1);
  }
};

TEST_F(AlphaTest, LayersBlendBackToFrontWhateverTheirOrderInTheFile) {
  const scene::Material red = Glass({1, 0, 0, 0.5f}), green = Glass({0, 1, 0, 0.25f}), white = Unlit({1, 1, 1, 1});
  TestScene near_first, far_first;
  AddWall(near_first, green, 3);
  AddWall(near_first, red, 4);
  AddWall(near_first, white, 5);
  AddWall(far_first, white, 5);
  AddWall(far_first, red, 4);
  AddWall(far_first, green, 3);
  // White under half red: (1, .5, .5); under a quarter green: (.75, .625, .375).
  for (const TestScene& test : {near_first, far_first}) {
    EXPECT_THAT(At(test, Attribute::kColor), Near({0.75f, 0.625f, 0.375f, 1}));
    EXPECT_THAT(At(test, Attribute::kAlpha)[0], FloatNear(1.0f, 1e-6f));
  }
}

TEST_F(AlphaTest, ColourHasAssociatedAlphaInSceneLinearTargetsOnly) {
  TestScene test;
  AddWall(test, Glass({0.5f, 1, 0, 0.25f}), 3);
  EXPECT_THAT(At(test, Attribute::kColor), Near({0.125f, 0.25f, 0, 0.25f}));
  EXPECT_THAT(At(test, Attribute::kColor, image::Encoding::kDisplay), Near({0.735357f, 1, 0, 0.25f}));
  EXPECT_THAT(At(test, Attribute::kAlpha)[0], FloatNear(0.25f, 1e-6f));
  EXPECT_THAT(At(test, Attribute::kIntensity)[0], FloatNear(0.2126f * 0.125f + 0.7152f * 0.25f, 1e-5f));
}

TEST_F(AlphaTest, OtherAttributesTakeTheNearestSurfaceThatIsOpaqueEnough) {
  TestScene test;
  AddWall(test, Glass({1, 0, 0, 0.49f}), 2);
  AddWall(test, Glass({0, 1, 0, 0.5f}), 3);
  AddWall(test, Unlit({0, 0, 1, 1}), 4);
  EXPECT_EQ(At(test, Attribute::kObjectId)[0], 2.0f);
  EXPECT_THAT(At(test, Attribute::kDepth)[0], FloatNear(3.0f, 1e-4f));
  EXPECT_THAT(At(test, Attribute::kAlbedo), Near({0, 1, 0, 1}));
}

TEST_F(AlphaTest, BlendedSurfacesBehindOpaqueOnesDoNotShow) {
  TestScene test;
  AddWall(test, Unlit({0, 0, 1, 1}), 2);
  AddWall(test, Glass({1, 0, 0, 0.9f}), 3);
  EXPECT_THAT(At(test, Attribute::kColor), Near({0, 0, 1, 1}));
  EXPECT_EQ(At(test, Attribute::kObjectId)[0], 1.0f);
}

TEST_F(AlphaTest, BlendingGoesOverTheBackground) {
  background_ = {0, 0, 1, 1};
  TestScene test;
  AddWall(test, Glass({1, 0, 0, 0.5f}), 2);
  EXPECT_THAT(At(test, Attribute::kColor), Near({0.5f, 0, 0.5f, 1}));
}

TEST_F(AlphaTest, BothSidesOfADoubleSidedGlassSphereBlend) {
  scene::Material glass = Glass({1, 1, 1, 0.5f});
  glass.double_sided = true;
  TestScene test;
  test.AddNode(test.AddMesh(Sphere(test.AddMaterial(glass))), Translate(0, 0, -5));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kAlpha, Float(), 8, 8).At(4, 4)[0], FloatNear(0.75f, 1e-5f));
  test.scene.materials[0].double_sided = false;
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kAlpha, Float(), 8, 8).At(4, 4)[0], FloatNear(0.5f, 1e-5f));
}

TEST_F(AlphaTest, MaskedSurfacesAreThereOrNot) {
  scene::Material material = Unlit({1, 1, 1, 1});
  material.alpha_mode = scene::AlphaMode::kMask;
  material.alpha_cutoff = 0.5f;
  material.base_color_texture.image = 0;
  material.base_color_texture.sampler = {
      .mag = scene::Filter::kNearest, .min = scene::Filter::kNearest, .mipmaps = false};
  TestScene test;
  // The left half is alpha 127, the right one 128.
  test.scene.images.push_back(gl::MakeImage<std::uint8_t>(2, 1, 4, image::SampleType::kU8, [](std::size_t i) {
    return i == 3 ? 127 : i == 7 ? 128 : 255;
  }));
  AddWall(test, material, 3);
  const Picture picture = Render(test, Orthographic(), Attribute::kColor, Float(), 4, 4);
  EXPECT_THAT(picture.At(1, 1), ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(picture.At(2, 1), ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kDepth, Float(), 4, 4).At(1, 1)[0],
              Info(Attribute::kDepth).background[0]);
  // Opaque materials do not look at alpha at all.
  test.scene.materials[0].alpha_mode = scene::AlphaMode::kOpaque;
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kColor, Float(), 4, 4).At(1, 1), ElementsAre(1, 1, 1, 1));
}

TEST_F(AlphaTest, PointsAndLinesAreOnePixelAndUnlit) {
  scene::Material material;
  material.base_color = {0.25f, 0.5f, 1.0f, 1.0f};
  material.emissive = {0.25f, 0, 0};
  TestScene test;
  scene::Primitive points;
  points.mode = scene::PrimitiveMode::kPoints;
  points.positions = {{-0.75f, 0.75f, 0}, {0.25f, 0.25f, 0}};
  points.indices = {0, 1};
  points.material = test.AddMaterial(material);
  scene::Primitive lines = points;
  lines.mode = scene::PrimitiveMode::kLines;
  lines.positions = {{-1.0f, -0.75f, 0}, {1.0f, -0.75f, 0}};
  test.AddNode(test.AddMesh(points), Translate(0, 0, -3));
  test.AddNode(test.AddMesh(lines), Translate(0, 0, -3));
  const Picture color = Render(test, Orthographic(), Attribute::kColor, Float(), 4, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      const bool is_drawn = (x == 0 && y == 0) || (x == 2 && y == 1) || y == 3;
      EXPECT_THAT(color.At(x, y),
                  Near(is_drawn ? std::vector<float>{0.5f, 0.5f, 1, 1} : std::vector<float>{0, 0, 0, 0}))
          << x << " " << y;
    }
  }
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kNormal, Float(), 4, 4).At(0, 0), Near({0, 0, 1, 1}));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kPrimitiveId, Float(), 4, 4).At(2, 1)[0], 2.0f);
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kPrimitiveId, Float(), 4, 4).At(2, 3)[0], 3.0f);
}

}  // namespace
}  // namespace burin::gbuffer
