// SPDX-License-Identifier: Apache-2.0
#include "core/tessellation/tessellate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numbers>

#include "core/geometry/bezier_evaluate.h"
#include "core/tessellation/boundary.h"
#include "tests/support/bezier_networks.h"
#include "tests/support/surface_topology.h"

namespace burin::tessellation {
namespace {

Surface Tessellated(const test::BezierPatches& patches, const Factors& factors, Options options = {}) {
  Surface surface;
  Tessellate(patches, std::vector<Factors>(patches.patches.size(), factors), options, surface);
  return surface;
}

test::BezierPatches Flat(int order) {
  test::BezierPatches patches;
  test::AddQuad(patches, order, order, [&](int i, int j) {
    return glm::vec4(static_cast<float>(i) / static_cast<float>(order - 1),
                     static_cast<float>(j) / static_cast<float>(order - 1), 0.0f, 1.0f);
  });
  return patches;
}

TEST(Tessellate, CountsOfThePapersFigures) {
  const auto quad = Flat(4);
  // Figure 7: 16 and 4 segments along u, 8 and 2 along v.
  const Surface figure7 = Tessellated(quad, {16, 4, 8, 2}, {.pattern = Pattern::kInteger});
  EXPECT_EQ(figure7.positions.size(), 135u);
  EXPECT_EQ(figure7.indices.size(), 3u * 238);
  // Figures 21 and 22: two and eight triangles a patch.
  EXPECT_EQ(Tessellated(quad, {1, 1, 1, 1}, {.pattern = Pattern::kInteger}).indices.size(), 3u * 2);
  EXPECT_EQ(Tessellated(quad, {1, 1, 1, 1}).indices.size(), 3u * 8);
}

TEST(Tessellate, StepsAFractionalSideFromBothEnds) {
  const Surface surface = Tessellated(Flat(2), {4.5f, 2.5f, 1.0f, 1.0f});
  std::vector<float> bottom, top;
  for (const glm::vec3& position : surface.positions) {
    if (position.y == 0.0f) bottom.push_back(position.x);
    if (position.y == 1.0f) top.push_back(position.x);
  }
  std::ranges::sort(bottom);
  std::ranges::sort(top);
  const std::vector<float> expected{0.0f, 1 / 4.5f, 2 / 4.5f, 0.5f, 1 - 2 / 4.5f, 1 - 1 / 4.5f, 1.0f};
  ASSERT_EQ(bottom.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_FLOAT_EQ(bottom[i], expected[i]);
  ASSERT_EQ(top.size(), 5u);
  EXPECT_FLOAT_EQ(top[1], 0.4f);
}

TEST(Tessellate, ClampsFactors) {
  const auto quad = Flat(2);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(Tessellated(quad, {nan, -3.0f, 0.0f, 0.5f}, {.pattern = Pattern::kInteger}).indices.size(), 6u);
  const float inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(Tessellated(quad, {inf, 1000.0f, 1.0f, 1.0f}, {.pattern = Pattern::kInteger}).indices.size(), 3u * 512);
}

TEST(Tessellate, WindsTrianglesAboutTheNormals) {
  test::BezierPatches patches = Flat(4);
  test::AddTriangle(patches, 3, [](float i, float j) { return glm::vec4(i, j, 0.2f * i * j, 1.0f); });
  for (const Pattern pattern : {Pattern::kInteger, Pattern::kFractional}) {
    const Surface surface = Tessellated(patches, {5.0f, 3.5f, 2.0f, 6.5f}, {.pattern = pattern});
    for (std::size_t t = 0; t < surface.indices.size(); t += 3) {
      const auto at = [&](std::size_t k) { return surface.positions[surface.indices[t + k]]; };
      EXPECT_GT(glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), surface.normals[surface.indices[t]]), 0.0f);
    }
  }
}

TEST(Tessellate, EvaluatesEveryAttribute) {
  std::mt19937 random(6);
  std::uniform_real_distribution<float> value(-1.0f, 1.0f);
  test::BezierPatches patches = Flat(3);
  test::AddTriangle(patches, 3, [](float i, float j) { return glm::vec4(i, j, 0.0f, 1.0f); });
  for (auto& patch : patches.patches) {
    const bool is_quad = patch.domain == test::PatchDomain::kQuad;
    const auto net = [&](auto& values, std::uint8_t u, std::uint8_t v) {
      const test::ControlNet added{static_cast<std::uint32_t>(values.size()), u, is_quad ? v : u};
      values.resize(values.size() + ValueCount(patch.domain, added));
      for (auto i = values.begin() + added.first; i != values.end(); ++i) {
        for (int c = 0; c < i->length(); ++c) (*i)[c] = value(random);
      }
      return added;
    };
    patch.normal = net(patches.normals, 3, 2);
    patch.texcoord = {net(patches.texcoords[0], 1, 4), net(patches.texcoords[1], 2, 2)};
    patch.color = net(patches.colors, 8, 5);
  }
  for (const Pattern pattern : {Pattern::kInteger, Pattern::kFractional}) {
    const Surface surface = Tessellated(patches, {4, 8, 2, 4}, {.pattern = pattern});
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      const auto& patch = patches.patches[surface.patch_ids[v]];
      const glm::dvec2 uv(surface.patch_uv[v]);
      const auto exact = [&](const test::ControlNet& net, const auto& values) {
        return glm::vec4(EvaluateNet(patch.domain, net, std::span(values), uv.x, uv.y).value);
      };
      const auto near = [&](auto a, auto b) { EXPECT_LT(glm::distance(a, b), 3e-6f) << v; };
      near(surface.texcoords[0][v], glm::vec2(exact(patch.texcoord[0], patches.texcoords[0])));
      near(surface.texcoords[1][v], glm::vec2(exact(patch.texcoord[1], patches.texcoords[1])));
      near(surface.colors[v], exact(patch.color, patches.colors));
      near(surface.normals[v], glm::normalize(glm::vec3(exact(patch.normal, patches.normals))));
    }
  }
}

TEST(Tessellate, FillsAttributesThatOnlyOtherPatchesHave) {
  test::BezierPatches patches = Flat(2);
  test::AddQuad(patches, 2, 2, [](float i, float j) { return glm::vec4(i, j, 1.0f, 1.0f); });
  patches.patches[0].color = {0, 1, 1};
  patches.colors = {{0.25f, 0.5f, 0.75f, 1.0f}};
  patches.patches[1].texcoord[0] = {0, 1, 1};
  patches.texcoords[0] = {{2.0f, 3.0f}};
  const Surface surface = Tessellated(patches, {1, 1, 1, 1}, {.pattern = Pattern::kInteger});
  ASSERT_EQ(surface.colors.size(), 8u);
  EXPECT_EQ(surface.colors[0], glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
  EXPECT_EQ(surface.colors[7], glm::vec4(1.0f));
  EXPECT_EQ(surface.texcoords[0][0], glm::vec2(0.0f));
  EXPECT_EQ(surface.texcoords[0][7], glm::vec2(2.0f, 3.0f));
  EXPECT_TRUE(surface.texcoords[1].empty());
  EXPECT_TRUE(surface.tangents.empty());
}

TEST(Tessellate, LeavesOutWhatIsNotWanted) {
  const Surface surface = Tessellated(Flat(4), {3, 3, 3, 3}, {.wants_patch_uv = false, .wants_patch_ids = false});
  EXPECT_TRUE(surface.patch_uv.empty());
  EXPECT_TRUE(surface.patch_ids.empty());
  EXPECT_TRUE(Tessellated({}, {}).indices.empty());
}

TEST(Tessellate, MakesTangentsAlongTextureCoordinates) {
  // Texture coordinates (y, x): they turn clockwise with the surface.
  test::BezierPatches patches = Flat(4);
  patches.patches[0].texcoord[0] = {0, 2, 2};
  patches.texcoords[0] = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  for (const glm::vec4& tangent : Tessellated(patches, {3, 3, 3, 3}, {.wants_tangents = true}).tangents)
    EXPECT_LT(glm::distance(tangent, glm::vec4(0, 1, 0, 1)), 1e-6f);
  // Along the patch's u where it has none; the handedness that MikkTSpace gives (u, v).
  for (const glm::vec4& tangent : Tessellated(Flat(4), {3, 3, 3, 3}, {.wants_tangents = true}).tangents)
    EXPECT_LT(glm::distance(tangent, glm::vec4(1, 0, 0, -1)), 1e-6f);
  // Of no length where texture coordinates are one point: any unit vector across the normal.
  patches.texcoords[0] = {{1, 1}, {1, 1}, {1, 1}, {1, 1}};
  for (const glm::vec4& tangent : Tessellated(patches, {3, 3, 3, 3}, {.wants_tangents = true}).tangents) {
    EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1.0f, 1e-6f);
    EXPECT_NEAR(tangent.z, 0.0f, 1e-6f);
  }
}

/// An eighth of the unit sphere; side v = 1 is the pole (0, 0, 1), where points differ by their weights alone.
test::BezierPatches Octant() {
  const float h = std::numbers::sqrt2_v<float> / 2.0f;
  const float x[3] = {1, h, 0}, y[3] = {0, h, 1}, w[3] = {1, h, 1}, rho[3] = {1, h, 0}, z[3] = {0, h, 1};
  test::BezierPatches patches;
  test::AddQuad(
      patches, 3, 3, [&](int i, int j) { return glm::vec4(x[i] * rho[j], y[i] * rho[j], z[j] * w[i], w[i] * w[j]); },
      true);
  return patches;
}

TEST(Tessellate, KnowsARationalSphereUpToItsPole) {
  for (const Pattern pattern : {Pattern::kInteger, Pattern::kFractional}) {
    // The pole's own factor does not matter: it is cut like the side opposite.
    const Surface surface = Tessellated(Octant(), {7.5f, 1.0f, 8.0f, 8.0f}, {.pattern = pattern});
    std::size_t at_pole = 0;
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      EXPECT_NEAR(glm::length(surface.positions[v]), 1.0f, 3e-7f);
      EXPECT_LT(glm::distance(surface.normals[v], surface.positions[v]), 2e-6f) << v;
      at_pole += surface.positions[v] == glm::vec3(0, 0, 1) ? 1 : 0;
    }
    EXPECT_EQ(at_pole, 9u);
    const auto use = test::CountEdgeUse(surface.indices, test::WeldByBits(surface.positions));
    EXPECT_EQ(use.faulty, 0u);
    EXPECT_EQ(use.collapsed, 0u);
    EXPECT_EQ(use.boundary, 8u + 8 + 8);
  }
}

TEST(Tessellate, GivesAConesTipANormalForEachTriangle) {
  const float h = std::numbers::sqrt2_v<float> / 2.0f;
  test::BezierPatches patches;
  const glm::vec4 ring[3] = {{1, 0, 0, 1}, {h, h, 0, h}, {0, 1, 0, 1}};
  test::AddQuad(
      patches, 3, 2, [&](int i, int j) { return j == 0 ? ring[i] : glm::vec4(0, 0, ring[i].w, ring[i].w); }, true);
  const Surface surface = Tessellated(patches, {8, 8, 4, 4});
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    // Of a cone as high as wide, normals rise by 45 degrees everywhere, the tip's too.
    EXPECT_NEAR(surface.normals[v].z, h, 1e-5f);
    EXPECT_NEAR(glm::length(surface.normals[v]), 1.0f, 1e-6f);
  }
}

TEST(Tessellate, MeetsDegenerateInputWithNumbers) {
  test::BezierPatches patches;
  test::AddQuad(patches, 4, 4, [](int, int) { return glm::vec4(1, 2, 3, 1); });
  test::AddTriangle(patches, 4, [](int, int) { return glm::vec4(1, 2, 3, 1); });
  test::AddQuad(patches, 4, 4, [](float i, int) { return glm::vec4(i, 0, 0, 1); });
  test::AddQuad(patches, 8, 8, [](float i, float j) { return glm::vec4(i * 1e37f, j * 1e37f, 0, 1); });
  test::AddQuad(patches, 3, 3, [](float i, float j) { return glm::vec4(i * 1e-38f, j * 1e-38f, 0, 1); });
  for (const Pattern pattern : {Pattern::kInteger, Pattern::kFractional}) {
    const Surface surface = Tessellated(patches, {4, 4, 4, 4}, {.pattern = pattern, .wants_tangents = true});
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      EXPECT_TRUE(std::isfinite(glm::dot(surface.positions[v], glm::vec3(1e-3f))));
      EXPECT_NEAR(glm::length(surface.normals[v]), 1.0f, 1e-5f) << v << " patch " << surface.patch_ids[v];
      EXPECT_NEAR(glm::length(glm::vec3(surface.tangents[v])), 1.0f, 1e-5f);
    }
  }
}

/// A dome's sector whose pole is not quite a point: the side v = 0 runs out by `loop` and back, the wrong way round.
test::BezierPatches SectorWithLoop(float loop) {
  test::BezierPatches patches;
  const float net[4][4][3] = {{{0, 0, 1}, {0, -loop, 1}, {loop, 0, 1}, {0, 0, 1}},
                              {{0.5f, 0, 1}, {0.5f, -0.3f, 1}, {0.3f, -0.5f, 1}, {0, -0.5f, 1}},
                              {{1, 0, 0.5f}, {1, -0.6f, 0.5f}, {0.6f, -1, 0.5f}, {0, -1, 0.5f}},
                              {{1, 0, 0}, {1, -0.6f, 0}, {0.6f, -1, 0}, {0, -1, 0}}};
  test::AddQuad(patches, 4, 4, [&](int i, int j) { return glm::vec4(net[j][i][0], net[j][i][1], net[j][i][2], 1); });
  return patches;
}

TEST(Tessellate, NormalsOfATinyLoopAreThoseNextToIt) {
  const test::BezierPatches patches = SectorWithLoop(0.002f);
  const auto& patch = patches.patches.front();
  ASSERT_EQ(SideShapes(patches, patch)[0], SideShape::kLoop);
  ASSERT_TRUE(IsNearlyPoint(patches, patch, 0));
  Surface surface;
  Tessellate(patches, std::vector<Factors>{{8, 8, 8, 8}}, {.pattern = Pattern::kFractional}, surface);
  const glm::dvec3 turned = geometry::EvaluateBezier(patches, patch, 0.5, 0.0).normal;
  std::size_t on_loop = 0;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    if (surface.patch_uv[v].y != 0.0f) continue;
    const glm::dvec3 inside = geometry::EvaluateBezier(patches, patch, surface.patch_uv[v].x, 0.01).normal;
    EXPECT_GT(glm::dot(glm::dvec3(surface.normals[v]), inside), std::cos(glm::radians(8.0))) << surface.patch_uv[v].x;
    EXPECT_LT(glm::dot(turned, inside), 0.0) << "the loop's own normals must point away";
    ++on_loop;
  }
  EXPECT_EQ(on_loop, 9u);
}

TEST(Tessellate, WideLoopsKeepTheirNormals) {
  const test::BezierPatches patches = SectorWithLoop(0.2f);
  const auto& patch = patches.patches.front();
  ASSERT_EQ(SideShapes(patches, patch)[0], SideShape::kLoop);
  EXPECT_FALSE(IsNearlyPoint(patches, patch, 0));
  Surface surface;
  Tessellate(patches, std::vector<Factors>{{8, 8, 8, 8}}, {.pattern = Pattern::kInteger}, surface);
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const glm::vec2 uv = surface.patch_uv[v];
    const glm::dvec3 exact = geometry::EvaluateBezier(patches, patch, uv.x, uv.y).normal;
    EXPECT_LT(glm::distance(glm::dvec3(surface.normals[v]), exact), 1e-5) << uv.x << " " << uv.y;
  }
}

TEST(Tessellate, ALoopOfOneSegmentHasNoTriangles) {
  const test::BezierPatches patches = SectorWithLoop(0.2f);
  const std::vector<Factors> coarse{{1, 2, 2, 2}};
  Surface surface;
  Tessellate(patches, coarse, {.pattern = Pattern::kInteger}, surface);
  EXPECT_EQ(test::CountEdgeUse(surface.indices, test::WeldByBits(surface.positions)).collapsed, 0u);
  EXPECT_EQ(MeasureSurface(patches, coarse, Pattern::kInteger).triangles, surface.indices.size() / 3);
  // One fewer than the pattern's 2 NuNv - Nu - Nv + nu + nv.
  EXPECT_EQ(surface.indices.size() / 3, 2u * 2 * 2 - 2 - 2 + 1 + 2 - 1);
}

TEST(Tessellator, GivesWhatAFreshOneGives) {
  Tessellator tessellator;
  Surface surface;
  const auto quad = Flat(4);
  for (const float factor : {3.0f, 9.5f, 3.0f, 200.0f, 1.0f, 9.5f}) {
    const std::vector<Factors> factors{Factors{factor, 2.0f, factor, 7.0f}};
    tessellator.Tessellate(quad, factors, {.revision = 1}, surface);
    const Surface fresh = Tessellated(quad, factors[0]);
    EXPECT_EQ(surface.indices, fresh.indices);
    EXPECT_EQ(surface.positions, fresh.positions);
    EXPECT_EQ(surface.normals, fresh.normals);
  }
}

TEST(Tessellator, SeesChangedPatchesByTheirRevision) {
  Tessellator tessellator;
  Surface surface;
  test::BezierPatches patches = Flat(4);
  const std::vector<Factors> factors{Factors{3, 3, 3, 3}};
  for (std::uint64_t revision = 1; revision < 4; ++revision) {
    for (const bool has_tangents : {false, true}) {
      const Options options{.wants_tangents = has_tangents, .revision = revision};
      tessellator.Tessellate(patches, factors, options, surface);
      Surface fresh;
      Tessellate(patches, factors, {.wants_tangents = has_tangents}, fresh);
      EXPECT_EQ(surface.positions, fresh.positions);
      EXPECT_EQ(surface.normals, fresh.normals);
      EXPECT_EQ(surface.tangents, fresh.tangents);
    }
    patches.positions[5].z += 0.25f;
  }
  // Without a revision nothing is taken for granted.
  patches.positions[6].z = 2.0f;
  tessellator.Tessellate(patches, factors, {}, surface);
  EXPECT_EQ(surface.positions, Tessellated(patches, factors[0]).positions);
}

}  // namespace
}  // namespace burin::tessellation
