// SPDX-License-Identifier: Apache-2.0

#include "core/scene/primitive_geometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace burin::scene {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(IndexList, FollowsTheSpecification) {
  EXPECT_THAT(IndexList({7, 8, 9}, 0), ElementsAre(7, 8, 9));
  EXPECT_THAT(IndexList({7, 8, 9}, 1), ElementsAre(7, 8));
  EXPECT_THAT(IndexList({7, 8, 9}, 2), ElementsAre(7, 8, 8, 9, 9, 7));
  EXPECT_THAT(IndexList({7, 8, 9}, 3), ElementsAre(7, 8, 8, 9));
  EXPECT_THAT(IndexList({1, 2, 3, 4, 5}, 4), ElementsAre(1, 2, 3));
  EXPECT_THAT(IndexList({1, 2, 3, 4, 5}, 5), ElementsAre(1, 2, 3, 2, 4, 3, 3, 4, 5));
  EXPECT_THAT(IndexList({1, 2, 3, 4}, 6), ElementsAre(2, 3, 1, 3, 4, 1));
}

TEST(IndexList, TakesTooFewIndices) {
  for (int mode = 1; mode < 7; ++mode) {
    EXPECT_THAT(IndexList({}, mode), IsEmpty()) << mode;
    EXPECT_THAT(IndexList({5}, mode), IsEmpty()) << mode;
  }
  EXPECT_THAT(IndexList({5, 6}, 5), IsEmpty());
}

TEST(IndexList, DropsTrianglesThatOnlyJoinStrips) {
  // A strip's odd triangles turn round, so that all face one way: the second part starts at the sixth.
  EXPECT_THAT(IndexList({1, 2, 3, 3, 4, 4, 5, 6}, 5), ElementsAre(1, 2, 3, 4, 6, 5));
}

Primitive Quad() {
  Primitive p;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  p.normals.assign(4, glm::vec3(0, 0, 1));
  p.texcoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  p.indices = {0, 1, 2, 0, 2, 3};
  return p;
}

TEST(DropUnusedVertices, KeepsTheOrderOfTheOthers) {
  Primitive p = Quad();
  p.indices = {3, 1, 2};
  p.targets.push_back({{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}}, {}, {}});
  DropUnusedVertices(p);
  EXPECT_THAT(p.indices, ElementsAre(2, 0, 1));
  EXPECT_THAT(p.positions, ElementsAre(glm::vec3(1, 0, 0), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)));
  EXPECT_EQ(p.targets[0].positions[2], glm::vec3(0, 0, 3));
  EXPECT_EQ(p.texcoords[0].size(), 3u);
}

TEST(MakeFlatNormals, UnsharesVertices) {
  Primitive p = Quad();
  p.positions[3] = {0, 0, -1};  // the second triangle leans back
  MakeFlatNormals(p);
  ASSERT_EQ(p.positions.size(), 6u);
  EXPECT_THAT(p.indices, ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_EQ(p.normals[0], glm::vec3(0, 0, 1));
  const glm::vec3 leaning = glm::normalize(glm::cross(glm::vec3(1, 1, 0), glm::vec3(0, 0, -1)));
  EXPECT_NEAR(glm::distance(p.normals[4], leaning), 0.0f, 1e-6f);
  EXPECT_EQ(p.texcoords[0].size(), 6u);
}

TEST(TriangleNormal, HoldsForTinyAndFlatTriangles) {
  EXPECT_EQ(TriangleNormal({0, 0, 0}, {1e-20f, 0, 0}, {0, 1e-20f, 0}), glm::vec3(0, 0, 1));
  EXPECT_EQ(TriangleNormal({0, 0, 0}, {0, 1, 0}, {1, 0, 0}), glm::vec3(0, 0, -1));
  EXPECT_EQ(TriangleNormal({1, 1, 1}, {1, 1, 1}, {1, 1, 1}), glm::vec3(0, 0, 1));
}

TEST(MakeTangents, PointsAlongGrowingUWithTheImageUpright) {
  Primitive p = Quad();
  MakeTangents(p, 0);
  for (const glm::vec4& tangent : p.tangents) EXPECT_EQ(tangent, glm::vec4(1, 0, 0, 1));
}

TEST(MakeTangents, TurnsHandednessWhereTheTextureIsMirrored) {
  Primitive p = Quad();
  for (glm::vec2& uv : p.texcoords[0]) uv.x = -uv.x;
  MakeTangents(p, 0);
  for (const glm::vec4& tangent : p.tangents) EXPECT_EQ(tangent, glm::vec4(-1, 0, 0, -1));
}

TEST(MakeTangents, SplitsVerticesAtAMirrorSeam) {
  // Two quads side by side; u runs 0, 1, 0: the middle vertices belong to both hands.
  Primitive p;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 2; ++y) {
      p.positions.emplace_back(x, y, 0);
      p.texcoords[0].emplace_back(x == 1 ? 1 : 0, 1 - y);
    }
  }
  p.normals.assign(6, glm::vec3(0, 0, 1));
  p.indices = {0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3};
  MakeTangents(p, 0);
  ASSERT_EQ(p.positions.size(), 8u);
  for (std::size_t i = 0; i < p.indices.size(); ++i) {
    const glm::vec4 tangent = p.tangents[p.indices[i]];
    EXPECT_EQ(tangent, i < 6 ? glm::vec4(1, 0, 0, 1) : glm::vec4(-1, 0, 0, -1)) << i;
  }
}

TEST(MakeTangents, StaysPerpendicularToTheNormal) {
  Primitive p = Quad();
  for (glm::vec3& n : p.normals) n = glm::normalize(glm::vec3(0.5f, -0.25f, 1.0f));
  p.texcoords[0][2] = p.texcoords[0][1];  // one triangle without area in the texture
  MakeTangents(p, 0);
  for (std::size_t i = 0; i < p.tangents.size(); ++i) {
    const glm::vec3 tangent(p.tangents[i]);
    EXPECT_NEAR(glm::dot(tangent, p.normals[i]), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::length(tangent), 1.0f, 1e-6f);
  }
}

}  // namespace
}  // namespace burin::scene
