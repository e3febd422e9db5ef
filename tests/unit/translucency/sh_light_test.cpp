// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/sh_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <vector>

#include "core/translucency/fresnel.h"

namespace burin::translucency {
namespace {

constexpr double kPi = glm::pi<double>();

const std::vector<glm::dvec3> kNormals = {
    {0, 1, 0}, {0, 0, -1}, glm::normalize(glm::dvec3(1, 2, -3)), glm::normalize(glm::dvec3(-2, 0.3, 0.4))};

TEST(ShLight, LobesOfTheCosine) {
  const std::array<double, kShBands> expected = {3.14159, 2.09440, 0.78540, 0.0, -0.13090};
  const std::array<double, kShBands> lobe = IrradianceLobe(1.0);
  for (std::size_t l = 0; l < lobe.size(); ++l) EXPECT_NEAR(lobe[l], expected[l], 1e-5);
}

TEST(ShLight, LobesWithFresnelFoldedIn) {
  const auto expect = [](double ior, const std::array<double, kShBands>& expected) {
    const std::array<double, kShBands> lobe = IrradianceLobe(ior);
    for (std::size_t l = 0; l < lobe.size(); ++l) EXPECT_NEAR(lobe[l], expected[l], 1e-5) << ior << " band " << l;
  };
  expect(1.3, {2.94954, 2.02036, 0.81918, 0.04021, -0.14169});
  expect(1.4, {2.90028, 1.99169, 0.81408, 0.04547, -0.13924});
  expect(1.5, {2.85326, 1.96235, 0.80598, 0.04846, -0.13663});
}

TEST(ShLight, BasisIsOrthonormal) {
  constexpr int kHeight = 96;
  constexpr int kWidth = 2 * kHeight;
  std::array<std::array<double, kShTerms>, kShTerms> gram{};
  for (int row = 0; row < kHeight; ++row) {
    const double theta = kPi * (row + 0.5) / kHeight;
    const double area = 2.0 * kPi / kWidth * (std::cos(kPi * row / kHeight) - std::cos(kPi * (row + 1) / kHeight));
    for (int column = 0; column < kWidth; ++column) {
      const double phi = 2.0 * kPi * (column + 0.5) / kWidth;
      const auto basis = ShBasis({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
      for (std::size_t i = 0; i < kShTerms; ++i) {
        for (std::size_t j = 0; j < kShTerms; ++j) gram[i][j] += basis[i] * basis[j] * area;
      }
    }
  }
  for (std::size_t i = 0; i < kShTerms; ++i) {
    for (std::size_t j = 0; j < kShTerms; ++j) EXPECT_NEAR(gram[i][j], i == j ? 1.0 : 0.0, 2e-3) << i << " " << j;
  }
}

TEST(ShLight, UniformLightGivesPi) {
  const std::vector<glm::vec3> white(32 * 16, glm::vec3(1.0f, 0.5f, 0.0f));
  const ShRadiance radiance = ProjectLatLong(white, 32, 16);
  for (const glm::dvec3& n : kNormals) {
    const glm::dvec3 plain = EvaluateIrradiance(FoldIrradiance(radiance, 1.0, false), n);
    EXPECT_NEAR(plain.r, kPi, 0.002 * kPi);
    EXPECT_NEAR(plain.g, 0.5 * kPi, 0.002 * kPi);
    EXPECT_NEAR(plain.b, 0.0, 1e-6);
    EXPECT_NEAR(EvaluateIrradiance(FoldIrradiance(radiance, 1.3, false), n).r, 2.94954, 0.006);
  }
}

TEST(ShLight, CubeTexelsCoverTheSphere) {
  for (const int size : {1, 2, 7, 32}) {
    double sum = 0.0;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) sum += CubeTexelSolidAngle(x, y, size);
    }
    EXPECT_NEAR(6.0 * sum, 4.0 * kPi, 1e-9) << size;
  }
}

// One sky in both layouts: brighter towards (1, 2, 3), so that every face and every axis counts.
TEST(ShLight, CubeAndLatLongAgree) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, 3));
  const auto sky = [&](const glm::dvec3& d) {
    return glm::vec3(static_cast<float>(std::exp(2.0 * glm::dot(d, axis))));
  };
  constexpr int kHeight = 64;
  std::vector<glm::vec3> lat_long;
  for (int row = 0; row < kHeight; ++row) {
    const double latitude = kPi * (0.5 - (row + 0.5) / kHeight);
    for (int column = 0; column < 2 * kHeight; ++column) {
      const double longitude = kPi * ((column + 0.5) / kHeight - 1.0);
      lat_long.push_back(sky(
          {std::cos(latitude) * std::sin(longitude), std::sin(latitude), -std::cos(latitude) * std::cos(longitude)}));
    }
  }
  constexpr int kSize = 32;
  std::vector<glm::vec3> cube;
  for (int face = 0; face < 6; ++face) {
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const double s = (2.0 * x + 1.0) / kSize - 1.0;
        const double t = (2.0 * y + 1.0) / kSize - 1.0;
        const std::array<glm::dvec3, 6> directions = {glm::dvec3(1, -t, -s), glm::dvec3(-1, -t, s),
                                                      glm::dvec3(s, 1, t),   glm::dvec3(s, -1, -t),
                                                      glm::dvec3(s, -t, 1),  glm::dvec3(-s, -t, -1)};
        cube.push_back(sky(glm::normalize(directions[static_cast<std::size_t>(face)])));
      }
    }
  }
  const ShRadiance a = ProjectLatLong(lat_long, 2 * kHeight, kHeight);
  const ShRadiance b = ProjectCube(cube, kSize);
  for (std::size_t i = 0; i < kShTerms; ++i) EXPECT_NEAR(a[i].r, b[i].r, 0.01) << i;
}

// Against the integral over the hemisphere.
TEST(ShLight, IrradianceIsThatOfTheHemisphere) {
  const auto sky = [](const glm::dvec3& d) { return 1.0 + 0.8 * d.x + 0.5 * d.y * d.z + (d.z > 0.3 ? 1.0 : 0.0); };
  constexpr int kHeight = 128;
  std::vector<glm::vec3> pixels;
  std::vector<glm::dvec3> directions;
  std::vector<double> areas;
  for (int row = 0; row < kHeight; ++row) {
    const double latitude = kPi * (0.5 - (row + 0.5) / kHeight);
    for (int column = 0; column < 2 * kHeight; ++column) {
      const double longitude = kPi * ((column + 0.5) / kHeight - 1.0);
      directions.emplace_back(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                              -std::cos(latitude) * std::cos(longitude));
      pixels.emplace_back(static_cast<float>(sky(directions.back())));
      areas.push_back(kPi / kHeight * kPi / kHeight * std::cos(latitude));
    }
  }
  const auto folded = FoldIrradiance(ProjectLatLong(pixels, 2 * kHeight, kHeight), 1.3, false);
  for (const glm::dvec3& n : kNormals) {
    double sum = 0.0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double c = glm::dot(directions[i], n);
      if (c > 0.0) sum += sky(directions[i]) * (1.0 - FresnelReflectance(c, 1.3)) * c * areas[i];
    }
    EXPECT_NEAR(EvaluateIrradiance(folded, n).r / sum, 1.0, 0.01);
  }
}

TEST(ShLight, NonFiniteTexelsCountAsNothing) {
  std::vector<glm::vec3> pixels(8 * 4, glm::vec3(1.0f));
  pixels[5] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
  pixels[9].g = std::numeric_limits<float>::infinity();
  for (const glm::dvec3& term : ProjectLatLong(pixels, 8, 4)) {
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(term[c]));
  }
}

TEST(ShLight, WindowTamesTheRinging) {
  std::vector<glm::vec3> pixels(64 * 32, glm::vec3(0.0f));
  for (std::size_t x = 0; x < 64; ++x) pixels[x] = glm::vec3(1000.0f);  // a lamp overhead
  const ShRadiance radiance = ProjectLatLong(pixels, 64, 32);
  const auto least = [&](bool is_windowed) {
    const auto folded = FoldIrradiance(radiance, 1.3, is_windowed);
    double low = 0.0;
    for (double t = 0.0; t <= kPi; t += 0.01) {
      const auto basis = ShBasis({std::sin(t), std::cos(t), 0.0});
      double sum = 0.0;
      for (std::size_t i = 0; i < kShTerms; ++i) sum += static_cast<double>(folded[i].r) * basis[i];
      low = std::min(low, sum);
    }
    return low;
  };
  EXPECT_LT(least(false), 0.0);
  EXPECT_GT(least(true), 0.5 * least(false));
  EXPECT_GE(EvaluateIrradiance(FoldIrradiance(radiance, 1.3, false), {0, -0.2, 0.98}).r, 0.0);
}

}  // namespace
}  // namespace burin::translucency
