// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_lines.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace burin::overdraw {
namespace {

using ::testing::FloatEq;

/// x and y are clip space's; reversed depth 0.5 + z / 10.
glm::mat4 Flat() {
  glm::mat4 clip(1.0f);
  clip[2][2] = 0.1f;
  clip[3][2] = 0.5f;
  return clip;
}

EdgeSegment Edge(float beta) {
  EdgeSegment edge;
  edge.ends = {glm::vec3(0, -0.5f, 0), glm::vec3(0, 0.5f, 0)};
  edge.left_corner = {-0.5f, 0, 0};
  edge.right_corner = {0.5f, 0, 0};
  edge.left_item = 3;
  edge.right_item = 8;
  edge.left_vertices = {10, 11};
  edge.right_vertices = {20, 21};
  edge.edge_class = EdgeClass::kCrease;
  edge.beta = beta;
  return edge;
}

std::vector<gbuffer::ShadedLine> Build(const std::vector<EdgeSegment>& edges) {
  std::vector<gbuffer::ShadedLine> lines(5);  // what is there before doesn't stay
  BuildShadedLines(edges, Flat(), 100, 100, lines);
  return lines;
}

void ExpectLeft(const gbuffer::ShadedLine& line, float alpha) {
  EXPECT_EQ(line.item, 3u);
  EXPECT_EQ(line.vertices, (std::array<std::uint32_t, 2>{10, 11}));
  EXPECT_THAT(line.alpha, FloatEq(alpha));
}

void ExpectRight(const gbuffer::ShadedLine& line, float alpha) {
  EXPECT_EQ(line.item, 8u);
  EXPECT_EQ(line.vertices, (std::array<std::uint32_t, 2>{20, 21}));
  EXPECT_THAT(line.alpha, FloatEq(alpha));
}

TEST(EdgeLines, BelowHalfTheLeftFaceIsDrawnWholeAndTheRightOneOverItAtItsShare) {
  for (const float beta : {0.01f, 0.3f, 0.49f}) {
    const auto lines = Build({Edge(beta)});
    ASSERT_EQ(lines.size(), 2u);
    ExpectLeft(lines[0], 1.0f);
    ExpectRight(lines[1], beta);
  }
}

TEST(EdgeLines, FromHalfOnTheRightFaceIsDrawnWholeAndTheLeftOneOverIt) {
  for (const float beta : {0.5f, 0.75f, 0.99f}) {
    const auto lines = Build({Edge(beta)});
    ASSERT_EQ(lines.size(), 2u);
    ExpectRight(lines[0], 1.0f);
    ExpectLeft(lines[1], 1.0f - beta);
  }
}

TEST(EdgeLines, OneFaceAloneIsOneLine) {
  for (const EdgeClass edge_class : {EdgeClass::kSilhouette, EdgeClass::kBoundary, EdgeClass::kCrease}) {
    EdgeSegment left = Edge(0.0f), right = Edge(1.0f);
    left.edge_class = right.edge_class = edge_class;
    const auto lines = Build({left, right});
    ASSERT_EQ(lines.size(), 2u);
    ExpectLeft(lines[0], 1.0f);
    ExpectRight(lines[1], 1.0f);
  }
}

TEST(EdgeLines, KeepTheOrderOfTheEdges) {
  std::vector<EdgeSegment> edges = {Edge(0.0f), Edge(0.2f), Edge(0.8f), Edge(1.0f)};
  for (std::uint32_t i = 0; i < 4; ++i) edges[i].left_item = edges[i].right_item = i;
  std::vector<std::uint32_t> items;
  for (const gbuffer::ShadedLine& line : Build(edges)) items.push_back(line.item);
  EXPECT_THAT(items, ::testing::ElementsAre(0, 1, 1, 2, 2, 3));
  EXPECT_TRUE(Build({}).empty());
}

TEST(EdgeLines, EachSideSaysWhetherItsBackIsSeen) {
  EdgeSegment edge = Edge(0.3f);
  edge.is_left_front = false;
  const auto lines = Build({edge});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_TRUE(lines[0].is_back);
  EXPECT_FALSE(lines[1].is_back);
}

TEST(EdgeLines, SlackGrowsWithTheSlopeOfTheFacesThatShow) {
  const auto slack = [](float left_z, float right_z, bool shows_left, bool shows_right) {
    EdgeSegment edge = Edge(0.0f);
    edge.left_corner.z = left_z;
    edge.right_corner.z = right_z;
    edge.shows_left = shows_left;
    edge.shows_right = shows_right;
    return Build({edge})[0].slack;
  };
  // The face rises by 0.1 * z of depth over 25 pixels.
  EXPECT_GE(slack(0, 0, true, true), 0.0f);
  EXPECT_LT(slack(0, 0, true, true), 1e-5f);
  EXPECT_GT(slack(0.1f, 0, true, true), 0.5f * 0.01f / 25) << "the centres beside an edge are half a pixel off";
  EXPECT_LT(slack(0.1f, 0, true, true), 2.0f * 0.01f / 25);
  EXPECT_GT(slack(0.2f, 0, true, true), slack(0.1f, 0, true, true));
  EXPECT_EQ(slack(0, 0.1f, true, true), slack(0.1f, 0, true, true));
  EXPECT_EQ(slack(0.1f, 0, false, true), slack(0, 0, true, true)) << "what isn't on screen hides nothing";
  EXPECT_LT(slack(1e6f, 0, true, true), 0.1f) << "a face seen edge on has any slope, and farther things stay hidden";
}

TEST(EdgeLines, SlackIsANumberWhateverTheEdge) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 3e38f}) {
    for (int where = 0; where < 12; ++where) {
      EdgeSegment edge = Edge(0.3f);
      glm::vec3* const points[] = {&edge.ends[0], &edge.ends[1], &edge.left_corner, &edge.right_corner};
      (*points[where / 3])[where % 3] = bad;
      for (const gbuffer::ShadedLine& line : Build({edge})) {
        EXPECT_TRUE(std::isfinite(line.slack)) << bad << " at " << where;
        EXPECT_GE(line.slack, 0.0f);
      }
    }
  }
}

}  // namespace
}  // namespace burin::overdraw
