// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/edges.h"

#include <algorithm>
#include <cstddef>

namespace burin::geometry {
namespace {

/// One side of a triangle, kept in the bucket of its lower welded end.
struct Side {
  std::uint32_t high;    ///< the higher welded end
  std::uint32_t corner;  ///< three times the face plus the corner that it starts from
};

std::uint32_t Next(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

class EdgeBuilder {
 public:
  EdgeBuilder(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> welded)
      : triangles_(triangles), welded_(welded) {}

  void SortSides(std::span<const std::uint8_t> degenerate);
  [[nodiscard]] std::vector<Edge> Match();

 private:
  [[nodiscard]] std::uint32_t Place(std::uint32_t corner) const { return welded_[triangles_[corner]]; }
  [[nodiscard]] bool RunsUp(std::uint32_t corner) const { return Place(corner) < Place(Next(corner)); }
  [[nodiscard]] Edge EdgeOf(std::span<const Side> sides) const;
  template <class Visit>
  void ForEachSide(std::span<const std::uint8_t> degenerate, Visit visit) const;

  std::span<const std::uint32_t> triangles_, welded_;
  std::vector<Side> sides_;           ///< by lower end, then higher end, then corner
  std::vector<std::size_t> buckets_;  ///< where the sides of each lower end begin
};

template <class Visit>
void EdgeBuilder::ForEachSide(std::span<const std::uint8_t> degenerate, Visit visit) const {
  for (std::size_t f = 0; f < triangles_.size() / 3; ++f) {
    if (!degenerate.empty() && degenerate[f] != 0) continue;
    const auto first = static_cast<std::uint32_t>(3 * f);
    const std::uint32_t a = Place(first), b = Place(first + 1), c = Place(first + 2);
    if (a == b || b == c || c == a) continue;
    for (std::uint32_t corner = first; corner < first + 3; ++corner) {
      const auto [low, high] = std::minmax({Place(corner), Place(Next(corner))});
      visit(low, Side{high, corner});
    }
  }
}

void EdgeBuilder::SortSides(std::span<const std::uint8_t> degenerate) {
  buckets_.assign(welded_.size() + 2, 0);
  ForEachSide(degenerate, [&](std::uint32_t low, const Side&) { ++buckets_[low + 2]; });
  for (std::size_t v = 2; v < buckets_.size(); ++v) buckets_[v] += buckets_[v - 1];
  sides_.resize(buckets_.back());
  ForEachSide(degenerate, [&](std::uint32_t low, const Side& side) { sides_[buckets_[low + 1]++] = side; });
  for (std::size_t v = 0; v < welded_.size(); ++v) {
    const auto begin = sides_.begin() + static_cast<std::ptrdiff_t>(buckets_[v]);
    const auto end = sides_.begin() + static_cast<std::ptrdiff_t>(buckets_[v + 1]);
    std::sort(begin, end,
              [](const Side& a, const Side& b) { return a.high != b.high ? a.high < b.high : a.corner < b.corner; });
  }
}

/// `sides`: all sides between two places, in the order of their faces.
Edge EdgeBuilder::EdgeOf(std::span<const Side> sides) const {
  std::uint32_t left = sides[0].corner;
  std::uint32_t right = sides.size() > 1 ? sides[1].corner : left;
  // Of two faces that agree, the left one is the one that runs from the lower welded end to the higher.
  if (RunsUp(right) && !RunsUp(left)) std::swap(left, right);
  Edge edge;
  edge.corners_left = {triangles_[left], triangles_[Next(left)]};
  edge.left = left / 3;
  edge.corners_right = edge.corners_left;
  if (sides.size() < 2) return edge;
  const bool same_way = RunsUp(left) == RunsUp(right);
  edge.corners_right = {triangles_[same_way ? right : Next(right)], triangles_[same_way ? Next(right) : right]};
  edge.right = right / 3;
  edge.is_non_manifold = sides.size() > 2 || same_way || Place(Next(Next(left))) == Place(Next(Next(right)));
  return edge;
}

std::vector<Edge> EdgeBuilder::Match() {
  std::vector<Edge> edges;
  edges.reserve(sides_.size() / 2 + 1);
  for (std::size_t v = 0; v + 2 < buckets_.size(); ++v) {
    for (std::size_t begin = buckets_[v], end = begin; begin < buckets_[v + 1]; begin = end) {
      while (end < buckets_[v + 1] && sides_[end].high == sides_[begin].high) ++end;
      edges.push_back(EdgeOf(std::span(sides_).subspan(begin, end - begin)));
    }
  }
  return edges;
}

}  // namespace

std::vector<Edge> BuildEdges(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> welded,
                             std::span<const std::uint8_t> degenerate) {
  EdgeBuilder builder(triangles, welded);
  builder.SortSides(degenerate);
  return builder.Match();
}

}  // namespace burin::geometry
