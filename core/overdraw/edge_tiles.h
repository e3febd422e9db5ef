// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/overdraw/edge_records.h"

namespace burin::overdraw {

/// Pixels of a tile: what llvmpipe shades at once, so that all of them loop over the same edges.
inline constexpr int kTileWidth = 4;
inline constexpr int kTileHeight = 2;
/// Rows of tiles in a run: what llvmpipe rasterizes at once.
inline constexpr int kRunRows = 2;

/// Tiles next to each other in kRunRows rows, some of them with edges in every column.
struct TileRun {
  int row = 0;    ///< the first, a multiple of kRunRows
  int first = 0;  ///< column
  int count = 0;
};

/// Which edges may touch the pixels of which tiles.
struct EdgeTiles {
  int columns = 0, rows = 0;
  std::vector<glm::uvec2> lists;     ///< one a tile, row by row: its first place in `edges`, and how many
  std::vector<std::uint32_t> edges;  ///< indices of records, ascending within a tile
  std::vector<TileRun> runs;
};

/// `reach`: pixels beyond a segment, in x and y, up to which a pixel's square counts as touched.
void BinEdges(std::span<const EdgeRecord> records, int width, int height, float reach, EdgeTiles& tiles);

}  // namespace burin::overdraw
