// SPDX-License-Identifier: Apache-2.0
// The counts are those of the patterns of Moreton, sections 5 and 7.
#include "core/tessellation/patch_layout.h"

#include <algorithm>

namespace burin::tessellation {
namespace {

using geometry::PatchDomain;

/// Triangles of a rectangle of `across` x `along` lines that has `u` and `v` segments on its two outer sides: cells
/// between the lines, and two strips.
std::uint32_t QuadrantTriangles(std::uint32_t across, std::uint32_t along, std::uint32_t u, std::uint32_t v) {
  return 2 * across * along - across - along + u + v;
}

class Numbering {
 public:
  [[nodiscard]] std::uint32_t Take(std::uint32_t count) {
    const std::uint32_t first = next_;
    next_ += count;
    return first;
  }
  [[nodiscard]] std::uint32_t next() const { return next_; }

 private:
  std::uint32_t next_ = 0;
};

Spacing Denser(const Spacing& a, const Spacing& b) { return a.step <= b.step ? a : b; }

/// 0: as the sides say.
float InsideFactor(PatchDomain domain, Pattern pattern, const Factors& factors, std::size_t which) {
  return domain == PatchDomain::kQuad && pattern == Pattern::kFractional ? factors[which] : 0.0f;
}

void NumberQuadSides(PatchLayout& layout, Numbering& numbering) {
  auto& [bottom, top, left, right] = layout.sides;
  for (Side* side : {&bottom, &top}) {
    side->first = numbering.Take(1);
    side->inner = numbering.Take(side->segments() - 1);
    side->last = numbering.Take(1);
  }
  left.first = bottom.first;
  left.last = top.first;
  right.first = bottom.last;
  right.last = top.last;
  for (Side* side : {&left, &right}) side->inner = numbering.Take(side->segments() - 1);
}

void NumberTriangleSides(PatchLayout& layout, Numbering& numbering) {
  for (std::uint32_t s = 0; s < 3; ++s) {
    layout.sides[s].first = numbering.Take(1);
    layout.sides[s].inner = numbering.Take(layout.sides[s].segments() - 1);
  }
  for (std::uint32_t s = 0; s < 3; ++s) layout.sides[s].last = layout.sides[(s + 1) % 3].first;
}

void NumberGrid(PatchLayout& layout, Numbering& numbering) {
  layout.interior = numbering.Take((layout.columns.segments() - 1) * (layout.rows.segments() - 1));
}

void NumberSpokes(PatchLayout& layout, Numbering& numbering) {
  layout.centre = numbering.Take(1);
  for (std::uint32_t s = 0; s < 3; ++s) {
    PatchLayout::Spoke& spoke = layout.spokes[s];
    const Spacing denser = Denser(layout.sides[(s + 1) % 3].spacing, layout.sides[(s + 2) % 3].spacing);
    spoke.segments = denser.per_half;
    spoke.step = 2.0 * denser.step;
    spoke.inner = numbering.Take(spoke.segments - 1);
  }
  for (std::uint32_t c = 0; c < 3; ++c) {
    const std::uint32_t across = layout.spokes[(c + 2) % 3].segments, along = layout.spokes[c].segments;
    layout.corner_interiors[c] = numbering.Take((across - 1) * (along - 1));
    layout.triangle_count +=
        QuadrantTriangles(across, along, layout.sides[c].spacing.per_half, layout.sides[(c + 2) % 3].spacing.per_half);
  }
}

std::uint32_t GridTriangles(const PatchLayout& layout) {
  const auto& sides = layout.sides;
  const std::uint32_t across = layout.columns.segments(), along = layout.rows.segments();
  if (layout.domain == PatchDomain::kTriangle)
    // The side that is a point has one segment and its triangle no area.
    return QuadrantTriangles(across, along, 0, std::min(sides[1].segments(), sides[2].segments()));
  if (layout.pattern == Pattern::kInteger)
    return QuadrantTriangles(across, along, std::min(sides[0].segments(), sides[1].segments()),
                             std::min(sides[2].segments(), sides[3].segments()));
  std::uint32_t triangles = 0;
  for (const std::uint32_t u : {0, 1}) {
    for (const std::uint32_t v : {2, 3})
      triangles += QuadrantTriangles(across / 2, along / 2, sides[u].spacing.per_half, sides[v].spacing.per_half);
  }
  return triangles;
}

}  // namespace

PatchLayout LayoutOf(PatchDomain domain, Pattern pattern, const Factors& factors,
                     const std::array<SideShape, 4>& shapes) {
  PatchLayout layout;
  layout.domain = domain;
  layout.pattern = pattern;
  layout.side_count = domain == PatchDomain::kQuad ? 4 : 3;
  for (std::uint32_t s = 0; s < layout.side_count; ++s) {
    const bool is_free = domain == PatchDomain::kQuad && shapes[s] == SideShape::kPoint;
    const float inside = InsideFactor(domain, pattern, factors, s < 2 ? kInsideU : kInsideV);
    layout.sides[s].spacing = SpacingOf(pattern, !is_free ? factors[s] : inside > 0.0f ? inside : factors[s ^ 1u]);
    layout.sides[s].shape = shapes[s];
  }
  const auto& sides = layout.sides;
  Numbering numbering;
  if (domain == PatchDomain::kQuad) {
    const float u = InsideFactor(domain, pattern, factors, kInsideU);
    const float v = InsideFactor(domain, pattern, factors, kInsideV);
    layout.columns = u > 0.0f ? SpacingOf(pattern, u) : Denser(sides[0].spacing, sides[1].spacing);
    layout.rows = v > 0.0f ? SpacingOf(pattern, v) : Denser(sides[2].spacing, sides[3].spacing);
    NumberQuadSides(layout, numbering);
  } else {
    layout.columns = sides[0].spacing;
    layout.rows = Denser(sides[1].spacing, sides[2].spacing);
    NumberTriangleSides(layout, numbering);
  }
  if (domain == PatchDomain::kTriangle && pattern == Pattern::kFractional) {
    NumberSpokes(layout, numbering);
  } else {
    NumberGrid(layout, numbering);
    layout.triangle_count = GridTriangles(layout);
  }
  layout.vertex_count = numbering.next();
  return layout;
}

}  // namespace burin::tessellation
