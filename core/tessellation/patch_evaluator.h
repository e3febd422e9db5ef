// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/tessellation/bernstein_table.h"
#include "core/tessellation/patch_layout.h"
#include "core/tessellation/reparameterization.h"
#include "core/tessellation/stored_nets.h"
#include "core/tessellation/vertex_writer.h"

namespace burin::tessellation {

/// Evaluates one patch after the other; one evaluator a thread.
class PatchEvaluator {
 public:
  /// `swatch_vertices`: how many vertices are held before they are written; 0: a whole line.
  void Configure(const Kernels& kernels, std::uint32_t swatch_vertices, bool wants_tangents, Surface& surface);

  /// Writes the vertices of patch `index` from `first_vertex` on. Its nets are taken from `stored`, or put there.
  void Evaluate(const geometry::BezierPatches& patches, std::size_t index, const PatchLayout& layout,
                std::uint32_t first_vertex, StoredNets& stored);

 private:
  struct Grid {
    LineVertices columns;
    double column_step = 1.0;
    std::uint32_t first_vertex = 0;
    std::uint32_t column_count = 0;  ///< inside
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
  void RunPiece(const LineVertices& vertices);
  [[nodiscard]] NetLine SideLine(std::size_t channel, const Side& side, std::uint32_t index);
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
  std::array<std::uint8_t, kChannelCount> channels_{};  ///< those that the patch has
  std::uint32_t channel_count_ = 0;
  std::array<Net, kChannelCount> parts_;                                    ///< of triangles, as quads
  std::array<const Net*, kChannelCount> grid_nets_{};                       ///< what Rows evaluates
  std::array<std::array<SteppedCurve, kMaxNetOrder>, kChannelCount> rows_;  ///< a curve a row of control points
  std::array<SteppedCurve, kChannelCount> curves_;
  std::array<Lanes, kMaxNetOrder> side_points_;
  std::array<int, kChannelCount> degrees_{};  ///< of curves_
  std::array<std::array<Lanes, kMaxLine>, kChannelCount> scratch_;
  ChannelValues scratch_values_{};
  std::array<double, kMaxLine> column_parameters_, row_parameters_, side_parameters_;
  BernsteinTable row_weights_;
};

}  // namespace burin::tessellation
