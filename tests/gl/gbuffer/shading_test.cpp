// SPDX-License-Identifier: Apache-2.0
// Energy and reference values of the shading; textures as materials use them.
#include <gmock/gmock.h>

#include "tests/gl/gbuffer/scene_fixture.h"

namespace burin::gbuffer {
namespace {

using testing::FloatNear;
using testing::Pointwise;

// Irradiance from nine harmonics and half-float reflections.
constexpr float kFurnace = 0.005f;

auto Near(std::vector<float> values, float tolerance = 1e-5f) { return Pointwise(FloatNear(tolerance), values); }

// glTF 2.0, appendix B, in double precision, for one direction of light.
double MetallicRoughness(double base, double metallic, double roughness, double n_l, double n_v, double n_h,
                         double v_h) {
  const double f0 = 0.04 * (1 - metallic) + base * metallic;
  const double fresnel = f0 + (1 - f0) * std::pow(1 - v_h, 5);
  const double a2 = std::pow(roughness, 4);
  const double d = n_h * n_h * (a2 - 1) + 1;
  const double distribution = a2 / (glm::pi<double>() * d * d);
  const double visibility =
      0.5 / (n_l * std::sqrt(n_v * n_v * (1 - a2) + a2) + n_v * std::sqrt(n_l * n_l * (1 - a2) + a2));
  return (1 - fresnel) * base * (1 - metallic) / glm::pi<double>() + fresnel * distribution * visibility;
}

class ShadingTest : public GbufferTest {
 protected:
  static TestScene WallOf(const scene::Material& material) {
    TestScene test;
    test.AddNode(test.AddMesh(Square(test.AddMaterial(material))), Translate(0, 0, -5));
    return test;
  }
  static scene::Material Surface(float base, float metallic, float roughness) {
    scene::Material material;
    material.base_color = {base, base, base, 1};
    material.metallic = metallic;
    material.roughness = roughness;
    return material;
  }
  // A directional light towards which the wall's normal leans by `angle`.
  static void AddSun(TestScene& test, float lux, float angle_rad) {
    scene::Light light;
    light.intensity = lux;
    test.AddLight(light, glm::rotate(glm::mat4(1.0f), angle_rad, {0, 1, 0}));
  }
};

TEST_F(ShadingTest, AWhiteSurfaceInAWhiteRoomIsWhite) {
  environment_ = UniformEnvironment(1.0f);
  for (const float metallic : {0.0f, 1.0f}) {
    for (const float roughness : {0.0f, 0.25f, 0.5f, 1.0f}) {
      TestScene test;
      test.AddNode(test.AddMesh(Sphere(test.AddMaterial(Surface(1.0f, metallic, roughness)))), Translate(0, 0, -3));
      const Picture picture = Render(test, Perspective(0.6f, 1.0f), Attribute::kColor, Float(), 24, 24);
      for (const auto& [x, y] : {std::pair(12, 12), std::pair(6, 8), std::pair(18, 15)}) {
        EXPECT_THAT(picture.At(x, y), Near({1, 1, 1, 1}, kFurnace))
            << "metallic " << metallic << " roughness " << roughness;
      }
    }
  }
}

TEST_F(ShadingTest, AGreyDiffuseSurfaceReflectsItsShareOfTheRoom) {
  environment_ = UniformEnvironment(2.0f);
  scene::Material material = Surface(0.5f, 0.0f, 1.0f);
  material.ior = 1.0f;  // no reflection at normal incidence
  // What is left of the reflection comes from the fit's bias at grazing angles; none at roughness 1, seen head on.
  EXPECT_THAT(Render(WallOf(material), Orthographic(), Attribute::kColor, Float(), 4, 4).At(1, 1)[0],
              FloatNear(1.0f, 0.03f));
}

TEST_F(ShadingTest, ADirectionalLightMatchesTheBrdf) {
  environment_ = UniformEnvironment(0.0f);
  for (const float metallic : {0.0f, 1.0f}) {
    for (const float roughness : {0.3f, 1.0f}) {
      for (const float angle : {0.0f, 0.9f}) {
        TestScene test = WallOf(Surface(0.6f, metallic, roughness));
        AddSun(test, 2.0f, angle);
        // The view is along the normal; half way between it and the light lies angle / 2.
        const double expected =
            2.0 * std::cos(angle) *
            MetallicRoughness(0.6, metallic, roughness, std::cos(angle), 1.0, std::cos(angle / 2), std::cos(angle / 2));
        EXPECT_THAT(Render(test, Orthographic(), Attribute::kColor, Float(), 4, 4).At(1, 1)[0],
                    FloatNear(static_cast<float>(expected), 2e-3f * static_cast<float>(expected) + 1e-6f))
            << metallic << " " << roughness << " " << angle;
      }
    }
  }
}

TEST_F(ShadingTest, PointLightsFallOffWithTheSquareAndEndAtTheirRange) {
  environment_ = UniformEnvironment(0.0f);
  const auto with = [&](std::optional<float> range) {
    TestScene test = WallOf(Surface(0.6f, 0.0f, 1.0f));
    scene::Light light;
    light.type = scene::LightType::kPoint;
    light.intensity = 4.0f;
    light.range = range;
    test.AddLight(light, Translate(0.25f, 0.25f, -3));  // 2 before the centre of pixel (2, 1)
    return Render(test, Orthographic(), Attribute::kColor, Float(), 4, 4).At(2, 1)[0];
  };
  const auto one = static_cast<float>(MetallicRoughness(0.6, 0, 1, 1, 1, 1, 1));  // 4 cd over 2 m squared: 1 lux
  EXPECT_THAT(with(std::nullopt), FloatNear(one, 2e-3f));
  EXPECT_THAT(with(4.0f), FloatNear(one * (1.0f - 1.0f / 16.0f), 2e-3f));
  EXPECT_EQ(with(1.9f), 0.0f);
}

TEST_F(ShadingTest, SpotLightsEndAtTheirCone) {
  environment_ = UniformEnvironment(0.0f);
  TestScene test = WallOf(Surface(0.6f, 0.0f, 1.0f));
  scene::Light light;
  light.type = scene::LightType::kSpot;
  light.outer_cone_rad = 0.2f;
  test.AddLight(light, Translate(0.125f, 0.125f, -3));
  const Picture picture = Render(test, Orthographic(), Attribute::kColor, Float(), 8, 8);
  EXPECT_GT(picture.At(4, 3)[0], 0.03f);
  EXPECT_EQ(picture.At(6, 3)[0], 0.0f);  // 0.5 to the side over 2: an angle of 0.24
}

TEST_F(ShadingTest, SunlightInLuxIsNotBlownOut) {
  environment_ = UniformEnvironment(0.0f);
  scene::Material white = Surface(1.0f, 0.0f, 1.0f);
  const auto with = [&](float lux) {
    TestScene test = WallOf(white);
    AddSun(test, lux, 0.0f);
    return Render(test, Orthographic(), Attribute::kColor, Float(), 4, 4).At(1, 1)[0];
  };
  EXPECT_THAT(with(100'000.0f), FloatNear(1.0f, 0.05f));
  EXPECT_THAT(with(100'000.0f), FloatNear(with(glm::pi<float>()), 1e-4f));
  EXPECT_THAT(with(1.0f), FloatNear(with(2.0f) / 2, 1e-5f));  // weak lights stay as they are
}

TEST_F(ShadingTest, AModelWithoutLightsIsLitFromAboveAndNotBlownOut) {
  TestScene test;
  test.AddNode(test.AddMesh(Sphere(test.AddMaterial(Surface(0.8f, 0.0f, 0.8f)))), Translate(0, 0, -3));
  const Picture picture = Render(test, Perspective(0.7f, 1.0f), Attribute::kColor, Float(), 32, 32);
  const float above = picture.At(13, 6)[0], middle = picture.At(16, 16)[0], below = picture.At(18, 26)[0];
  EXPECT_GT(above, 1.3f * middle);
  EXPECT_GT(middle, 1.3f * below);
  EXPECT_LT(above, 1.0f);
  EXPECT_GT(below, 0.05f);
}

TEST_F(ShadingTest, OcclusionDimsTheEnvironmentByItsStrength) {
  environment_ = UniformEnvironment(1.0f);
  TestScene test;
  scene::Material material = Surface(1.0f, 0.0f, 1.0f);
  material.occlusion_texture.image = 0;
  material.occlusion_strength = 0.5f;
  test.scene.images.push_back(
      gl::MakeImage<std::uint8_t>(1, 1, 1, image::SampleType::kU8, [](std::size_t) { return 51; }));
  test.AddNode(test.AddMesh(Square(test.AddMaterial(material))), Translate(0, 0, -5));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kColor, Float(), 4, 4).At(1, 1)[0], FloatNear(0.6f, kFurnace));
}

TEST_F(ShadingTest, ABaseColourTextureComesBackInItsOwnNumbers) {
  TestScene test;
  scene::Material material = Unlit({1, 1, 1, 1});
  material.base_color_texture.image = 0;
  material.base_color_texture.sampler = {
      .mag = scene::Filter::kNearest, .min = scene::Filter::kNearest, .mipmaps = false};
  // 8-bit sRGB in, display-encoded 8 bits out: every value must survive.
  test.scene.images.push_back(
      gl::MakeImage<std::uint8_t>(16, 16, 3, image::SampleType::kU8, [](std::size_t i) { return i / 3; }));
  test.AddNode(test.AddMesh(Square(test.AddMaterial(material))), Translate(0, 0, -5));
  const Picture picture = Render(test, Orthographic(), Attribute::kColor, Unorm(), 16, 16, image::Encoding::kDisplay);
  for (int i = 0; i < 256; ++i) EXPECT_EQ(std::lround(picture.At(i % 16, i / 16)[0] * 255), i);
  // 16 bits of the same.
  test.scene.images[0] =
      gl::MakeImage<std::uint16_t>(16, 16, 1, image::SampleType::kU16, [](std::size_t i) { return i * 257; });
  const Picture wide = Render(test, Orthographic(), Attribute::kColor, Unorm(), 16, 16, image::Encoding::kDisplay);
  for (int i = 0; i < 256; ++i) EXPECT_EQ(std::lround(wide.At(i % 16, i / 16)[1] * 255), i);
}

TEST_F(ShadingTest, TextureTransformsAndTheSecondSetApply) {
  TestScene test;
  scene::Material material = Unlit({1, 1, 1, 1});
  material.base_color_texture.image = 0;
  material.base_color_texture.texcoord = 1;
  material.base_color_texture.sampler = {
      .mag = scene::Filter::kNearest, .min = scene::Filter::kNearest, .mipmaps = false};
  // uv' = (v, u + 1): transposed, and repeated.
  material.base_color_texture.uv_transform = glm::mat3(0, 1, 0, 1, 0, 0, 0, 1, 1);
  image::Image map = gl::MakeImage<float>(4, 4, 1, image::SampleType::kF32, [](std::size_t i) { return i; });
  map.encoding = image::Encoding::kSceneLinear;
  test.scene.images.push_back(map);
  scene::Primitive square = Square(test.AddMaterial(material));
  square.texcoords[1] = square.texcoords[0];
  square.texcoords[0].assign(4, {0, 0});
  test.AddNode(test.AddMesh(square), Translate(0, 0, -5));
  const Picture picture = Render(test, Orthographic(), Attribute::kColor, Float(), 4, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) EXPECT_EQ(picture.At(x, y)[0], static_cast<float>(x * 4 + y)) << x << " " << y;
  }
}

TEST_F(ShadingTest, VertexColoursMultiplyTheBaseColour) {
  TestScene test;
  scene::Primitive square = Square(test.AddMaterial(Unlit({0.5f, 1, 1, 1})));
  square.colors.assign(4, {0.5f, 0.25f, 1, 1});
  test.AddNode(test.AddMesh(square), Translate(0, 0, -5));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kColor, Float(), 4, 4).At(1, 1), Near({0.25f, 0.25f, 1, 1}));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kVertexColor, Float(), 4, 4).At(1, 1), Near({0.5f, 0.25f, 1, 1}));
}

}  // namespace
}  // namespace burin::gbuffer
