// SPDX-License-Identifier: Apache-2.0
#include "core/tessellation/tessellate.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/geometry/bezier_evaluate.h"
#include "tests/support/bezier_networks.h"
#include "tests/support/surface_topology.h"

namespace burin::tessellation {
namespace {

using geometry::BezierPatches;

BezierPatches Bump(int order) {
  BezierPatches patches;
  test::AddQuad(patches, order, order, [&](int i, int j) {
    const float x = static_cast<float>(i) / static_cast<float>(order - 1),
                y = static_cast<float>(j) / static_cast<float>(order - 1);
    return glm::vec4(x, y, 0.3f * std::sin(3.1f * x) * std::cos(2.3f * y), 1.0f);
  });
  return patches;
}

TEST(TessellateQuick, TeapotIsWatertight) {
  const auto teapot = test::ReadBpt(test::SharedData("bezier/teapot_32.bpt"));
  if (!teapot) GTEST_SKIP();
  for (const Pattern pattern : {Pattern::kInteger, Pattern::kFractional}) {
    for (const float f : {1.0f, 2.0f, 2.5f, 5.0f, 16.0f}) {
      std::vector<Factors> factors(teapot->patches.size(), Factors{f, f, f, f});
      Surface surface;
      Tessellate(*teapot, factors, {.pattern = pattern}, surface);
      const auto welded = test::WeldByBits(surface.positions);
      const auto use = test::CountEdgeUse(surface.indices, welded);
      printf("%d %g: %zu vertices %zu triangles inner %zu boundary %zu faulty %zu collapsed %zu\n", int(pattern), f,
             surface.positions.size(), surface.indices.size() / 3, use.inner, use.boundary, use.faulty, use.collapsed);
      float worst = 0, worst_normal = 0;
      for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        const auto at = geometry::EvaluateBezier(*teapot, teapot->patches[surface.patch_ids[v]], surface.patch_uv[v].x,
                                                 surface.patch_uv[v].y);
        worst = std::max(worst, glm::distance(surface.positions[v], glm::vec3(at.position)));
        worst_normal = std::max(worst_normal, glm::distance(surface.normals[v], glm::vec3(at.normal)));
      }
      printf("   worst %g normal %g\n", worst, worst_normal);
      EXPECT_LT(worst, 1e-5f);
    }
  }
}

TEST(TessellateQuick, TriangleMatches) {
  BezierPatches patches;
  for (const int order : {2, 3, 4, 8}) {
    test::AddTriangle(patches, order, [&](int i, int j) {
      const float x = static_cast<float>(i) / static_cast<float>(order - 1),
                  y = static_cast<float>(j) / static_cast<float>(order - 1);
      return glm::vec4(x, y, 0.3f * std::sin(3.1f * x) * std::cos(2.3f * y), 1.0f);
    });
  }
  for (const Pattern pattern : {Pattern::kInteger, Pattern::kFractional}) {
    for (const Factors& f :
         {Factors{1, 1, 1}, Factors{2.5, 2.5, 2.5}, Factors{7, 3, 4.5}, Factors{1, 9, 2}, Factors{16, 16, 16}}) {
      std::vector<Factors> factors(patches.patches.size(), f);
      Surface surface;
      Tessellate(patches, factors, {.pattern = pattern}, surface);
      float worst = 0, worst_normal = 0;
      double area = 0;
      for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        const auto at = geometry::EvaluateBezier(patches, patches.patches[surface.patch_ids[v]], surface.patch_uv[v].x,
                                                 surface.patch_uv[v].y);
        worst = std::max(worst, glm::distance(surface.positions[v], glm::vec3(at.position)));
        worst_normal = std::max(worst_normal, glm::distance(surface.normals[v], glm::vec3(at.normal)));
      }
      float least = 1;
      for (std::size_t t = 0; t < surface.indices.size(); t += 3) {
        const glm::vec2 a = surface.patch_uv[surface.indices[t]], b = surface.patch_uv[surface.indices[t + 1]],
                        c = surface.patch_uv[surface.indices[t + 2]];
        const float twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        least = std::min(least, twice);
        area += twice / 2;
      }
      printf("%d (%g %g %g): %zu v %zu t worst %g normal %g area %.9g least %g\n", int(pattern), f[0], f[1], f[2],
             surface.positions.size(), surface.indices.size() / 3, worst, worst_normal, area, least);
      EXPECT_LT(worst, 1e-6f);
    }
  }
}

TEST(TessellateQuick, QuadArea) {
  BezierPatches patches = Bump(4);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> factor(1.0f, 20.0f);
  for (int n = 0; n < 200; ++n) {
    for (const Pattern pattern : {Pattern::kInteger, Pattern::kFractional}) {
      const std::vector<Factors> factors{Factors{factor(random), factor(random), factor(random), factor(random)}};
      Surface surface;
      Tessellate(patches, factors, {.pattern = pattern}, surface);
      double area = 0;
      for (std::size_t t = 0; t < surface.indices.size(); t += 3) {
        const glm::vec2 a = surface.patch_uv[surface.indices[t]], b = surface.patch_uv[surface.indices[t + 1]],
                        c = surface.patch_uv[surface.indices[t + 2]];
        const float twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        EXPECT_GT(twice, 0.0f);
        area += twice / 2;
      }
      EXPECT_NEAR(area, 1.0, 1e-5);
      const auto use = test::CountEdgeUse(surface.indices, test::WeldByBits(surface.positions));
      EXPECT_EQ(use.faulty, 0u);
    }
  }
}

}  // namespace
}  // namespace burin::tessellation
