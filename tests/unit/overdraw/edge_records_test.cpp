// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_records.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin::overdraw {
namespace {

using ::testing::FloatEq;
using ::testing::FloatNear;

constexpr int kSize = 100;

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
  edge.left_vertices = {10, 11, 12};
  edge.right_vertices = {20, 21, 22};
  edge.edge_class = EdgeClass::kCrease;
  edge.beta = beta;
  return edge;
}

EdgeRecords Lines(const std::vector<EdgeSegment>& edges) {
  EdgeRecords records;
  records.records.resize(5);  // what is there before doesn't stay
  records.faces.resize(5);
  BuildLines(edges, {Flat(), kSize, kSize}, records);
  return records;
}

EdgeRecords Areas(const std::vector<EdgeSegment>& edges, const glm::mat4& clip_from_world = Flat()) {
  EdgeRecords records;
  records.records.resize(5);
  records.faces.resize(5);
  BuildAreas(edges, {clip_from_world, kSize, kSize}, records);
  return records;
}

const gbuffer::FaceEdge& FaceOf(const EdgeRecords& records, std::size_t record) {
  return records.faces.at(records.records.at(record).shade.x);
}

void ExpectLeft(const EdgeRecords& records, std::size_t line, float alpha) {
  EXPECT_EQ(FaceOf(records, line).item, 3u);
  EXPECT_EQ(FaceOf(records, line).vertices, (std::array<std::uint32_t, 3>{10, 11, 12}));
  EXPECT_THAT(records.records[line].depth.w, FloatEq(alpha));
}

void ExpectRight(const EdgeRecords& records, std::size_t line, float alpha) {
  EXPECT_EQ(FaceOf(records, line).item, 8u);
  EXPECT_EQ(FaceOf(records, line).vertices, (std::array<std::uint32_t, 3>{20, 21, 22}));
  EXPECT_THAT(records.records[line].depth.w, FloatEq(alpha));
}

TEST(EdgeLines, BelowHalfTheLeftFaceIsDrawnWholeAndTheRightOneOverItAtItsShare) {
  for (const float beta : {0.01f, 0.3f, 0.49f}) {
    const EdgeRecords lines = Lines({Edge(beta)});
    ASSERT_EQ(lines.records.size(), 2u);
    ExpectLeft(lines, 0, 1.0f);
    ExpectRight(lines, 1, beta);
  }
}

TEST(EdgeLines, FromHalfOnTheRightFaceIsDrawnWholeAndTheLeftOneOverIt) {
  for (const float beta : {0.5f, 0.75f, 0.99f}) {
    const EdgeRecords lines = Lines({Edge(beta)});
    ASSERT_EQ(lines.records.size(), 2u);
    ExpectRight(lines, 0, 1.0f);
    ExpectLeft(lines, 1, 1.0f - beta);
  }
}

TEST(EdgeLines, OneFaceAloneIsOneLine) {
  for (const EdgeClass edge_class : {EdgeClass::kSilhouette, EdgeClass::kBoundary, EdgeClass::kCrease}) {
    EdgeSegment left = Edge(0.0f), right = Edge(1.0f);
    left.edge_class = right.edge_class = edge_class;
    const EdgeRecords lines = Lines({left, right});
    ASSERT_EQ(lines.records.size(), 2u);
    EXPECT_EQ(lines.faces.size(), 2u) << "what isn't drawn isn't shaded";
    ExpectLeft(lines, 0, 1.0f);
    ExpectRight(lines, 1, 1.0f);
  }
}

TEST(EdgeLines, KeepTheOrderOfTheEdges) {
  std::vector<EdgeSegment> edges = {Edge(0.0f), Edge(0.2f), Edge(0.8f), Edge(1.0f)};
  for (std::uint32_t i = 0; i < 4; ++i) edges[i].left_item = edges[i].right_item = i;
  const EdgeRecords lines = Lines(edges);
  std::vector<std::uint32_t> items;
  for (std::size_t i = 0; i < lines.records.size(); ++i) items.push_back(FaceOf(lines, i).item);
  EXPECT_THAT(items, ::testing::ElementsAre(0, 1, 1, 2, 2, 3));
  EXPECT_TRUE(Lines({}).records.empty());
}

TEST(EdgeLines, EachSideSaysWhetherItsBackIsSeen) {
  EdgeSegment edge = Edge(0.3f);
  edge.is_left_front = false;
  const EdgeRecords lines = Lines({edge});
  ASSERT_EQ(lines.records.size(), 2u);
  EXPECT_TRUE(FaceOf(lines, 0).is_back);
  EXPECT_FALSE(FaceOf(lines, 1).is_back);
}

TEST(EdgeLines, SlackGrowsWithTheSlopeOfTheFacesThatShow) {
  const auto slack = [](float left_z, float right_z, bool shows_left, bool shows_right) {
    EdgeSegment edge = Edge(0.0f);
    edge.left_corner.z = left_z;
    edge.right_corner.z = right_z;
    edge.shows_left = shows_left;
    edge.shows_right = shows_right;
    return Lines({edge}).records.at(0).depth.z;
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

TEST(EdgeRecords, AreNumbersWhateverTheEdge) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 3e38f}) {
    for (int where = 0; where < 12; ++where) {
      EdgeSegment edge = Edge(0.3f);
      glm::vec3* const points[] = {&edge.ends[0], &edge.ends[1], &edge.left_corner, &edge.right_corner};
      (*points[where / 3])[where % 3] = bad;
      for (const EdgeRecords& records : {Lines({edge}), Areas({edge})}) {
        for (const EdgeRecord& record : records.records) {
          const glm::vec4 sum = record.segment + record.depth;
          EXPECT_TRUE(std::isfinite(sum.x + sum.y + sum.z + sum.w)) << bad << " at " << where;
          EXPECT_GE(record.depth.z, 0.0f);
        }
        for (const gbuffer::FaceEdge& face : records.faces) EXPECT_LT(face.points, 100u);
      }
    }
  }
}

TEST(EdgeAreas, AnInnerEdgeHasTheFaceOnItsPositiveSideFirst) {
  // From the lower end to the upper one in pixels is (0, -1): its (-d.y, d.x) is to the right.
  EdgeSegment edge = Edge(0.0f);
  const EdgeRecords records = Areas({edge});
  ASSERT_EQ(records.records.size(), 1u);
  const EdgeRecord& record = records.records[0];
  EXPECT_EQ(record.segment, glm::vec4(50, 75, 50, 25));
  EXPECT_EQ(record.depth.w, 0.0f);
  EXPECT_EQ(records.faces.at(record.shade.x).item, 8u);
  EXPECT_EQ(records.faces.at(record.shade.y).item, 3u);
}

TEST(EdgeAreas, AnOutlinesSurfaceIsOnThePositiveSide) {
  for (const bool shows_left : {true, false}) {
    EdgeSegment edge = Edge(0.0f);
    edge.shows_left = shows_left;
    edge.shows_right = !shows_left;
    const EdgeRecords records = Areas({edge});
    ASSERT_EQ(records.records.size(), 1u);
    ASSERT_EQ(records.faces.size(), 1u);
    const EdgeRecord& record = records.records[0];
    EXPECT_LT(record.depth.w, 0.0f);
    EXPECT_EQ(FaceOf(records, 0).item, shows_left ? 3u : 8u);
    EXPECT_EQ(record.shade.y, record.shade.x);
    const glm::vec2 d(record.segment.z - record.segment.x, record.segment.w - record.segment.y);
    EXPECT_EQ(-d.y > 0.0f, !shows_left) << "the right face is to the right";
    // The points run with the segment.
    EXPECT_EQ(FaceOf(records, 0).range, d.y < 0.0f ? glm::vec2(0, 1) : glm::vec2(1, 0));
  }
}

TEST(EdgeAreas, OutlinesSayWhetherTheirSurfaceIsSmooth) {
  for (const bool is_smooth : {false, true}) {
    EdgeSegment edge = Edge(0.0f);
    edge.is_smooth = is_smooth;
    EXPECT_EQ(Areas({edge}).records.at(0).depth.w, 0.0f) << "no outline";
    edge.shows_right = false;
    EXPECT_EQ(Areas({edge}).records.at(0).depth.w, is_smooth ? kSmoothOutline : kSharpOutline);
  }
}

TEST(EdgeAreas, LongEdgesAreShadedAtMorePoints) {
  const auto points = [](float length_px) {
    EdgeSegment edge = Edge(0.0f);
    edge.ends = {glm::vec3(0, 0, 0), glm::vec3(0, 2.0f * length_px / kSize, 0)};
    return Areas({edge}).faces.at(0).points;
  };
  EXPECT_EQ(points(0.3f), 1u);
  EXPECT_EQ(points(5.0f), 2u);
  EXPECT_GE(points(40.0f), 5u);
  EXPECT_LE(points(40.0f), 12u);
}

TEST(EdgeAreas, WhatLiesOutsideThePictureIsLeftOut) {
  EdgeSegment outside = Edge(0.0f);
  for (glm::vec3& end : outside.ends) end.x = 1.2f;
  EXPECT_TRUE(Areas({outside}).records.empty());
  EXPECT_TRUE(Areas({outside}).faces.empty());

  // Ten times as long as the picture is wide: only the part in it is shaded, at places that say where it lies.
  EdgeSegment across = Edge(0.0f);
  across.ends = {glm::vec3(-10, 0, 0), glm::vec3(10, 0, 0)};
  const EdgeRecords records = Areas({across});
  ASSERT_EQ(records.records.size(), 1u);
  const gbuffer::FaceEdge& face = FaceOf(records, 0);
  EXPECT_THAT(std::min(face.range.x, face.range.y), FloatNear(0.45f, 0.01f));
  EXPECT_THAT(std::max(face.range.x, face.range.y), FloatNear(0.55f, 0.01f));
  EXPECT_LE(face.points, 20u);
}

TEST(EdgeAreas, PartsInPerspectiveSayWhereTheyLieOnTheEdge) {
  // w grows from 1 to 3 along the edge, which leaves the picture at half of its length there.
  glm::mat4 clip = Flat();
  clip[2][3] = 1.0f;  // w = 1 + z
  EdgeSegment edge = Edge(0.0f);
  edge.ends = {glm::vec3(0, 0, 0), glm::vec3(6.0f, 0, 2.0f)};  // in the picture: x from 0 to 2
  const EdgeRecords records = Areas({edge}, clip);
  ASSERT_EQ(records.records.size(), 1u);
  const gbuffer::FaceEdge& face = FaceOf(records, 0);
  const float end = face.range.y;
  const float x = end * 6.0f / (1.0f + end * 2.0f);  // where that place is seen
  EXPECT_THAT(50.0f + 50.0f * x, FloatNear(records.records[0].segment.z, 0.01f));
  EXPECT_THAT(face.w.y, FloatNear(1.0f + end * 2.0f, 1e-4f));
}

TEST(EdgeRecords, PlacesTakeTheFacesStead) {
  EdgeRecords records = Areas({Edge(0.0f), Edge(0.0f)});
  ASSERT_EQ(records.faces.size(), 4u);
  records.SetPlaces(std::vector<std::uint32_t>{100, 200, 300, 400});
  EXPECT_EQ(records.records[0].shade.x, 100u);
  EXPECT_EQ(records.records[0].shade.y, 200u);
  EXPECT_EQ(records.records[1].shade.x, 300u);
  EXPECT_EQ(records.records[1].shade.y, 400u);
}

}  // namespace
}  // namespace burin::overdraw
