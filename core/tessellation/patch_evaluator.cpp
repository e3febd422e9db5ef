// SPDX-License-Identifier: Apache-2.0
// Moreton, sections 3, 4 and 8, with these differences:
//  - Rows start from Bernstein weights, not by stepping a matrix of differences along v: as cheap on a CPU, and a row's
//    accuracy doesn't depend on how many went before.
//  - Sides, in both patterns, are stepped from both of their ends to the middle, and the middle is a sum without a
//    direction. So a side's vertices don't depend on which way a patch runs along it: there is no canonical direction
//    to choose, reversed transitions need no rows of their own, and special vertices are just vertices in memory.
//  - Guard curves carry every attribute, not position and normal alone.
#include "core/tessellation/patch_evaluator.h"

#include <algorithm>

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
  for (std::size_t c = 0; c < kChannelCount; ++c) scratch_values_[c] = scratch_[c].data();
}

template <class Visit>
void PatchEvaluator::ForEachChannel(const Visit& visit) {
  for (std::uint32_t i = 0; i < channel_count_; ++i) visit(std::size_t{channels_[i]});
}

void PatchEvaluator::Evaluate(const geometry::BezierPatches& patches, std::size_t index, const PatchLayout& layout,
                              std::uint32_t first_vertex, StoredNets& stored) {
  const geometry::BezierPatch& patch = patches.patches[index];
  writer_.patches = &patches;
  writer_.patch = &patch;
  first_vertex_ = first_vertex;
  if (!stored.Restore(index, nets_)) {
    nets_.Load(*kernels_, patches, patch, wants_tangents_);
    // Loading is as quick as restoring where nothing is derived.
    if (!patch.normal || wants_tangents_) stored.Store(index, nets_);
  }
  channel_count_ = 0;
  for (std::uint8_t c = 0; c < kChannelCount; ++c) {
    if (nets_.has[c]) channels_[channel_count_++] = c;
  }
  if (patch.domain == PatchDomain::kTriangle && layout.pattern == Pattern::kFractional) {
    ThreeGrids(layout);
  } else {
    WholeGrid(layout);
  }
  // Last, as the rows of a patch may be thrown off by rounding but its sides may not: nothing writes over them.
  for (std::uint32_t s = 0; s < layout.side_count; ++s) GuardCurve(layout.sides[s], s);
}

/// A side's control points. Cross products vanish along a side that is one point. Next to it they shrink with the
/// distance, and the limit of their direction is what the next line of control vectors says.
NetLine PatchEvaluator::SideLine(std::size_t channel, const Side& side, std::uint32_t index) {
  const Net& net = nets_.net[channel];
  if (net.is_quad()) {
    const bool is_limit = static_cast<Channel>(channel) == Channel::kNormal && !writer_.patch->normal &&
                          side.shape != SideShape::kOpen && IsNearlyPoint(*writer_.patches, *writer_.patch, index);
    return QuadLine(net, index, is_limit ? 1 : 0);
  }
  for (int k = 0; k <= net.u_degree; ++k)
    kernels_->copy(&net.value[static_cast<std::size_t>(TrianglePoint(net, index, k))], 1, &side_points_[k]);
  return {side_points_.data(), 1, net.u_degree};
}

void PatchEvaluator::GuardCurve(const Side& side, std::uint32_t index) {
  const CurveParts parts = side.spacing.per_half == 1 ? CurveParts::kEndsAndMiddle : CurveParts::kAll;
  ForEachChannel([&](std::size_t c) {
    const NetLine line = SideLine(c, side, index);
    degrees_[c] = line.degree;
    kernels_->start_curves(line.points, line.stride, 0, 1, line.degree, side.spacing.step, parts, &curves_[c]);
  });
  const bool has_start = side.StartAdjoins(), has_end = side.EndAdjoins();
  const std::uint32_t skipped = has_start ? 0 : 1;
  const std::uint32_t count = side.segments() - skipped + (has_end ? 1 : 0);
  side.spacing.Fill(skipped, count, side_parameters_.data());
  const LineVertices vertices{.from_start = side.spacing.inner_half(),
                              .from_end = side.spacing.inner_half(),
                              .has_middle = side.spacing.has_middle,
                              .has_start = has_start,
                              .has_end = has_end};
  const Lanes corner = curves_[static_cast<std::size_t>(Channel::kPosition)].values[0];
  const auto [from, to] = SideEnds(writer_.patch->domain, index);
  const std::uint32_t first = first_vertex_ + (has_start ? side.first : side.inner);
  RunLine(vertices, {first, count, side_parameters_.data(), from, to});
  if (side.is_collapsed()) {
    // Rounding may have told the vertices of a rational curve apart.
    const double w = writer_.patch->is_rational ? corner[3] : 1.0;
    const glm::vec3 position(glm::dvec3(corner[0] / w, corner[1] / w, corner[2] / w));
    std::ranges::fill(std::span(writer_.surface->positions).subspan(first, count), position);
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
  layout.columns.Fill(1, columns, column_parameters_.data());
  layout.rows.Fill(1, rows, row_parameters_.data());
  // Of the integer pattern only sides must not depend on a direction. A single vertex is in the middle.
  const std::uint32_t half = layout.columns.inner_half();
  const LineVertices whole{.from_start = columns},
      halves{.from_start = half, .from_end = half, .has_middle = layout.columns.has_middle};
  Rows({.columns = layout.pattern == Pattern::kInteger && half > 0 ? whole : halves,
        .column_step = layout.columns.step,
        .first_vertex = first_vertex_ + layout.interior,
        .column_count = columns,
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
          .column_count = across.segments - 1,
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
    const NetLine line = QuadLine(*grid_nets_[c], 3, 0);
    degrees_[c] = line.degree;
    kernels_->start_curves(line.points, line.stride, 0, 1, line.degree, spoke.step, CurveParts::kFromStart,
                           &curves_[c]);
  });
  for (std::uint32_t i = 1; i < spoke.segments; ++i) side_parameters_[i - 1] = i * spoke.step;
  RunLine({.from_start = spoke.segments - 1},
          {first_vertex_ + spoke.inner, spoke.segments - 1, side_parameters_.data(), from, to});
}

void PatchEvaluator::Rows(const Grid& grid) {
  const CurveParts parts = grid.columns.is_one_ended()    ? CurveParts::kFromStart
                           : grid.columns.from_start == 0 ? CurveParts::kEndsAndMiddle
                                                          : CurveParts::kAll;
  std::array<const double*, kChannelCount> weights{};
  ForEachChannel([&](std::size_t c) {
    const Net& net = *grid_nets_[c];
    degrees_[c] = net.u_degree;
    kernels_->start_curves(net.value.data(), 1, net.u_degree + 1, net.v_degree + 1, net.u_degree, grid.column_step,
                           parts, rows_[c].data());
    weights[c] = row_weights_.Weights(*kernels_, net.v_degree, {grid.row_parameters, grid.row_count});
  });
  for (std::uint32_t r = 0; r < grid.row_count; ++r) {
    ForEachChannel([&](std::size_t c) {
      const int order = grid_nets_[c]->v_degree + 1;
      kernels_->combine(rows_[c].data(), weights[c] + r * static_cast<std::uint32_t>(order), order, degrees_[c], parts,
                        &curves_[c]);
    });
    const double t = grid.row_parameters[r];
    RunLine(grid.columns, {grid.first_vertex + r * grid.column_count, grid.column_count, grid.column_parameters,
                           Between(grid.corners[0], grid.corners[2], t), Between(grid.corners[1], grid.corners[3], t)});
  }
}

void PatchEvaluator::RunPiece(const LineVertices& vertices) {
  ForEachChannel([&](std::size_t c) { kernels_->run_curve(curves_[c], degrees_[c], vertices, scratch_[c].data()); });
}

void PatchEvaluator::RunLine(const LineVertices& vertices, const VertexRun& run) {
  if (run.count == 0) return;
  if (run.count > swatch_) return RunSwatches(vertices, run);
  RunPiece(vertices);
  writer_.Write(scratch_values_, run);
}

/// Moreton, section 8.4: the line in pieces of at most `swatch_` vertices. The curves carry on where they stopped.
void PatchEvaluator::RunSwatches(const LineVertices& vertices, const VertexRun& run) {
  const auto piece = [&](std::uint32_t at, std::uint32_t count, const LineVertices& part) {
    RunPiece(part);
    writer_.Write(scratch_values_, {run.first + at, count, run.parameters + at, run.from, run.to});
  };
  std::uint32_t at = 0, last = run.count;
  if (vertices.has_start) piece(at++, 1, {.has_start = true});
  // Before the curve moves on from its end.
  if (vertices.has_end) piece(--last, 1, {.has_end = true});
  for (std::uint32_t left = vertices.from_start; left > 0;) {
    const std::uint32_t count = std::min(swatch_, left);
    piece(at, count, {.from_start = count});
    at += count;
    left -= count;
  }
  if (vertices.has_middle) piece(at, 1, {.has_middle = true});
  for (std::uint32_t left = vertices.from_end; left > 0;) {
    const std::uint32_t count = std::min(swatch_, left);
    last -= count;
    piece(last, count, {.from_end = count});
    left -= count;
  }
}

}  // namespace burin::tessellation
