// SPDX-License-Identifier: Apache-2.0
// Moreton, sections 3, 4 and 8, with these differences:
//  - Rows start from Bernstein weights, not by stepping a matrix of differences along v: as cheap on a CPU, and a row's
//    accuracy doesn't depend on how many went before.
//  - Every curve is stepped from both of its ends to the middle, in both patterns, and the middle is a sum without a
//    direction. So a side's vertices don't depend on which way a patch runs along it: there is no canonical direction
//    to choose, reversed transitions need no rows of their own, and special vertices are just vertices in memory.
//  - Guard curves carry every attribute, not position and normal alone.
#include "core/tessellation/patch_evaluator.h"

#include <algorithm>

#include "core/tessellation/differences.h"

namespace burin::tessellation {
namespace {

using geometry::PatchDomain;

glm::dvec2 Between(const glm::dvec2& a, const glm::dvec2& b, double t) { return a + t * (b - a); }

constexpr std::array<glm::dvec2, 4> kQuadCorners{glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1),
                                                 glm::dvec2(1, 1)};

/// (u, v) at both ends of a side.
std::array<glm::dvec2, 2> SideEnds(PatchDomain domain, std::uint32_t side) {
  const auto& c = kQuadCorners;
  if (domain == PatchDomain::kTriangle) return {c[side], c[(side + 1) % 3]};
  constexpr std::array<std::array<std::size_t, 2>, 4> kEnds{{{0, 1}, {2, 3}, {0, 2}, {1, 3}}};
  return {c[kEnds[side][0]], c[kEnds[side][1]]};
}

}  // namespace

void PatchEvaluator::Configure(const Kernels& kernels, std::uint32_t swatch_vertices, bool wants_tangents,
                               Surface& surface) {
  kernels_ = &kernels;
  swatch_ = swatch_vertices == 0 ? kMaxLine : std::min(swatch_vertices, kMaxLine);
  wants_tangents_ = wants_tangents;
  writer_.kernels = &kernels;
  writer_.surface = &surface;
  writer_.nets = &nets_;
}

template <class Visit>
void PatchEvaluator::ForEachChannel(const Visit& visit) {
  for (std::size_t c = 0; c < kChannelCount; ++c) {
    if (nets_.has[c]) visit(c);
  }
}

void PatchEvaluator::Evaluate(const geometry::BezierPatches& patches, const geometry::BezierPatch& patch,
                              const PatchLayout& layout, std::uint32_t first_vertex) {
  writer_.patches = &patches;
  writer_.patch = &patch;
  first_vertex_ = first_vertex;
  nets_.Load(patches, patch, wants_tangents_);
  if (patch.domain == PatchDomain::kTriangle && layout.pattern == Pattern::kFractional) {
    ThreeGrids(layout);
  } else {
    WholeGrid(layout);
  }
  // Last, as the rows of a patch may be thrown off by rounding but its sides may not: nothing writes over them.
  for (std::uint32_t s = 0; s < layout.side_count; ++s) GuardCurve(layout.sides[s], s);
}

void PatchEvaluator::GuardCurve(const Side& side, std::uint32_t index) {
  std::array<Lanes, kMaxNetOrder> points;
  ChannelValues start{}, end{};
  std::array<std::array<Lanes, 2>, kChannelCount> ends;
  ForEachChannel([&](std::size_t c) {
    const int degree = degrees_[c] = SideCurve(nets_.net[c], index, points.data());
    ends[c] = {points[0], points[static_cast<std::size_t>(degree)]};
    start[c] = &ends[c][0];
    end[c] = &ends[c][1];
    StartDifferences(points.data(), 1, degree, side.spacing.step, curves_[c].data());
    StartDifferences(points.data() + degree, -1, degree, side.spacing.step, curves_[c].data() + degree + 1);
    curves_[c][static_cast<std::size_t>(2 * degree + 2)] = MiddleOf(points.data(), 1, degree);
  });
  const auto [from, to] = SideEnds(writer_.patch->domain, index);
  WriteSingle(start, side.first, from);
  WriteSingle(end, side.last, to);
  const std::uint32_t inner = side.segments() - 1;
  for (std::uint32_t i = 0; i < inner; ++i) side_parameters_[i] = side.spacing.Parameter(i + 1);
  const LineVertices vertices{side.spacing.inner_half(), side.spacing.inner_half(), side.spacing.has_middle};
  RunLine(vertices, {first_vertex_ + side.inner, inner, side_parameters_.data(), from, to});
  if (side.is_collapsed) {
    auto& positions = writer_.surface->positions;
    std::fill_n(positions.begin() + first_vertex_ + side.inner, inner, positions[first_vertex_ + side.first]);
  }
}

void PatchEvaluator::WriteSingle(const ChannelValues& values, std::uint32_t vertex, const glm::dvec2& at) {
  const double parameter = 0.0;
  writer_.Write(values, {first_vertex_ + vertex, 1, &parameter, at, at});
}

void PatchEvaluator::StartPart(TrianglePart part) {
  ForEachChannel([&](std::size_t c) {
    Reparameterize(nets_.net[c], part, parts_[c]);
    grid_nets_[c] = &parts_[c];
  });
}

void PatchEvaluator::WholeGrid(const PatchLayout& layout) {
  if (layout.columns.segments() < 2 || layout.rows.segments() < 2) return;
  const bool is_quad = layout.domain == PatchDomain::kQuad;
  if (is_quad) {
    ForEachChannel([&](std::size_t c) { grid_nets_[c] = &nets_.net[c]; });
  } else {
    StartPart(TrianglePart::kWhole);
  }
  const std::uint32_t columns = layout.columns.segments() - 1, rows = layout.rows.segments() - 1;
  for (std::uint32_t i = 0; i < columns; ++i) column_parameters_[i] = layout.columns.Parameter(i + 1);
  for (std::uint32_t j = 0; j < rows; ++j) row_parameters_[j] = layout.rows.Parameter(j + 1);
  const std::uint32_t half = layout.columns.inner_half();
  Rows({.columns = {half, half, layout.columns.has_middle},
        .column_step = layout.columns.step,
        .first_vertex = first_vertex_ + layout.interior,
        .column_parameters = column_parameters_.data(),
        .corners = is_quad ? kQuadCorners : PartCorners(TrianglePart::kWhole),
        .row_count = rows,
        .row_parameters = row_parameters_.data()});
}

void PatchEvaluator::ThreeGrids(const PatchLayout& layout) {
  for (std::uint32_t corner = 0; corner < 3; ++corner) {
    const auto part = static_cast<TrianglePart>(corner);
    const PatchLayout::Spoke &across = layout.spokes[(corner + 2) % 3], &along = layout.spokes[corner];
    if (corner > 0 && across.segments == 1 && along.segments == 1) continue;
    StartPart(part);
    const auto corners = PartCorners(part);
    if (corner == 0) Centre(layout.centre, corners[3]);
    Spoke(along, corners[1], corners[3]);
    if (across.segments == 1 || along.segments == 1) continue;
    for (std::uint32_t i = 1; i < across.segments; ++i) column_parameters_[i - 1] = i * across.step;
    for (std::uint32_t j = 1; j < along.segments; ++j) row_parameters_[j - 1] = j * along.step;
    Rows({.columns = {.from_start = across.segments - 1},
          .column_step = across.step,
          .first_vertex = first_vertex_ + layout.corner_interiors[corner],
          .column_parameters = column_parameters_.data(),
          .corners = corners,
          .row_count = along.segments - 1,
          .row_parameters = row_parameters_.data()});
  }
}

void PatchEvaluator::Centre(std::uint32_t vertex, const glm::dvec2& at) {
  ChannelValues values{};
  ForEachChannel(
      [&](std::size_t c) { values[c] = &grid_nets_[c]->At(grid_nets_[c]->u_degree, grid_nets_[c]->v_degree); });
  WriteSingle(values, vertex, at);
}

/// The side s = 1 of a triangle's part, without its ends.
void PatchEvaluator::Spoke(const PatchLayout::Spoke& spoke, const glm::dvec2& from, const glm::dvec2& to) {
  ForEachChannel([&](std::size_t c) {
    const Net& net = *grid_nets_[c];
    degrees_[c] = net.v_degree;
    StartDifferences(&net.At(net.u_degree, 0), net.u_degree + 1, net.v_degree, spoke.step, curves_[c].data());
  });
  for (std::uint32_t i = 1; i < spoke.segments; ++i) side_parameters_[i - 1] = i * spoke.step;
  RunLine({.from_start = spoke.segments - 1},
          {first_vertex_ + spoke.inner, spoke.segments - 1, side_parameters_.data(), from, to});
}

void PatchEvaluator::StartRows(Channel channel, const Grid& grid) {
  const Net& net = *grid_nets_[static_cast<std::size_t>(channel)];
  auto& rows = rows_[static_cast<std::size_t>(channel)];
  const int degree = net.u_degree;
  for (int j = 0; j <= net.v_degree; ++j) {
    SteppedCurve& curve = rows[static_cast<std::size_t>(j)];
    const Lanes* const points = &net.At(0, j);
    StartDifferences(points, 1, degree, grid.column_step, curve.data());
    if (grid.columns.from_end == 0 && !grid.columns.has_middle) continue;
    StartDifferences(points + degree, -1, degree, grid.column_step, curve.data() + degree + 1);
    curve[static_cast<std::size_t>(2 * degree + 2)] = MiddleOf(points, 1, degree);
  }
}

void PatchEvaluator::Rows(const Grid& grid) {
  const bool is_one_ended = grid.columns.from_end == 0 && !grid.columns.has_middle;
  ForEachChannel([&](std::size_t c) {
    StartRows(static_cast<Channel>(c), grid);
    degrees_[c] = grid_nets_[c]->u_degree;
  });
  const std::uint32_t columns = grid.columns.count();
  std::array<double, kMaxNetOrder> weights;
  for (std::uint32_t r = 0; r < grid.row_count; ++r) {
    const double t = grid.row_parameters[r];
    ForEachChannel([&](std::size_t c) {
      const int v_degree = grid_nets_[c]->v_degree, width = degrees_[c] + 1;
      BernsteinWeights(v_degree, t, weights.data());
      kernels_->combine(rows_[c][0].data(), static_cast<int>(sizeof(SteppedCurve) / sizeof(Lanes)), weights.data(),
                        v_degree + 1, is_one_ended ? width : 2 * width + 1, curves_[c].data());
    });
    RunLine(grid.columns, {grid.first_vertex + r * columns, columns, grid.column_parameters,
                           Between(grid.corners[0], grid.corners[2], t), Between(grid.corners[1], grid.corners[3], t)});
  }
}

void PatchEvaluator::StepFromStart(std::uint32_t count) {
  ForEachChannel([&](std::size_t c) { kernels_->step(curves_[c].data(), degrees_[c], count, scratch_[c].data(), 1); });
}

/// Into the last of `slots` slots first.
void PatchEvaluator::StepFromEnd(std::uint32_t count, std::uint32_t slots) {
  ForEachChannel([&](std::size_t c) {
    kernels_->step(curves_[c].data() + degrees_[c] + 1, degrees_[c], count, scratch_[c].data() + slots - 1, -1);
  });
}

void PatchEvaluator::PutMiddle(std::uint32_t slot) {
  ForEachChannel([&](std::size_t c) { scratch_[c][slot] = curves_[c][static_cast<std::size_t>(2 * degrees_[c] + 2)]; });
}

void PatchEvaluator::RunLine(const LineVertices& vertices, const VertexRun& run) {
  if (run.count == 0) return;
  if (run.count > swatch_) return RunSwatches(vertices, run);
  ChannelValues values{};
  ForEachChannel([&](std::size_t c) { values[c] = scratch_[c].data(); });
  if (vertices.from_start > 0) StepFromStart(vertices.from_start);
  if (vertices.has_middle) PutMiddle(vertices.from_start);
  if (vertices.from_end > 0) StepFromEnd(vertices.from_end, run.count);
  writer_.Write(values, run);
}

/// Moreton, section 8.4: the line in pieces of at most `swatch_` vertices. The curves carry on where they stopped.
void PatchEvaluator::RunSwatches(const LineVertices& vertices, const VertexRun& run) {
  ChannelValues values{};
  ForEachChannel([&](std::size_t c) { values[c] = scratch_[c].data(); });
  const auto piece = [&](std::uint32_t at, std::uint32_t count) {
    writer_.Write(values, {run.first + at, count, run.parameters + at, run.from, run.to});
  };
  for (std::uint32_t done = 0; done < vertices.from_start; done += swatch_) {
    const std::uint32_t count = std::min(swatch_, vertices.from_start - done);
    StepFromStart(count);
    piece(done, count);
  }
  if (vertices.has_middle) {
    PutMiddle(0);
    piece(vertices.from_start, 1);
  }
  for (std::uint32_t done = 0; done < vertices.from_end; done += swatch_) {
    const std::uint32_t count = std::min(swatch_, vertices.from_end - done);
    StepFromEnd(count, count);
    piece(run.count - done - count, count);
  }
}

}  // namespace burin::tessellation
