// SPDX-License-Identifier: Apache-2.0
// Random networks of patches, each tessellated without knowing of the others, fit together by the bits of their
// positions. The seed of each network is printed when something fails.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numeric>

#include "core/geometry/bezier_check.h"
#include "core/tessellation/tessellate.h"
#include "tests/support/bezier_networks.h"
#include "tests/support/surface_topology.h"

namespace burin::tessellation {
namespace {

using geometry::BezierPatch;
using geometry::PatchDomain;
using test::Network;
using test::NetworkBuilder;
using test::NetworkShape;

constexpr std::uint32_t kFirstSeed = 52'000;

float RandomFactor(std::mt19937& random) {
  switch (random() % 8) {
    case 0:
      return 1.0f;
    case 1:
      return static_cast<float>(1 + random() % 12);
    case 2:
      return std::uniform_real_distribution<float>(1.0f, 30.0f)(random);
    default:
      return std::uniform_real_distribution<float>(1.0f, 7.0f)(random);
  }
}

NetworkShape RandomShape(std::mt19937& random) {
  NetworkShape shape;
  shape.columns = 1 + static_cast<int>(random() % 3);
  shape.rows = 1 + static_cast<int>(random() % 3);
  shape.is_rational = random() % 4 == 0;
  shape.order = 2 + static_cast<int>(random() % (shape.is_rational ? 3 : 7));
  shape.triangle_share = std::array{0.0, 0.5, 1.0}[random() % 3];
  switch (random() % 5) {
    case 0:
      break;
    case 1:
      shape.is_moebius = true;
      shape.columns += 2;
      break;
    case 2:
      shape.wraps_columns = true;
      shape.columns += 2;
      break;
    case 3:
      shape.wraps_columns = shape.wraps_rows = true;
      shape.columns += 2;
      shape.rows += 2;
      break;
    default:
      // A rational pole is one only where rounding says so, which single_patch_test.cpp looks at.
      shape.has_pole = !shape.is_rational;
      shape.wraps_columns = random() % 2 == 0;
      shape.columns += 2;
      break;
  }
  // Straight sides of order 2 to one point would be one side.
  if (shape.has_pole) shape.order = std::max(shape.order, 3);
  return shape;
}

std::size_t Segments(Pattern pattern, float factor) {
  return static_cast<std::size_t>(pattern == Pattern::kInteger ? std::ceil(factor) : 2.0f * std::ceil(factor / 2.0f));
}

struct Count {
  std::size_t vertices = 0, triangles = 0;
};

/// The closed forms of the patterns, from the segments of each side and, where they are not 0, inside.
Count QuadCount(Pattern pattern, std::size_t u0, std::size_t u1, std::size_t v0, std::size_t v1, std::size_t inside_u,
                std::size_t inside_v) {
  const std::size_t nu = inside_u > 0 ? inside_u : std::max(u0, u1), nv = inside_v > 0 ? inside_v : std::max(v0, v1);
  const std::size_t mu = std::min(u0, u1), mv = std::min(v0, v1);
  if (pattern == Pattern::kInteger) return {nu * nv + mu + mv + 1, 2 * nu * nv + mu + mv - nu - nv};
  return {(nu - 1) * (nv - 1) + u0 + u1 + v0 + v1, 2 * nu * nv - 2 * (nu + nv) + u0 + u1 + v0 + v1};
}

Count TriangleCount(Pattern pattern, std::size_t a, std::size_t b, std::size_t c) {
  if (pattern == Pattern::kInteger) {
    const std::size_t most = std::max(b, c), least = std::min(b, c);
    return {a * most + least + 1, 2 * a * most + least - a - most};
  }
  Count count{1 + a + b + c, 0};
  const std::array<std::size_t, 3> half{a / 2, b / 2, c / 2};
  for (std::size_t s = 0; s < 3; ++s) {
    const std::size_t before = (s + 2) % 3, after = (s + 1) % 3;
    const std::size_t along = std::max(half[before], half[after]), across = std::max(half[s], half[after]);
    count.vertices += along - 1 + (across - 1) * (along - 1);
    count.triangles += 2 * across * along - across - along + half[s] + half[before];
  }
  return count;
}

Count ExpectedCount(const Network& network, std::span<const Factors> factors, Pattern pattern, bool has_pole) {
  Count sum;
  for (std::size_t p = 0; p < factors.size(); ++p) {
    const BezierPatch& patch = network.patches.patches[p];
    std::array<std::size_t, 6> n{};
    const bool has_inside = pattern == Pattern::kFractional && factors[p][kInsideU] > 0.0f;
    for (std::size_t s = 0; s < n.size(); ++s) n[s] = s < 4 || has_inside ? Segments(pattern, factors[p][s]) : 0;
    std::size_t dropped = 0;
    if (has_pole) {
      const auto point = [&](std::uint32_t k) { return network.patches.positions[patch.position.first + k]; };
      const std::uint32_t order = patch.position.u_order, last = order - 1;
      if (patch.domain == PatchDomain::kQuad) {
        const auto collapsed = [&](std::uint32_t first, std::uint32_t step) {
          return point(first) == point(first + step) && point(first) == point(first + last * step);
        };
        const std::array<bool, 4> is{collapsed(0, 1), collapsed(order * last, 1), collapsed(0, order),
                                     collapsed(last, order)};
        for (std::size_t s = 0; s < 4; ++s) {
          if (!is[s]) continue;
          n[s] = has_inside ? n[s < 2 ? kInsideU : kInsideV] : n[s ^ 1];
          dropped += n[s];
        }
      } else {
        // Enough to tell a pole's side: the corners at its ends are one point.
        const glm::vec4 a = point(0), b = point(last), c = point(ValueCount(patch.domain, patch.position) - 1);
        if (a == b) dropped += n[0];
        if (b == c) dropped += n[1];
        if (c == a) dropped += n[2];
      }
    }
    const Count count = patch.domain == PatchDomain::kQuad ? QuadCount(pattern, n[0], n[1], n[2], n[3], n[4], n[5])
                                                           : TriangleCount(pattern, n[0], n[1], n[2]);
    sum.vertices += count.vertices;
    sum.triangles += count.triangles - dropped;
  }
  return sum;
}

/// Edges regardless of direction, as a surface with one side only has them.
void ExpectEveryEdgeTwice(const Surface& surface, const std::vector<std::uint32_t>& welded, std::size_t boundary) {
  std::unordered_map<std::uint64_t, int> uses;
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t a = welded[surface.indices[i + k]], b = welded[surface.indices[i + (k + 1) % 3]];
      ++uses[a < b ? a << 32 | b : b << 32 | a];
    }
  }
  std::size_t once = 0, faulty = 0;
  for (const auto& [edge, count] : uses) {
    once += count == 1 ? 1 : 0;
    faulty += count > 2 ? 1 : 0;
  }
  EXPECT_EQ(once, boundary);
  EXPECT_EQ(faulty, 0u);
}

void ExpectPositiveAreas(const Network& network, const Surface& surface) {
  std::vector<double> areas(network.factors.size());
  std::size_t flat = 0;
  for (std::size_t t = 0; t < surface.indices.size(); t += 3) {
    const auto uv = [&](std::size_t k) { return glm::dvec2(surface.patch_uv[surface.indices[t + k]]); };
    const glm::dvec2 ab = uv(1) - uv(0), ac = uv(2) - uv(0);
    const double twice = ab.x * ac.y - ab.y * ac.x;
    flat += twice > 0.0 ? 0 : 1;
    areas[surface.patch_ids[surface.indices[t]]] += 0.5 * twice;
  }
  EXPECT_EQ(flat, 0u);
  for (std::size_t p = 0; p < areas.size(); ++p) {
    const bool is_quad = network.patches.patches[p].domain == PatchDomain::kQuad;
    EXPECT_NEAR(areas[p], is_quad ? 1.0 : 0.5, 1e-5);
  }
}

void ExpectCornersAreControlPoints(const Network& network, const Surface& surface) {
  std::vector<int> found(network.factors.size());
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const glm::vec2 uv = surface.patch_uv[v];
    const BezierPatch& patch = network.patches.patches[surface.patch_ids[v]];
    const std::uint32_t n = patch.position.u_order, count = ValueCount(patch.domain, patch.position);
    std::uint32_t index = 0;
    if (uv == glm::vec2(1, 0)) {
      index = n - 1;
    } else if (uv == glm::vec2(0, 1)) {
      index = patch.domain == PatchDomain::kQuad ? count - n : count - 1;
    } else if (uv == glm::vec2(1, 1)) {
      index = count - 1;
    } else if (uv != glm::vec2(0, 0)) {
      continue;
    }
    ++found[surface.patch_ids[v]];
    const glm::vec4 point = network.patches.positions[patch.position.first + index];
    // Equal, but for the sign of zeros.
    EXPECT_EQ(surface.positions[v],
              patch.is_rational ? glm::vec3(glm::dvec3(point) / static_cast<double>(point.w)) : glm::vec3(point));
    EXPECT_FALSE(std::signbit(surface.positions[v].x) && surface.positions[v].x == 0.0f);
  }
  for (std::size_t p = 0; p < found.size(); ++p)
    EXPECT_EQ(found[p], network.patches.patches[p].domain == PatchDomain::kQuad ? 4 : 3);
}

std::size_t BoundaryEdges(const Network& network, Pattern pattern) {
  std::size_t edges = 0;
  for (const float factor : network.boundary_factors) edges += Segments(pattern, factor);
  return edges;
}

void CheckNetwork(std::uint32_t seed) {
  std::mt19937 random(seed);
  const NetworkShape shape = RandomShape(random);
  NetworkBuilder builder(shape, random, [&] { return RandomFactor(random); });
  const Network network = builder.Build();
  std::vector<Factors> factors(network.factors.begin(), network.factors.end());
  const bool has_inside = random() % 2 == 0;
  for (Factors& of_patch : factors) {
    if (has_inside) of_patch[kInsideU] = RandomFactor(random), of_patch[kInsideV] = RandomFactor(random);
  }
  ASSERT_TRUE(geometry::CheckPatches(network.patches, "network").has_value());
  for (const Pattern pattern : {Pattern::kInteger, Pattern::kFractional}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << (pattern == Pattern::kInteger ? " integer" : " fractional")
                                    << " order " << shape.order << " pole " << shape.has_pole << " moebius "
                                    << shape.is_moebius << " rational " << shape.is_rational << " inside " << has_inside
                                    << " triangles " << shape.triangle_share << " wraps " << shape.wraps_columns
                                    << shape.wraps_rows);
    Surface surface;
    Tessellate(network.patches, factors, {.pattern = pattern}, surface);
    const Count expected = ExpectedCount(network, factors, pattern, shape.has_pole);
    EXPECT_EQ(surface.positions.size(), expected.vertices);
    EXPECT_EQ(surface.indices.size(), 3 * expected.triangles);
    const SurfaceSize size = MeasureSurface(network.patches, factors, pattern);
    EXPECT_EQ(size.vertices, expected.vertices);
    EXPECT_EQ(size.triangles, expected.triangles);
    const auto welded = test::WeldByBits(surface.positions);
    const std::size_t boundary = BoundaryEdges(network, pattern);
    if (shape.is_moebius) {
      ExpectEveryEdgeTwice(surface, welded, boundary);
    } else {
      const test::EdgeUse use = test::CountEdgeUse(surface.indices, welded);
      EXPECT_EQ(use.faulty, 0u);
      EXPECT_EQ(use.collapsed, 0u);
      EXPECT_EQ(use.boundary, boundary);
    }
    if (!shape.has_pole) ExpectPositiveAreas(network, surface);
    ExpectCornersAreControlPoints(network, surface);
  }
}

TEST(PatchNetworks, FitTogetherByBits) {
  constexpr std::uint32_t kNetworks = 1600;
  for (std::uint32_t n = 0; n < kNetworks; ++n) CheckNetwork(kFirstSeed + n);
}

}  // namespace
}  // namespace burin::tessellation
