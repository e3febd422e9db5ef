// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/equirectangular.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

namespace burin::gbuffer {
namespace {

using image::CubeLayout;

constexpr std::uint32_t kSeed = 4'177;
constexpr int kFace = 32;
constexpr float kTexel = 2.0f / kFace;  // of directions, which is what colours are here

/// A square of a picture as somebody in the middle of the cube sees it.
struct Face {
  glm::ivec2 place;  ///< in faces
  glm::vec3 forward, right, up;
};

constexpr glm::vec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);
const std::vector<Face> kCross = {
    {{1, 1}, -kZ, kX, kY}, {{2, 1}, kX, kZ, kY}, {{0, 1}, -kX, -kZ, kY}, {{1, 0}, kY, kX, kZ}, {{1, 2}, -kY, kX, -kZ}};

std::vector<Face> FacesOf(CubeLayout layout) {
  std::vector<Face> faces = kCross;
  switch (layout) {
    case CubeLayout::kHorizontalCross:
      faces.push_back({{3, 1}, kZ, -kX, kY});
      break;
    case CubeLayout::kVerticalCross:
      faces.push_back({{1, 3}, kZ, kX, -kY});
      break;
    default: {
      faces.push_back({{5, 0}, kZ, -kX, kY});
      const int order[] = {4, 0, 1, 2, 3};
      for (std::size_t i = 0; i < 5; ++i) faces[i].place = {order[i], 0};
      if (layout == CubeLayout::kColumn) {
        for (Face& face : faces) std::swap(face.place.x, face.place.y);
      }
    }
  }
  return faces;
}

glm::vec3 ColorOf(const glm::vec3& direction) { return 1.0f + glm::normalize(direction); }

EnvironmentMap Picture(CubeLayout layout, int columns, int rows) {
  EnvironmentMap map{.width = columns * kFace, .height = rows * kFace, .pixels = {}};
  map.pixels.resize(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  for (const Face& face : FacesOf(layout)) {
    for (int j = 0; j < kFace; ++j) {
      for (int i = 0; i < kFace; ++i) {
        const float right = kTexel * (static_cast<float>(i) + 0.5f) - 1.0f;
        const float up = 1.0f - kTexel * (static_cast<float>(j) + 0.5f);
        map.pixels[static_cast<std::size_t>((face.place.y * kFace + j) * map.width + face.place.x * kFace + i)] =
            ColorOf(face.forward + right * face.right + up * face.up);
      }
    }
  }
  return map;
}

TEST(Equirectangular, EveryDirectionShowsWhatItsFaceShows) {
  std::mt19937 random(kSeed);
  std::normal_distribution<float> coordinate;
  const std::tuple<CubeLayout, int, int> cases[] = {{CubeLayout::kHorizontalCross, 4, 3},
                                                    {CubeLayout::kVerticalCross, 3, 4},
                                                    {CubeLayout::kRow, 6, 1},
                                                    {CubeLayout::kColumn, 1, 6}};
  for (const auto& [layout, columns, rows] : cases) {
    const EnvironmentMap map = EquirectangularOf(Picture(layout, columns, rows), layout);
    ASSERT_EQ(map.width, 4 * kFace);
    ASSERT_EQ(map.height, 2 * kFace);
    for (int n = 0; n < 1000; ++n) {
      const glm::vec3 d = glm::normalize(glm::vec3(coordinate(random), coordinate(random), coordinate(random)));
      // At the borders of faces and at the poles a texel's width is missing.
      EXPECT_LT(glm::distance(SampleEnvironment(map, d), ColorOf(d)), kTexel)
          << "seed " << kSeed << " layout " << static_cast<int>(layout) << " direction " << d.x << " " << d.y << " "
          << d.z;
    }
  }
}

}  // namespace
}  // namespace burin::gbuffer
