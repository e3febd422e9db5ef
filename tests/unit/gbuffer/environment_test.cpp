// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/environment.h"

#include <gmock/gmock.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <random>

namespace burin::gbuffer {
namespace {

constexpr float kPi = glm::pi<float>();

EnvironmentMap Uniform(const glm::vec3& radiance, int width = 64) {
  return {.width = width,
          .height = width / 2,
          .pixels = std::vector<glm::vec3>(static_cast<std::size_t>(width * width / 2), radiance)};
}

// radiance(direction) over the whole sphere.
template <class Function>
EnvironmentMap FromFunction(int width, Function&& radiance) {
  EnvironmentMap map{.width = width, .height = width / 2, .pixels = {}};
  for (int y = 0; y < map.height; ++y) {
    const float latitude = kPi * (0.5f - (static_cast<float>(y) + 0.5f) / static_cast<float>(map.height));
    for (int x = 0; x < width; ++x) {
      const float longitude = 2 * kPi * ((static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 0.5f);
      map.pixels.push_back(radiance(glm::vec3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                              -std::cos(latitude) * std::cos(longitude))));
    }
  }
  return map;
}

float Evaluate(const std::array<glm::vec3, 9>& sh, const glm::vec3& n) {
  return 0.282095f * sh[0].r + 0.488603f * (n.y * sh[1].r + n.z * sh[2].r + n.x * sh[3].r) +
         1.092548f * (n.x * n.y * sh[4].r + n.y * n.z * sh[5].r + n.x * n.z * sh[7].r) +
         0.315392f * (3 * n.z * n.z - 1) * sh[6].r + 0.546274f * (n.x * n.x - n.y * n.y) * sh[8].r;
}

TEST(Environment, TheCentreLiesAtMinusZAndXGrowsToTheRight) {
  EnvironmentMap map = Uniform(glm::vec3(0.0f));
  const auto set = [&](int x, int y, float value) {
    map.pixels[static_cast<std::size_t>(y * 64 + x)] = glm::vec3(value);
  };
  for (int i = 0; i < 2; ++i) {
    for (int j = 15; j < 17; ++j) {
      set(31 + i, j, 1);  // the middle
      set(47 + i, j, 2);  // three quarters to the right
    }
  }
  for (int x = 0; x < 64; ++x) set(x, 0, 3);
  EXPECT_FLOAT_EQ(SampleEnvironment(map, {0, 0, -1}).r, 1);
  EXPECT_FLOAT_EQ(SampleEnvironment(map, {5, 0, 0}).r, 2);
  EXPECT_FLOAT_EQ(SampleEnvironment(map, {0, 1, 0}).r, 3);
  EXPECT_FLOAT_EQ(SampleEnvironment(map, {0, -1, 0}).r, 0);
}

TEST(Environment, LookUpsWrapRoundTheBack) {
  EnvironmentMap map = Uniform(glm::vec3(0.0f));
  for (int y = 0; y < 32; ++y) map.pixels[static_cast<std::size_t>(y * 64)] = glm::vec3(1.0f);
  EXPECT_NEAR(SampleEnvironment(map, {0, 0, 1}).r, 0.5f, 1e-4f);  // between the first column and the last
}

TEST(Environment, AUniformRoomGivesItsOwnRadianceEverywhere) {
  const EnvironmentMap map = Uniform({1.5f, 1.5f, 1.5f});
  const auto sh = ProjectIrradiance(map);
  std::mt19937 random(20031005);
  std::normal_distribution<float> normal;
  for (int i = 0; i < 100; ++i) {
    const glm::vec3 n = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
    EXPECT_NEAR(Evaluate(sh, n), 1.5f, 2e-3f);
  }
  for (const auto& level : FilterReflections(map, 32).levels) {
    for (const glm::vec3& texel : level) ASSERT_NEAR(texel.g, 1.5f, 1e-4f);
  }
}

TEST(Environment, IrradianceOfALinearSkyMatchesTheIntegral) {
  // Radiance 1 + d.y: irradiance / pi is 1 + 2/3 n.y exactly, and nine harmonics hold it.
  const auto sh = ProjectIrradiance(FromFunction(128, [](const glm::vec3& d) { return glm::vec3(1.0f + d.y); }));
  EXPECT_NEAR(Evaluate(sh, {0, 1, 0}), 1.0f + 2.0f / 3.0f, 2e-3f);
  EXPECT_NEAR(Evaluate(sh, {0, -1, 0}), 1.0f / 3.0f, 2e-3f);
  EXPECT_NEAR(Evaluate(sh, {1, 0, 0}), 1.0f, 2e-3f);
}

TEST(Environment, TheMirrorLevelIsTheMapAndRoughnessSpreadsIt) {
  const auto lamp = [](const glm::vec3& d) { return glm::vec3(d.x > 0.95f ? 10.0f : 0.0f); };
  const ReflectionMap map = FilterReflections(FromFunction(256, lamp), 64);
  ASSERT_EQ(map.levels.size(), 4u);
  const auto center = [&](std::size_t level, int face) {
    const int size = 64 >> level;
    return map.levels[level][static_cast<std::size_t>((face * size + size / 2) * size + size / 2)].r;
  };
  EXPECT_NEAR(center(0, 0), 10.0f, 1e-3f);  // +x
  EXPECT_NEAR(center(0, 1), 0.0f, 1e-3f);   // -x
  EXPECT_NEAR(center(0, 5), 0.0f, 1e-3f);
  for (std::size_t level = 1; level < 4; ++level) EXPECT_LT(center(level, 0), center(level - 1, 0) + 1e-3f);
  EXPECT_GT(center(3, 0), center(3, 5));
}

TEST(Environment, PrefilteringKeepsTheLightThatARoughSurfaceSees) {
  // A sky of 1 + d.y at roughness 1: by the lobe's symmetry the level is 1 + c n.y with one c everywhere.
  const ReflectionMap map =
      FilterReflections(FromFunction(256, [](const glm::vec3& d) { return glm::vec3(1.0f + d.y); }), 64);
  const auto& rough = map.levels.back();
  const auto face = [&](int index) { return rough[static_cast<std::size_t>((index * 8 + 4) * 8 + 4)].r; };
  EXPECT_NEAR(face(2) + face(3), 2.0f, 0.02f);
  EXPECT_NEAR(face(2) - 1.0f, 2.0f / 3.0f, 0.06f);  // weights n.l over GGX of roughness 1: the cosine lobe
}

TEST(Environment, ImagesOfEveryKindAreTaken) {
  image::Image grey;
  grey.width = 2;
  grey.height = 1;
  grey.channels = 1;
  grey.type = image::SampleType::kU8;
  grey.pixels = {std::byte{255}, std::byte{0}};
  const auto map = EnvironmentFromImage(grey);
  ASSERT_TRUE(map.has_value());
  EXPECT_EQ(map->pixels[0], glm::vec3(1.0f));
  EXPECT_EQ(map->pixels[1], glm::vec3(0.0f));

  image::Image bad;
  bad.width = 1;
  bad.height = 1;
  bad.channels = 3;
  bad.type = image::SampleType::kF32;
  bad.encoding = image::Encoding::kSceneLinear;
  bad.pixels.resize(12);
  bad.As<float>()[0] = std::numeric_limits<float>::quiet_NaN();
  bad.As<float>()[1] = std::numeric_limits<float>::infinity();
  bad.As<float>()[2] = -1.0f;
  EXPECT_EQ(EnvironmentFromImage(bad)->pixels[0], glm::vec3(0.0f, 65504.0f, 0.0f));
  EXPECT_EQ(EnvironmentFromImage({}).error().message, "the environment map is empty");
}

}  // namespace
}  // namespace burin::gbuffer
