// SPDX-License-Identifier: Apache-2.0
// Moreton, sections 5 and 7. Every pattern is made of one piece: a rectangle with a regular grid of lines, whose two
// sides next to one of its corners ("outer") have vertices of their own. Two strips, which meet in the diagonal at that
// corner, join those with the first lines of the grid. An integer quad is one such piece, a fractional quad four, a
// fractional triangle three.
#include "core/tessellation/pattern.h"

#include <algorithm>
#include <array>
#include <span>

namespace burin::tessellation {
namespace {

using geometry::PatchDomain;

constexpr std::uint32_t kMaxSegments = static_cast<std::uint32_t>(kMaxFactor);
using Line = std::array<std::uint32_t, kMaxSegments + 1>;

/// A side seen from one of its ends.
struct DirectedSide {
  const Side* side;
  bool is_reversed;
  [[nodiscard]] std::uint32_t Vertex(std::uint32_t i) const {
    return side->Vertex(is_reversed ? side->segments() - i : i);
  }
  /// The first `segments` from this end.
  void Fill(std::uint32_t segments, Line& line) const {
    for (std::uint32_t i = 0; i <= segments; ++i) line[i] = Vertex(i);
  }
};

class TriangleWriter {
 public:
  TriangleWriter(const Kernels& kernels, std::uint32_t first_vertex, std::uint32_t* out)
      : kernels_(kernels), first_(first_vertex), out_(out) {}

  /// Whether the pieces that follow have their axes the wrong way round.
  void SetMirrored(bool is_mirrored) { is_mirrored_ = is_mirrored; }
  void Add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    out_[0] = first_ + a;
    out_[1] = first_ + (is_mirrored_ ? c : b);
    out_[2] = first_ + (is_mirrored_ ? b : c);
    out_ += 3;
  }
  /// The two triangles of each cell between two lines. Their diagonals run away from the corner, like those of strips.
  void AddCells(std::span<const std::uint32_t> low, std::span<const std::uint32_t> high) {
    is_mirrored_ ? AddCells<true>(low, high) : AddCells<false>(low, high);
  }
  /// Repeats what was written `cells_back` cells ago, for `cells` cells whose vertices all lie `shift` further on.
  void AddShifted(std::size_t cells_back, std::size_t cells, std::uint32_t shift) {
    kernels_.shift_indices(out_ - 6 * cells_back, 6 * cells, shift, out_);
    out_ += 6 * cells;
  }

 private:
  template <bool kIsMirrored>
  void AddCells(std::span<const std::uint32_t> low, std::span<const std::uint32_t> high) {
    constexpr std::size_t kSecond = kIsMirrored ? 2 : 1, kThird = 3 - kSecond;
    std::uint32_t* out = out_;
    const std::uint32_t first = first_;
    for (std::size_t i = 0; i + 1 < low.size(); ++i, out += 6) {
      const std::uint32_t a = first + low[i], c = first + high[i + 1];
      out[0] = a;
      out[kSecond] = first + low[i + 1];
      out[kThird] = c;
      out[3] = a;
      out[3 + kSecond] = c;
      out[3 + kThird] = first + high[i];
    }
    out_ = out;
  }

  const Kernels& kernels_;
  std::uint32_t first_;
  std::uint32_t* out_;
  bool is_mirrored_ = false;
};

/// Between an outer side, from the corner on, and the first line of the grid, whose first vertex is one step away from
/// the corner. `is_wedge`: that line ends in the corner too, as all lines to the apex of a triangle do.
using Strip = void (*)(std::span<const std::uint32_t> outer, std::span<const std::uint32_t> inner, bool is_wedge,
                       TriangleWriter& writer);

/// Section 5.1: Q tells which of the two next segments has its middle nearer. Walks towards the corner.
void BresenhamStrip(std::span<const std::uint32_t> outer, std::span<const std::uint32_t> inner, bool is_wedge,
                    TriangleWriter& writer) {
  std::size_t o = outer.size() - 1, i = inner.size() - 1;
  const auto outer_segments = static_cast<std::int64_t>(o), inner_segments = static_cast<std::int64_t>(inner.size());
  std::int64_t q = inner_segments - outer_segments;
  while (o > 0 || i > 0) {
    // A wedge's apex must come last: it lies in line with the inner vertices.
    const bool waits = is_wedge && o == 1;
    if (o == 0 || (i > 0 && (q > 0 || waits))) {
      writer.Add(outer[o], inner[i], inner[i - 1]);
      q -= 2 * outer_segments;
      --i;
    } else {
      // A triangle's apex, seen as a side, is one vertex twice.
      if (outer[o - 1] != outer[o]) writer.Add(outer[o - 1], outer[o], inner[i]);
      q += 2 * inner_segments;
      --o;
    }
  }
}

/// One to one from the corner; what either has more meets in the other's last vertex, its middle. So edges come and go
/// only with one of their ends (section 5.2), which Bresenham's strips don't keep.
void FanStrip(std::span<const std::uint32_t> outer, std::span<const std::uint32_t> inner, bool /*is_wedge*/,
              TriangleWriter& writer) {
  writer.Add(outer[0], outer[1], inner[0]);
  std::size_t o = 1, i = 0;
  for (; o + 1 < outer.size() && i + 1 < inner.size(); ++o, ++i) {
    writer.Add(outer[o], inner[i + 1], inner[i]);
    writer.Add(outer[o], outer[o + 1], inner[i + 1]);
  }
  for (; o + 1 < outer.size(); ++o) writer.Add(outer[o], outer[o + 1], inner.back());
  for (; i + 1 < inner.size(); ++i) writer.Add(outer.back(), inner[i + 1], inner[i]);
}

/// One piece: `across` lines away from `outer_v`, `along` lines away from `outer_u`. fill_line(j, line) writes the
/// vertices of line j (from 1) at 1 to `across` steps from outer_v.
template <class FillLine>
void WritePiece(std::span<const std::uint32_t> outer_u, std::span<const std::uint32_t> outer_v, std::uint32_t across,
                std::uint32_t along, Strip strip, bool is_mirrored, const FillLine& fill_line, TriangleWriter& writer) {
  Line lines[2], first_column;
  writer.SetMirrored(is_mirrored);
  for (std::uint32_t j = 1; j <= along; ++j) {
    Line& line = lines[j % 2];
    fill_line(j, line);
    first_column[j - 1] = line[0];
    const auto vertices = std::span(line).first(across);
    const auto before = std::span(lines[(j + 1) % 2]).first(across);
    if (j == 1) {
      strip(outer_u, vertices, false, writer);
    } else if (j == 2 || j == along || across < 3) {
      writer.AddCells(before, vertices);
    } else {
      // Only the last line, and the last vertex of each, may be numbered another way than row by row.
      writer.AddShifted(across - 1, across - 2, line[0] - before[0]);
      writer.AddCells(before.last(2), vertices.last(2));
    }
  }
  writer.SetMirrored(!is_mirrored);
  const bool is_wedge = outer_u.front() == outer_u.back();
  strip(outer_v, std::span(first_column).first(along), is_wedge, writer);
}

/// The four sides as the lines of a grid see them: low and high u sides along u, low and high v sides along v.
struct GridSides {
  std::array<DirectedSide, 2> u, v;
};

/// Which of two opposite sides has fewer segments; the high one where both have as many.
std::uint32_t Reduced(const std::array<DirectedSide, 2>& sides) {
  return sides[0].side->segments() < sides[1].side->segments() ? 0 : 1;
}

DirectedSide From(const DirectedSide& side, bool from_end) { return {side.side, side.is_reversed != from_end}; }

void WriteIntegerGrid(const PatchLayout& layout, const GridSides& sides, TriangleWriter& writer) {
  const std::uint32_t across = layout.columns.segments(), along = layout.rows.segments();
  const std::uint32_t reduced_u = Reduced(sides.u), reduced_v = Reduced(sides.v);
  const bool from_right = reduced_v == 1, from_top = reduced_u == 1;
  const DirectedSide full_u = From(sides.u[1 - reduced_u], from_right), full_v = From(sides.v[1 - reduced_v], from_top);
  const auto fill_line = [&](std::uint32_t j, Line& line) {
    const std::uint32_t row = from_top ? along - j : j;
    for (std::uint32_t i = 1; i < across; ++i) {
      const std::uint32_t column = from_right ? across - i : i;
      line[i - 1] = j == along ? full_u.Vertex(i) : layout.interior + (row - 1) * (across - 1) + column - 1;
    }
    line[across - 1] = full_v.Vertex(j);
  };
  Line outer_u, outer_v;
  const std::uint32_t u_segments = sides.u[reduced_u].side->segments(),
                      v_segments = sides.v[reduced_v].side->segments();
  From(sides.u[reduced_u], from_right).Fill(u_segments, outer_u);
  From(sides.v[reduced_v], from_top).Fill(v_segments, outer_v);
  WritePiece(std::span(outer_u).first(u_segments + 1), std::span(outer_v).first(v_segments + 1), across, along,
             BresenhamStrip, from_right != from_top, fill_line, writer);
}

void WriteIntegerTriangle(const PatchLayout& layout, TriangleWriter& writer) {
  const Side apex{.spacing = {.per_half = 1}, .first = layout.sides[2].first, .last = layout.sides[2].first};
  const GridSides sides{{DirectedSide{&layout.sides[0], false}, DirectedSide{&apex, false}},
                        {DirectedSide{&layout.sides[2], true}, DirectedSide{&layout.sides[1], false}}};
  WriteIntegerGrid(layout, sides, writer);
}

void WriteFractionalQuad(const PatchLayout& layout, TriangleWriter& writer) {
  const std::uint32_t across = layout.columns.segments(), along = layout.rows.segments();
  Line outer_u, outer_v;
  for (const bool from_top : {false, true}) {
    for (const bool from_right : {false, true}) {
      const Side& u = layout.sides[from_top ? 1 : 0];
      const Side& v = layout.sides[from_right ? 3 : 2];
      DirectedSide{&u, from_right}.Fill(u.spacing.per_half, outer_u);
      DirectedSide{&v, from_top}.Fill(v.spacing.per_half, outer_v);
      const auto fill_line = [&](std::uint32_t j, Line& line) {
        const std::uint32_t row = from_top ? along - j : j;
        const std::uint32_t first = layout.interior + (row - 1) * (across - 1);
        for (std::uint32_t i = 1; i <= across / 2; ++i) line[i - 1] = first + (from_right ? across - i : i) - 1;
      };
      WritePiece(std::span(outer_u).first(u.spacing.per_half + 1), std::span(outer_v).first(v.spacing.per_half + 1),
                 across / 2, along / 2, FanStrip, from_right != from_top, fill_line, writer);
    }
  }
}

void WriteFractionalTriangle(const PatchLayout& layout, TriangleWriter& writer) {
  Line outer_u, outer_v;
  for (std::uint32_t c = 0; c < 3; ++c) {
    const std::uint32_t before = (c + 2) % 3;
    const Side& u = layout.sides[c];
    const Side& v = layout.sides[before];
    const PatchLayout::Spoke &u_end = layout.spokes[c], &v_end = layout.spokes[before];
    const std::uint32_t across = v_end.segments, along = u_end.segments;
    DirectedSide{&u, false}.Fill(u.spacing.per_half, outer_u);
    DirectedSide{&v, true}.Fill(v.spacing.per_half, outer_v);
    const auto fill_line = [&](std::uint32_t j, Line& line) {
      const std::uint32_t first = j == along ? v_end.inner : layout.corner_interiors[c] + (j - 1) * (across - 1);
      for (std::uint32_t i = 1; i < across; ++i) line[i - 1] = first + i - 1;
      line[across - 1] = j == along ? layout.centre : u_end.inner + j - 1;
    };
    WritePiece(std::span(outer_u).first(u.spacing.per_half + 1), std::span(outer_v).first(v.spacing.per_half + 1),
               across, along, FanStrip, false, fill_line, writer);
  }
}

}  // namespace

void WritePattern(const Kernels& kernels, const PatchLayout& layout, std::uint32_t first_vertex,
                  std::uint32_t* indices) {
  TriangleWriter writer(kernels, first_vertex, indices);
  if (layout.domain == PatchDomain::kTriangle) {
    layout.pattern == Pattern::kInteger ? WriteIntegerTriangle(layout, writer)
                                        : WriteFractionalTriangle(layout, writer);
  } else if (layout.pattern == Pattern::kInteger) {
    const auto& [bottom, top, left, right] = layout.sides;
    WriteIntegerGrid(layout,
                     {{DirectedSide{&bottom, false}, DirectedSide{&top, false}},
                      {DirectedSide{&left, false}, DirectedSide{&right, false}}},
                     writer);
  } else {
    WriteFractionalQuad(layout, writer);
  }
}

std::size_t DropCollapsed(const PatchLayout& layout, std::uint32_t* indices, std::size_t count) {
  const auto on_side = [](const Side& side, std::uint32_t vertex) {
    return vertex == side.first || vertex == side.last ||
           (vertex >= side.inner && vertex - side.inner < side.segments() - 1);
  };
  const auto is_dropped = [&](const std::uint32_t* corner) {
    return std::ranges::any_of(layout.sides, [&](const Side& side) {
      return side.is_collapsed() && on_side(side, corner[0]) + on_side(side, corner[1]) + on_side(side, corner[2]) >= 2;
    });
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; i += 3) {
    if (is_dropped(indices + i)) continue;
    std::copy_n(indices + i, 3, indices + kept);
    kept += 3;
  }
  return kept;
}

}  // namespace burin::tessellation
