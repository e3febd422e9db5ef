// SPDX-License-Identifier: Apache-2.0
// The fractional pattern changes without pops: vertices move by no more than the factors do, new ones are born on
// existing ones, and edges come and go only with one of their ends (Moreton, section 5.2).
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <tuple>

#include "core/tessellation/kernels.h"
#include "core/tessellation/patch_layout.h"
#include "core/tessellation/pattern.h"
#include "tests/support/bezier_networks.h"

namespace burin::tessellation {
namespace {

using geometry::PatchDomain;

constexpr std::uint32_t kSeed = 70'401;
constexpr float kStep = 0.001f;
// A parameter i / f moves by i / f^2 a unit of f, at most 1/4 for i <= f / 2 and f >= 2, where there is such an i.
constexpr double kMostPerStep = 0.25 * kStep * 1.01 + 1e-7;

/// What a vertex is, whatever the factors: where it lies on the side, spoke or grid that it belongs to, counted from
/// the nearest end.
enum class Place { kSide, kGrid, kSpoke, kCorner, kCentre };
constexpr int kMiddle = 1'000;
struct Label {
  Place place;
  std::uint32_t which;  ///< side, spoke or corner
  int a, b;             ///< from the start 0, 1, ..., from the end -1, -2, ...; kMiddle
  auto operator<=>(const Label&) const = default;
};

int FromNearestEnd(const Spacing& spacing, std::uint32_t i) {
  if (i < spacing.per_half) return static_cast<int>(i);
  if (i == spacing.per_half) return kMiddle;
  return -1 - static_cast<int>(spacing.segments() - i);
}

/// Of every vertex, in the layout's order.
std::vector<Label> Labels(const PatchLayout& layout) {
  std::vector<Label> labels(layout.vertex_count);
  for (std::uint32_t s = 0; s < layout.side_count; ++s) {
    const Side& side = layout.sides[s];
    for (std::uint32_t i = 0; i <= side.segments(); ++i)
      labels[side.Vertex(i)] = {Place::kSide, s, FromNearestEnd(side.spacing, i), 0};
  }
  // A corner belongs to two sides: it gets a name of its own.
  std::map<std::uint32_t, std::uint32_t> corners;
  for (std::uint32_t s = 0; s < layout.side_count; ++s) {
    for (const auto& [vertex, end] : {std::pair(layout.sides[s].first, 0u), std::pair(layout.sides[s].last, 1u)}) {
      const auto name = corners.try_emplace(vertex, 2 * s + end).first->second;
      labels[vertex] = {Place::kSide, 10 + name, 0, 0};
    }
  }
  if (layout.domain == PatchDomain::kQuad) {
    const std::uint32_t columns = layout.columns.segments() - 1, rows = layout.rows.segments() - 1;
    for (std::uint32_t r = 0; r < rows; ++r) {
      for (std::uint32_t c = 0; c < columns; ++c)
        labels[layout.interior + r * columns + c] = {Place::kGrid, 0, FromNearestEnd(layout.columns, c + 1),
                                                     FromNearestEnd(layout.rows, r + 1)};
    }
    return labels;
  }
  labels[layout.centre] = {Place::kCentre, 0, 0, 0};
  for (std::uint32_t s = 0; s < 3; ++s) {
    const auto across = static_cast<int>(layout.spokes[(s + 2) % 3].segments);
    const auto along = static_cast<int>(layout.spokes[s].segments);
    for (int j = 1; j < along; ++j) {
      labels[layout.spokes[s].inner + static_cast<std::uint32_t>(j) - 1] = {Place::kSpoke, s, j, 0};
      for (int i = 1; i < across; ++i)
        labels[layout.corner_interiors[s] + static_cast<std::uint32_t>((j - 1) * (across - 1) + i - 1)] = {
            Place::kCorner, s, i, j};
    }
  }
  return labels;
}

int Merged(int coordinate, const Spacing& old) {
  if (coordinate == kMiddle) return kMiddle;
  const int from_end = coordinate >= 0 ? coordinate : -1 - coordinate;
  return from_end < static_cast<int>(old.per_half) ? coordinate : kMiddle;
}

/// Where a vertex was born: the label that `label` had in the coarser `old` layout.
Label Merged(Label label, const PatchLayout& old) {
  switch (label.place) {
    case Place::kSide:
      if (label.which < 4) label.a = Merged(label.a, old.sides[label.which].spacing);
      return label;
    case Place::kGrid:
      return {Place::kGrid, 0, Merged(label.a, old.columns), Merged(label.b, old.rows)};
    case Place::kSpoke:
      if (label.a >= static_cast<int>(old.spokes[label.which].segments)) return {Place::kCentre, 0, 0, 0};
      return label;
    case Place::kCorner: {
      const std::uint32_t before = (label.which + 2) % 3;
      const bool at_u_end = label.a >= static_cast<int>(old.spokes[before].segments);
      const bool at_v_end = label.b >= static_cast<int>(old.spokes[label.which].segments);
      if (at_u_end && at_v_end) return {Place::kCentre, 0, 0, 0};
      if (at_u_end) return {Place::kSpoke, label.which, label.b, 0};
      if (at_v_end) return {Place::kSpoke, before, label.a, 0};
      return label;
    }
    case Place::kCentre:
      return label;
  }
  return label;
}

using Triangle = std::array<Label, 3>;

std::set<Triangle> Triangles(const PatchLayout& layout, const PatchLayout& merge_into) {
  std::vector<std::uint32_t> indices(std::size_t{3} * layout.triangle_count);
  WritePattern(PlainKernels(), layout, 0, indices.data());
  const std::vector<Label> labels = Labels(layout);
  std::set<Triangle> triangles;
  for (std::size_t t = 0; t < indices.size(); t += 3) {
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = Merged(labels[indices[t + k]], merge_into);
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    std::ranges::rotate(triangle, std::ranges::min_element(triangle));
    triangles.insert(triangle);
  }
  return triangles;
}

PatchLayout Layout(PatchDomain domain, const Factors& factors) {
  return LayoutOf(domain, Pattern::kFractional, factors, {});
}

TEST(FractionalPattern, MergingNewVerticesGivesTheOldTriangles) {
  std::mt19937 random(kSeed);
  std::uniform_int_distribution<int> half(1, 7);
  for (int n = 0; n < 1'500; ++n) {
    for (const PatchDomain domain : {PatchDomain::kQuad, PatchDomain::kTriangle}) {
      Factors before{};
      for (float& factor : before) factor = 2.0f * static_cast<float>(half(random));
      Factors after = before;
      // Half of the patches are cut inside as their sides are.
      if (n % 2 == 0) before[kInsideU] = before[kInsideV] = after[kInsideU] = after[kInsideV] = 0.0f;
      // One side or several pass an even factor at once.
      const auto sides = 1 + random() % (n % 2 == 0 ? 15 : 63);
      for (std::size_t s = 0; s < before.size(); ++s) after[s] += (sides >> s & 1) != 0 ? kStep : 0.0f;
      const PatchLayout old = Layout(domain, before), now = Layout(domain, after);
      ASSERT_EQ(Triangles(now, old), Triangles(old, old))
          << "seed " << kSeed << " case " << n << " factors " << before[0] << " " << before[1] << " " << before[2]
          << " " << before[3] << " inside " << before[4] << " " << before[5] << " sides " << sides;
    }
  }
}

struct Swept {
  std::map<Label, std::pair<glm::vec2, glm::vec3>> vertices;
  PatchLayout layout;
};

Swept Sweep(const test::BezierPatches& patches, const Factors& factors, Surface& surface) {
  Tessellate(patches, std::span(&factors, 1), {.is_parallel = false}, surface);
  Swept swept{.vertices = {}, .layout = Layout(patches.patches[0].domain, factors)};
  const std::vector<Label> labels = Labels(swept.layout);
  for (std::size_t v = 0; v < labels.size(); ++v)
    swept.vertices[labels[v]] = {surface.patch_uv[v], surface.positions[v]};
  return swept;
}

double LeastArea(const Surface& surface) {
  double least = 1.0;
  for (std::size_t t = 0; t < surface.indices.size(); t += 3) {
    const auto uv = [&](std::size_t k) { return glm::dvec2(surface.patch_uv[surface.indices[t + k]]); };
    const glm::dvec2 ab = uv(1) - uv(0), ac = uv(2) - uv(0);
    least = std::min(least, ab.x * ac.y - ab.y * ac.x);
  }
  return least;
}

/// Sweeps the factors from `from` on for `steps` steps; the sides keep their ratios.
void SweepWindow(const test::BezierPatches& patches, const Factors& ratios, float from, int steps, double speed) {
  Surface surface;
  std::optional<Swept> last;
  for (int n = 0; n <= steps; ++n) {
    Factors factors{};
    for (std::size_t s = 0; s < factors.size(); ++s) {
      // Without a ratio of its own the inside follows the sides.
      if (ratios[s] > 0.0f) factors[s] = std::max(1.0f, ratios[s] * (from + kStep * static_cast<float>(n)));
    }
    Swept now = Sweep(patches, factors, surface);
    // Triangles are thin at birth, but none turns over by more than what rounding its parameters does.
    ASSERT_GT(LeastArea(surface), -1.5e-7) << "factor " << factors[0];
    if (last) {
      for (const auto& [label, vertex] : now.vertices) {
        const auto before = last->vertices.find(Merged(label, last->layout));
        ASSERT_NE(before, last->vertices.end());
        ASSERT_LE(glm::distance(vertex.first, before->second.first), std::sqrt(2.0) * kMostPerStep)
            << "factor " << factors[0] << " seed " << kSeed;
        ASSERT_LE(glm::distance(vertex.second, before->second.second), speed * kMostPerStep);
      }
    }
    last = std::move(now);
  }
}

TEST(FractionalPattern, VerticesMoveNoFasterThanFactors) {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f), ratio(0.4f, 1.0f), start(1.0f, 63.9f);
  // A derivative of a cubic is at most 3 times the longest difference of two control points, along u and along v.
  const double speed = 2.0 * 3.0 * std::sqrt(12.0);
  for (int n = 0; n < 24; ++n) {
    test::BezierPatches patches;
    const auto point = [&](int, int) {
      return glm::vec4(coordinate(random), coordinate(random), coordinate(random), 1.0f);
    };
    n % 2 == 0 ? test::AddQuad(patches, 4, 4, point) : test::AddTriangle(patches, 4, point);
    Factors ratios{1.0f, ratio(random), ratio(random), ratio(random)};
    if (n % 3 != 0) ratios[kInsideU] = ratio(random), ratios[kInsideV] = ratio(random);
    // Half of the windows are about an even factor, where vertices are born.
    const float at = n % 4 < 2 ? start(random) : 2.0f * static_cast<float>(1 + n % 31) - 0.003f;
    SweepWindow(patches, ratios, at, 8, speed);
  }
}

TEST(FractionalPattern, HasNoPopFromFactorOneToSix) {
  std::mt19937 random(kSeed + 1);
  std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
  test::BezierPatches patches;
  test::AddQuad(patches, 4, 4,
                [&](int, int) { return glm::vec4(coordinate(random), coordinate(random), coordinate(random), 1.0f); });
  SweepWindow(patches, {1.0f, 0.7f, 1.0f, 0.5f}, 1.0f, 5'000, 2.0 * 3.0 * std::sqrt(12.0));
}

}  // namespace
}  // namespace burin::tessellation
