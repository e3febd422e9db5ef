// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_quads.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace burin::overdraw {
namespace {

constexpr int kWidth = 200, kHeight = 100;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// x and y are clip space's; reversed depth 0.5 + z / 10.
glm::mat4 Flat() {
  glm::mat4 clip(1.0f);
  clip[2][2] = 0.1f;
  clip[3][2] = 0.5f;
  return clip;
}

/// From the origin along -z with the near plane at 0.5: reversed depth 0.5 / distance.
glm::mat4 Perspective() {
  glm::mat4 clip(0.0f);
  clip[0][0] = clip[1][1] = 1.0f;
  clip[3][2] = 0.5f;
  clip[2][3] = -1.0f;
  return clip;
}

QuadOptions Options(const glm::mat4& clip) { return {.clip_from_world = clip, .width = kWidth, .height = kHeight}; }

/// Both faces are seen, on either side of the edge.
EdgeSegment Inner(const glm::vec3& a, const glm::vec3& b) {
  EdgeSegment edge;
  edge.ends = {a, b};
  const glm::vec3 across(a.y - b.y, b.x - a.x, 0.0f);
  edge.left_corner = 0.5f * (a + b) + across;
  edge.right_corner = 0.5f * (a + b) - across;
  edge.edge_class = EdgeClass::kCrease;
  return edge;
}

std::vector<EdgeVertex> Build(std::vector<EdgeSegment> edges, const QuadOptions& options) {
  std::vector<EdgeVertex> vertices;
  BuildEdgeQuads(edges, options, vertices);
  return vertices;
}

glm::vec2 PixelOf(const glm::vec4& clip) {
  return {(0.5f * clip.x / clip.w + 0.5f) * kWidth, (0.5f - 0.5f * clip.y / clip.w) * kHeight};
}

glm::vec2 PixelOf(const EdgeVertex& vertex) { return PixelOf(glm::vec4(vertex.position, 0, 1)); }

bool IsOutline(const EdgeVertex& vertex) { return vertex.depth.w < 0.0f; }

/// How far to the side of the surface (edge_quads.h) the pixel lies, pixels.
float Inwards(const EdgeVertex& vertex, const glm::vec2& pixel) {
  const glm::vec2 d = glm::vec2(vertex.segment.z, vertex.segment.w) - glm::vec2(vertex.segment.x, vertex.segment.y);
  return glm::dot(glm::vec2(-d.y, d.x) / glm::length(d), pixel - glm::vec2(vertex.segment.x, vertex.segment.y));
}

void ExpectFinite(const std::vector<EdgeVertex>& vertices) {
  for (const EdgeVertex& v : vertices) {
    for (const float x : {v.position.x, v.position.y, v.segment.x, v.segment.y, v.segment.z, v.segment.w, v.depth.x,
                          v.depth.y, v.depth.z, v.depth.w})
      ASSERT_TRUE(std::isfinite(x));
    ASSERT_GE(v.depth.z, 0.0f);
  }
}

TEST(EdgeQuads, EndsAreInPixelsFromTheTopLeftWithTheirDepths) {
  const auto quad = Build({Inner({-0.5f, 0.8f, 0}, {0.5f, -0.6f, 2})}, Options(Flat()));
  ASSERT_EQ(quad.size(), 4u);
  for (const EdgeVertex& v : quad) {
    EXPECT_NEAR(v.segment.x, 50, 1e-4f);
    EXPECT_NEAR(v.segment.y, 10, 1e-4f);
    EXPECT_NEAR(v.segment.z, 150, 1e-4f);
    EXPECT_NEAR(v.segment.w, 80, 1e-4f);
    EXPECT_NEAR(v.depth.x, 0.5f, 1e-6f);
    EXPECT_NEAR(v.depth.y, 0.7f, 1e-6f);
    EXPECT_EQ(v.depth.w, static_cast<float>(EdgeClass::kCrease));
  }
}

TEST(EdgeQuads, PerspectiveDividesByTheDistance) {
  const auto quad = Build({Inner({1, 0.5f, -2}, {-1, 0.5f, -4})}, Options(Perspective()));
  ASSERT_EQ(quad.size(), 4u);
  EXPECT_NEAR(quad[0].segment.x, 150, 1e-3f);
  EXPECT_NEAR(quad[0].segment.y, 37.5f, 1e-3f);
  EXPECT_NEAR(quad[0].segment.z, 75, 1e-3f);
  EXPECT_NEAR(quad[0].segment.w, 43.75f, 1e-3f);
  EXPECT_NEAR(quad[0].depth.x, 0.25f, 1e-6f);
  EXPECT_NEAR(quad[0].depth.y, 0.125f, 1e-6f);
}

TEST(EdgeQuads, AnEdgeIsCutAtTheNearPlaneWhicheverEndIsBehind) {
  const glm::vec3 front(0.1f, 0.05f, -2), behind(0.1f, 0.05f, 2);
  for (const bool is_turned : {false, true}) {
    EdgeSegment edge = is_turned ? Inner(behind, front) : Inner(front, behind);
    edge.left_corner = {-1, 0, -2};
    edge.right_corner = {1, 0, -2};
    const auto quad = Build({edge}, Options(Perspective()));
    ASSERT_EQ(quad.size(), 4u);
    glm::vec2 ends[] = {{quad[0].segment.x, quad[0].segment.y}, {quad[0].segment.z, quad[0].segment.w}};
    glm::vec2 depths(quad[0].depth);
    if (is_turned) {
      std::swap(ends[0], ends[1]);
      std::swap(depths.x, depths.y);
    }
    EXPECT_NEAR(ends[0].x, 105, 1e-3f);
    EXPECT_NEAR(ends[1].x, 120, 1e-3f) << "at distance 0.5";
    EXPECT_NEAR(ends[1].y, 45, 1e-3f);
    EXPECT_NEAR(depths.y, 1.0f, 1e-5f);
  }
}

TEST(EdgeQuads, EdgesBehindTheNearPlaneAreLeftOut) {
  EXPECT_TRUE(Build({Inner({0, 0, 1}, {1, 0, 3})}, Options(Perspective())).empty());
  EXPECT_TRUE(Build({Inner({0, 0, -0.3f}, {0.1f, 0, -0.1f})}, Options(Perspective())).empty());
  EXPECT_TRUE(Build({Inner({0, 0, 0}, {0, 0, 0})}, Options(Perspective())).empty()) << "in the eye";
}

TEST(EdgeQuads, AnEdgeIsCutBeyondTheBorderAndKeepsItsLineAndDepth) {
  const auto quad = Build({Inner({-1000, -500, -4}, {1000, 501, 4})}, Options(Flat()));
  ASSERT_EQ(quad.size(), 4u);
  const glm::vec4 s = quad[0].segment;
  EXPECT_GE(s.x, -8);
  EXPECT_LE(s.z, kWidth + 8);
  EXPECT_LE(std::max(s.x, s.z), kWidth + 8);
  const auto depth = [](float x) { return 0.5f + 0.0004f * (2 * x / kWidth - 1); };
  for (const auto& [x, y, z] : {std::tuple(s.x, s.y, quad[0].depth.x), std::tuple(s.z, s.w, quad[0].depth.y)}) {
    EXPECT_NEAR(y, 50 - 50 * (-500 + 1001 * ((2 * x / kWidth - 1) + 1000) / 2000), 0.02f) << "floats of 500 units";
    EXPECT_NEAR(z, depth(x), 1e-5f);
  }
  // The whole picture's width is still there.
  EXPECT_LT(s.x, 0);
  EXPECT_GT(s.z, kWidth);
}

TEST(EdgeQuads, EdgesOutOfThePictureAreLeftOutButNotThoseThatReachIntoIt) {
  const auto at = [](float x) { return Inner({2 * x / kWidth - 1, -0.5f, 0}, {2 * x / kWidth - 1, 0.5f, 0}); };
  EXPECT_TRUE(Build({at(-20)}, Options(Flat())).empty());
  EXPECT_TRUE(Build({at(kWidth + 20)}, Options(Flat())).empty());
  EXPECT_EQ(Build({at(0.2f)}, Options(Flat())).size(), 4u);
  EXPECT_TRUE(Build({Inner({3, 0.5f, 0}, {1.5f, 3, 0})}, Options(Flat())).empty()) << "past a corner";
}

TEST(EdgeQuads, TheSurfaceOfAnOutlineIsOnItsInnerSide) {
  for (int i = 0; i < 12; ++i) {
    const float angle = 0.5235988f * static_cast<float>(i) + 0.1f;
    const glm::vec3 along(0.3f * std::cos(angle), 0.3f * std::sin(angle), 0.0f);
    for (const bool shows_left : {true, false}) {
      EdgeSegment edge = Inner(-along, along);
      edge.shows_left = shows_left;
      edge.shows_right = !shows_left;
      edge.edge_class = EdgeClass::kSilhouette;
      const auto quad = Build({edge}, Options(Flat()));
      ASSERT_EQ(quad.size(), 4u);
      EXPECT_EQ(quad[0].depth.w, -1.0f - static_cast<float>(EdgeClass::kSilhouette));
      const glm::vec3& shown = shows_left ? edge.left_corner : edge.right_corner;
      EXPECT_GT(Inwards(quad[0], PixelOf(Flat() * glm::vec4(shown, 1))), 0.0f) << "angle " << i;
    }
  }
}

TEST(EdgeQuads, AnEdgeWithBothFacesOnOneSideIsAnOutline) {
  EdgeSegment fold = Inner({-0.5f, 0, 0}, {0.5f, 0, 0});
  EXPECT_FALSE(IsOutline(Build({fold}, Options(Flat()))[0]));
  for (const float y : {0.4f, -0.4f}) {
    fold.left_corner = {0, y, -1};
    fold.right_corner = {0.1f, 0.5f * y, 1};
    const auto quad = Build({fold}, Options(Flat()));
    EXPECT_EQ(quad[0].depth.w, -1.0f - static_cast<float>(EdgeClass::kCrease));
    EXPECT_GT(Inwards(quad[0], PixelOf(Flat() * glm::vec4(fold.left_corner, 1))), 0.0f);
  }
}

TEST(EdgeQuads, ACornerBehindTheEyeIsOnTheSideOfTheVisiblePartOfItsFace) {
  std::printf("seed 11\n");
  std::mt19937 random(11);
  std::uniform_real_distribution<float> in(-1.0f, 1.0f);
  int behind = 0;
  for (int i = 0; i < 500; ++i) {
    EdgeSegment edge;
    edge.ends = {glm::vec3(in(random), 0.5f * in(random), -3 + in(random)),
                 glm::vec3(in(random), 0.5f * in(random), -3 + in(random))};
    edge.left_corner = edge.right_corner = {3 * in(random), 3 * in(random), 6 * in(random)};
    edge.shows_right = false;
    edge.edge_class = EdgeClass::kBoundary;
    const auto quad = Build({edge}, Options(Perspective()));
    ASSERT_EQ(quad.size(), 4u);
    const glm::vec3 near_edge = glm::mix(0.5f * (edge.ends[0] + edge.ends[1]), edge.left_corner, 0.01f);
    const float inwards = Inwards(quad[0], PixelOf(Perspective() * glm::vec4(near_edge, 1)));
    if (std::abs(inwards) < 1e-3f) continue;  // the face is seen edge on
    EXPECT_GT(inwards, 0.0f) << "seed 11, edge " << i;
    behind += edge.left_corner.z > 0;
  }
  EXPECT_GT(behind, 100);
}

bool Touches(const glm::vec4& s, const glm::vec2& centre, float half) {
  // Separating axes of a segment and a square (Akenine-Moller, Haines, Hoffman, Real-Time Rendering, 22.10).
  const glm::vec2 a(s.x, s.y), b(s.z, s.w);
  for (int axis = 0; axis < 2; ++axis) {
    if (std::max(a[axis], b[axis]) < centre[axis] - half || std::min(a[axis], b[axis]) > centre[axis] + half)
      return false;
  }
  const glm::vec2 d = b - a, n(-d.y, d.x);
  return std::abs(glm::dot(n, centre - a)) <= half * (std::abs(n.x) + std::abs(n.y));
}

bool IsInQuad(const std::vector<EdgeVertex>& quad, const glm::vec2& p) {
  const auto in_triangle = [&](int i, int j, int k) {
    const glm::vec2 c[] = {PixelOf(quad[static_cast<std::size_t>(i)]), PixelOf(quad[static_cast<std::size_t>(j)]),
                           PixelOf(quad[static_cast<std::size_t>(k)])};
    const auto side = [&](int m) {
      const glm::vec2 e = c[(m + 1) % 3] - c[m], v = p - c[m];
      return e.x * v.y - e.y * v.x;
    };
    return (side(0) >= 0 && side(1) >= 0 && side(2) >= 0) || (side(0) <= 0 && side(1) <= 0 && side(2) <= 0);
  };
  return in_triangle(0, 1, 2) || in_triangle(2, 1, 3);
}

TEST(EdgeQuads, CoverTheCentresOfAllPixelsThatTheEdgeReachesAndFewOthers) {
  std::printf("seed 5\n");
  std::mt19937 random(5);
  std::uniform_real_distribution<float> in(-1.1f, 1.1f);
  for (int i = 0; i < 60; ++i) {
    const float size = i % 2 == 0 ? 1.0f : 0.02f;
    const glm::vec3 middle(in(random), in(random), 0);
    const EdgeSegment edge = Inner(middle, middle + size * glm::vec3(in(random), in(random), in(random)));
    const auto quad = Build({edge}, Options(Flat()));
    const glm::vec2 a = PixelOf(Flat() * glm::vec4(edge.ends[0], 1)), b = PixelOf(Flat() * glm::vec4(edge.ends[1], 1));
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const glm::vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        const bool is_in = !quad.empty() && IsInQuad(quad, centre);
        if (Touches({a, b}, centre, 0.499f)) {
          ASSERT_TRUE(is_in) << "seed 5, edge " << i << ", pixel " << x << " " << y;
        }
        if (!Touches({a, b}, centre, 1.0f)) {
          ASSERT_FALSE(is_in) << "seed 5, edge " << i << ", pixel " << x << " " << y;
        }
      }
    }
  }
}

TEST(EdgeQuads, EdgesWithoutLengthOrNumbersGiveFiniteQuadsOrNone) {
  const glm::vec3 p(0.2f, 0.1f, -3);
  ExpectFinite(Build({Inner(p, p)}, Options(Flat())));
  ExpectFinite(Build({Inner(p, p)}, Options(Perspective())));
  ExpectFinite(Build({Inner(p, {0.2f, 0.1f, -4})}, Options(Flat())));  // along the view
  for (const float bad : {kNan, kInfinity, -kInfinity, 3e38f, -3e38f}) {
    for (int where = 0; where < 12; ++where) {
      for (const glm::mat4& clip : {Flat(), Perspective()}) {
        EdgeSegment edge = Inner(p, {-0.4f, 0.3f, -2});
        glm::vec3* const points[] = {&edge.ends[0], &edge.ends[1], &edge.left_corner, &edge.right_corner};
        (*points[where / 3])[where % 3] = bad;
        for (const bool shows_right : {true, false}) {
          edge.shows_right = shows_right;
          ExpectFinite(Build({edge}, Options(clip)));
        }
      }
    }
  }
}

TEST(EdgeQuads, ManyEdgesKeepTheirOrderAndGiveWhatEachGivesAlone) {
  std::printf("seed 3\n");
  std::mt19937 random(3);
  std::uniform_real_distribution<float> in(-1.5f, 1.5f);
  std::vector<EdgeSegment> edges;
  for (int i = 0; i < 5000; ++i)
    edges.push_back(Inner({in(random), in(random), -2 + in(random)}, {in(random), in(random), -2 + in(random)}));
  std::vector<EdgeVertex> together = Build(edges, Options(Perspective()));
  std::vector<EdgeVertex> alone;
  for (const EdgeSegment& edge : edges) {
    const auto quad = Build({edge}, Options(Perspective()));
    alone.insert(alone.end(), quad.begin(), quad.end());
  }
  EXPECT_LT(alone.size(), 4 * edges.size()) << "some must be left out for this to test anything";
  const auto same = [](const EdgeVertex& a, const EdgeVertex& b) {
    return a.position == b.position && a.segment == b.segment && a.depth == b.depth;
  };
  EXPECT_TRUE(std::ranges::equal(together, alone, same));
  BuildEdgeQuads({}, Options(Flat()), together);
  EXPECT_TRUE(together.empty());
}

}  // namespace
}  // namespace burin::overdraw
