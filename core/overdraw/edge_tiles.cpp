// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_tiles.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace burin::overdraw {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr float kRounding = 0.01f;  // pixels

struct Touch {
  std::uint32_t tile = 0;
  std::uint32_t edge = 0;
};

int TileOf(float pixel, int side, int count) {
  return std::clamp(static_cast<int>(std::floor(pixel / static_cast<float>(side))), 0, count - 1);
}

/// Calls `touch` with the first and the last column of each row of tiles that the segment, grown by `reach`, meets.
template <class Touched>
void Walk(const glm::vec4& s, int width, int height, float reach, const EdgeTiles& tiles, const Touched& touch) {
  const auto [top, bottom] = std::minmax(s.y, s.w);
  const auto [left, right] = std::minmax(s.x, s.z);
  if (bottom < -reach || top > static_cast<float>(height) + reach) return;
  if (right < -reach || left > static_cast<float>(width) + reach) return;
  const int last_row = TileOf(bottom + reach, kTileHeight, tiles.rows);
  for (int row = TileOf(top - reach, kTileHeight, tiles.rows); row <= last_row; ++row) {
    // The part of the segment in this row.
    float low = left;
    float high = right;
    if (bottom - top > kRounding) {
      const float slope = (s.z - s.x) / (s.w - s.y);
      const float first = std::clamp(static_cast<float>(row * kTileHeight) - reach, top, bottom);
      const float last = std::clamp(static_cast<float>((row + 1) * kTileHeight) + reach, top, bottom);
      const float x0 = s.x + (first - s.y) * slope;
      const float x1 = s.x + (last - s.y) * slope;
      low = std::clamp(std::min(x0, x1), left, right);
      high = std::clamp(std::max(x0, x1), left, right);
    }
    if (high < -reach || low > static_cast<float>(width) + reach) continue;
    touch(row, TileOf(low - reach, kTileWidth, tiles.columns), TileOf(high + reach, kTileWidth, tiles.columns));
  }
}

void FindRuns(EdgeTiles& tiles) {
  tiles.runs.clear();
  const auto has_edges = [&](int first_row, int column) {
    for (int row = first_row; row < std::min(first_row + kRunRows, tiles.rows); ++row) {
      if (tiles
              .lists[static_cast<std::size_t>(row) * static_cast<std::size_t>(tiles.columns) +
                     static_cast<std::size_t>(column)]
              .y > 0) {
        return true;
      }
    }
    return false;
  };
  for (int row = 0; row < tiles.rows; row += kRunRows) {
    for (int column = 0; column < tiles.columns; ++column) {
      if (!has_edges(row, column)) continue;
      const int first = column;
      while (column < tiles.columns && has_edges(row, column)) ++column;
      tiles.runs.push_back({row, first, column - first});
    }
  }
}

}  // namespace

void BinEdges(std::span<const EdgeRecord> records, int width, int height, float reach, EdgeTiles& tiles) {
  tiles.columns = (width + kTileWidth - 1) / kTileWidth;
  tiles.rows = (height + kTileHeight - 1) / kTileHeight;
  tiles.lists.assign(static_cast<std::size_t>(tiles.columns) * static_cast<std::size_t>(tiles.rows), glm::uvec2(0));
  const std::size_t chunks = (records.size() + kGrain - 1) / kGrain;
  std::vector<std::vector<Touch>> touches(chunks);
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t chunk) {
    const std::size_t end = std::min(records.size(), (chunk + 1) * kGrain);
    for (std::size_t i = chunk * kGrain; i < end; ++i) {
      Walk(records[i].segment, width, height, reach + kRounding, tiles, [&](int row, int first, int last) {
        for (int column = first; column <= last; ++column) {
          touches[chunk].push_back(
              {static_cast<std::uint32_t>(row * tiles.columns + column), static_cast<std::uint32_t>(i)});
        }
      });
    }
  });
  for (const std::vector<Touch>& some : touches) {
    for (const Touch& touch : some) ++tiles.lists[touch.tile].y;
  }
  std::uint32_t total = 0;
  for (glm::uvec2& list : tiles.lists) {
    list.x = total;
    total += list.y;
    list.y = 0;
  }
  tiles.edges.resize(total);
  for (const std::vector<Touch>& some : touches) {
    for (const Touch& touch : some) {
      glm::uvec2& list = tiles.lists[touch.tile];
      tiles.edges[list.x + list.y++] = touch.edge;
    }
  }
  FindRuns(tiles);
}

}  // namespace burin::overdraw
