// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/tessellation/patch_layout.h"
#include "core/tessellation/reparameterization.h"
#include "core/tessellation/vertex_writer.h"

namespace burin::tessellation {

/// A curve of one channel, ready to be stepped from both ends: differences from the start, then from the end, then the
/// value in the middle. Lines that are stepped from one end have the first part only.
using SteppedCurve = std::array<Lanes, 2 * kMaxNetOrder + 1>;

/// Evaluates one patch after the other; one evaluator a thread.
class PatchEvaluator {
 public:
  /// `swatch_vertices`: how many vertices are held before they are written; 0: a whole line.
  void Configure(const Kernels& kernels, std::uint32_t swatch_vertices, bool wants_tangents, Surface& surface);

  /// Writes the patch's vertices from `first_vertex` on.
  void Evaluate(const geometry::BezierPatches& patches, const geometry::BezierPatch& patch, const PatchLayout& layout,
                std::uint32_t first_vertex);

 private:
  /// Vertices inside a line, in order: those stepped from its start, one in the middle, those stepped from its end.
  struct LineVertices {
    std::uint32_t from_start = 0, from_end = 0;
    bool has_middle = false;
    [[nodiscard]] std::uint32_t count() const { return from_start + from_end + (has_middle ? 1u : 0u); }
  };
  struct Grid {
    LineVertices columns;
    double column_step = 1.0;
    std::uint32_t first_vertex = 0;
    const double* column_parameters = nullptr;
    std::array<glm::dvec2, 4> corners;  ///< (u, v) at (s, t) = (0, 0), (1, 0), (0, 1), (1, 1)
    std::uint32_t row_count = 0;        ///< inside
    const double* row_parameters = nullptr;
  };

  void GuardCurve(const Side& side, std::uint32_t index);
  void WholeGrid(const PatchLayout& layout);
  void ThreeGrids(const PatchLayout& layout);
  void Spoke(const PatchLayout::Spoke& spoke, const glm::dvec2& from, const glm::dvec2& to);
  void Centre(std::uint32_t vertex, const glm::dvec2& at);
  void StartPart(TrianglePart part);
  void Rows(const Grid& grid);
  void StartRows(Channel channel, const Grid& grid);
  void RunLine(const LineVertices& vertices, const VertexRun& run);
  void RunSwatches(const LineVertices& vertices, const VertexRun& run);
  void StepFromEnd(std::uint32_t count, std::uint32_t slots);
  void StepFromStart(std::uint32_t count);
  void PutMiddle(std::uint32_t slot);
  void WriteSingle(const ChannelValues& values, std::uint32_t vertex, const glm::dvec2& at);
  template <class Visit>
  void ForEachChannel(const Visit& visit);

  static constexpr std::uint32_t kMaxLine = static_cast<std::uint32_t>(kMaxFactor) + 2;

  const Kernels* kernels_ = nullptr;
  std::uint32_t swatch_ = kMaxLine;
  bool wants_tangents_ = false;
  VertexWriter writer_;
  std::uint32_t first_vertex_ = 0;
  PatchNets nets_;
  std::array<Net, kChannelCount> parts_;                                    ///< of triangles, as quads
  std::array<const Net*, kChannelCount> grid_nets_{};                       ///< what Rows evaluates
  std::array<std::array<SteppedCurve, kMaxNetOrder>, kChannelCount> rows_;  ///< a curve a row of control points
  std::array<SteppedCurve, kChannelCount> curves_;
  std::array<int, kChannelCount> degrees_{};  ///< of curves_
  std::array<std::array<Lanes, kMaxLine>, kChannelCount> scratch_;
  std::array<double, kMaxLine> column_parameters_, row_parameters_, side_parameters_;
};

}  // namespace burin::tessellation
