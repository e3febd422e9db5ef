// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_tiles.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace burin::overdraw {
namespace {

constexpr int kWidth = 45;  // no multiple of a tile
constexpr int kHeight = 31;
constexpr unsigned kSeed = 20010821;

EdgeRecord Along(float x0, float y0, float x1, float y1) {
  return {{x0, y0, x1, y1}, {0.5f, 0.5f, 0.0f, 0.0f}, {0, 0, 1, 0}};
}

bool Has(const EdgeTiles& tiles, int x, int y, std::uint32_t edge) {
  const glm::uvec2 list = tiles.lists.at(static_cast<std::size_t>(y / kTileHeight * tiles.columns + x / kTileWidth));
  const auto begin = tiles.edges.begin() + list.x;
  return std::find(begin, begin + list.y, edge) != begin + list.y;
}

bool IsInRun(const EdgeTiles& tiles, int x, int y) {
  return std::ranges::any_of(tiles.runs, [&](const TileRun& run) {
    const int column = x / kTileWidth;
    const int row = y / kTileHeight;
    return row >= run.row && row < run.row + kRunRows && column >= run.first && column < run.first + run.count;
  });
}

TEST(EdgeTiles, EveryPixelThatAnEdgeCrossesKnowsIt) {
  std::mt19937 random(kSeed);
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::uniform_real_distribution<float> anywhere(-10.0f, 60.0f);
  std::uniform_real_distribution<float> step(-6.0f, 6.0f);
  for (const float reach : {0.0f, 1.0f}) {
    std::vector<EdgeRecord> records;
    for (int i = 0; i < 300; ++i) {
      const float x = anywhere(random), y = anywhere(random);
      const bool is_long = i % 3 == 0;
      records.push_back(
          Along(x, y, is_long ? anywhere(random) : x + step(random), is_long ? anywhere(random) : y + step(random)));
      if (i % 7 == 0) records.back().segment.w = records.back().segment.y;
      if (i % 11 == 0) records.back().segment.z = records.back().segment.x;
    }
    EdgeTiles tiles;
    BinEdges(records, kWidth, kHeight, reach, tiles);
    for (std::uint32_t i = 0; i < records.size(); ++i) {
      const glm::vec4 s = records[i].segment;
      for (int k = 0; k <= 400; ++k) {
        const float t = static_cast<float>(k) / 400.0f;
        for (const glm::vec2 off :
             {glm::vec2(0, 0), glm::vec2(1, 1), glm::vec2(-1, 1), glm::vec2(1, -1), glm::vec2(-1, -1)}) {
          const int x = static_cast<int>(std::floor(s.x + (s.z - s.x) * t + off.x * reach));
          const int y = static_cast<int>(std::floor(s.y + (s.w - s.y) * t + off.y * reach));
          if (x < 0 || y < 0 || x >= kWidth || y >= kHeight) continue;
          ASSERT_TRUE(Has(tiles, x, y, i)) << i << " at " << x << " " << y << " reach " << reach;
          ASSERT_TRUE(IsInRun(tiles, x, y)) << i << " at " << x << " " << y;
        }
      }
    }
  }
}

TEST(EdgeTiles, ListsAreShortAndInOrder) {
  std::vector<EdgeRecord> records(40, Along(1.0f, 1.0f, 43.0f, 29.0f));
  EdgeTiles tiles;
  BinEdges(records, kWidth, kHeight, 0.0f, tiles);
  int touched = 0;
  for (const glm::uvec2& list : tiles.lists) {
    touched += list.y > 0 ? 1 : 0;
    if (list.y == 0) continue;
    ASSERT_EQ(list.y, 40u);
    for (std::uint32_t i = 0; i < 40; ++i) EXPECT_EQ(tiles.edges[list.x + i], i);
  }
  // A diagonal over 16 rows of tiles crosses 11 columns.
  EXPECT_GE(touched, 15);
  EXPECT_LE(touched, 27);
}

TEST(EdgeTiles, NothingNearThePictureIsNoRun) {
  EdgeTiles tiles;
  BinEdges({}, kWidth, kHeight, 1.0f, tiles);
  EXPECT_TRUE(tiles.runs.empty());
  const std::vector<EdgeRecord> outside = {Along(-9, -9, -2, 40), Along(60, 2, 70, 9), Along(2, -30, 9, -3)};
  BinEdges(outside, kWidth, kHeight, 1.0f, tiles);
  EXPECT_TRUE(tiles.runs.empty());
  EXPECT_TRUE(tiles.edges.empty());
}

TEST(EdgeTiles, RunsDoNotOverlap) {
  const std::vector<EdgeRecord> records = {Along(2, 2, 40, 3), Along(5, 0, 5, 31), Along(30, 0, 31, 31)};
  EdgeTiles tiles;
  BinEdges(records, kWidth, kHeight, 0.0f, tiles);
  for (std::size_t i = 0; i < tiles.runs.size(); ++i) {
    for (std::size_t k = i + 1; k < tiles.runs.size(); ++k) {
      const TileRun& a = tiles.runs[i];
      const TileRun& b = tiles.runs[k];
      EXPECT_TRUE(a.row != b.row || a.first + a.count < b.first || b.first + b.count < a.first);
    }
  }
}

}  // namespace
}  // namespace burin::overdraw
