// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "core/gbuffer/attribute_renderer.h"
#include "core/gbuffer/gpu_blocks.h"
#include "core/scene/item_geometry.h"

namespace burin::gbuffer {

/// Samples lie in the table that they are shaded into by blocks of 4 x 4 texels, this many blocks in a row, so that no
/// part of what a rasterizer works on at once is wasted.
inline constexpr std::uint32_t kSampleBlock = 16;
inline constexpr std::uint32_t kBlocksInRow = 256;

/// Which places of the table one item's samples take: whole blocks.
struct SampleRange {
  std::uint32_t item = 0;
  std::uint32_t first_block = 0;
  std::uint32_t blocks = 0;
};

/// Where every edge's samples go: those of one item in a row, items in ascending order.
struct SamplePlan {
  std::vector<std::uint32_t> first;  ///< one an edge: the place of its first point
  std::vector<SampleRange> ranges;
  [[nodiscard]] std::uint32_t blocks() const {
    return ranges.empty() ? 0 : ranges.back().first_block + ranges.back().blocks;
  }
};

void PlanSamples(std::span<const FaceEdge> edges, SamplePlan& plan);

/// How the picture is looked at, for what changes from pixel to pixel.
struct SampleView {
  glm::mat4 clip_from_world{1.0f};
  int width = 0, height = 0;
};

/// Writes the points of one edge of `geometry` to `samples`: edge.points of them.
void SampleEdge(const FaceEdge& edge, const scene::ItemGeometry& geometry, const DrawBlock& draw,
                const SampleView& view, FaceSample* samples);

/// GLSL expression: the place of a fragment.
[[nodiscard]] std::string_view FaceSampleIndex();

}  // namespace burin::gbuffer
