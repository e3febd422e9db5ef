// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which vertices one patch has and in what order, before anything is evaluated.

#include <array>
#include <cstdint>

#include "core/tessellation/boundary.h"
#include "core/tessellation/spacing.h"

namespace burin::tessellation {

/// A side's vertices in its own direction: its two corners, and a run of vertices between them.
struct Side {
  Spacing spacing;
  std::uint32_t first = 0, last = 0;  ///< corners
  std::uint32_t inner = 0;            ///< the first of the others
  SideShape shape = SideShape::kOpen;

  [[nodiscard]] std::uint32_t segments() const { return spacing.segments(); }
  /// All vertices are at one place.
  [[nodiscard]] bool is_collapsed() const {
    return shape == SideShape::kPoint || (shape == SideShape::kLoop && segments() == 1);
  }
  [[nodiscard]] bool StartAdjoins() const { return first + 1 == inner; }
  [[nodiscard]] bool EndAdjoins() const { return last == inner + segments() - 1; }
  [[nodiscard]] std::uint32_t Vertex(std::uint32_t i) const {
    return i == 0 ? first : i == segments() ? last : inner + i - 1;
  }
};

/// Vertices are counted from 0 a patch: those of the sides, then those inside, row by row. Every corner comes just
/// before the inner vertices of one side (StartAdjoins) or just after (EndAdjoins).
struct PatchLayout {
  geometry::PatchDomain domain = geometry::PatchDomain::kQuad;
  Pattern pattern = Pattern::kFractional;
  std::uint32_t side_count = 4;
  std::array<Side, 4> sides;  ///< in the order of Factors
  /// Quads, and triangles seen as quads whose side v = 1 is a point: lines inside, as Factors says.
  Spacing columns, rows;
  std::uint32_t interior = 0;
  /// Fractional triangles: a spoke runs from the middle of each side to the centre; the three quads between them have
  /// interiors of their own, the one at corner c between side c and the side before it.
  struct Spoke {
    std::uint32_t segments = 1;
    double step = 1.0;  ///< of a parameter that is 0 at the middle of the side and 1 at the centre
    std::uint32_t inner = 0;
  };
  std::array<Spoke, 3> spokes;
  std::array<std::uint32_t, 3> corner_interiors{};
  std::uint32_t centre = 0;

  std::uint32_t vertex_count = 0;
  std::uint32_t triangle_count = 0;  ///< with those that lie on collapsed sides

  [[nodiscard]] bool HasCollapsedSide() const {
    bool any = false;
    for (const Side& side : sides) any |= side.is_collapsed();
    return any;
  }
};

/// `factors`: within [1, kMaxFactor], or 0 inside. `shapes`: one a side. A side of a quad that is a point is cut like
/// the lines inside or the side opposite to it, whatever its own factor, so that each of the triangles that meet there
/// has a vertex with its own normal and texture coordinates; no neighbour can tell.
[[nodiscard]] PatchLayout LayoutOf(geometry::PatchDomain domain, Pattern pattern, const Factors& factors,
                                   const std::array<SideShape, 4>& shapes);

}  // namespace burin::tessellation
