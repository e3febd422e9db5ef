// SPDX-License-Identifier: Apache-2.0
// Consistent orientation of sharp edges: Sander et al. 2001, section 3.3 and figure 4. The paper leaves ties open
// (symmetric models have many): they are broken by position, then by index, so that pictures are deterministic.
#include "core/overdraw/sharp_paths.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

namespace burin::overdraw {
namespace {

/// The paper's g1 and g2, two orthogonal vectors that no common model is aligned with.
constexpr glm::dvec3 kFarthestAlong(2, 5, 1);
constexpr glm::dvec3 kRunsAlong(2, 1, -9);
constexpr std::uint32_t kNone = 0xFFFFFFFFu;

bool LexicographicallyLess(const glm::dvec3& a, const glm::dvec3& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

/// The same edge seen from its other side: still, its left face runs through it from its first end to its second.
void Turn(geometry::Edge& edge) {
  std::swap(edge.left, edge.right);
  std::swap(edge.corners_left, edge.corners_right);
  std::swap(edge.corners_left[0], edge.corners_left[1]);
  std::swap(edge.corners_right[0], edge.corners_right[1]);
}

class PathBuilder {
 public:
  PathBuilder(std::span<const EdgeKind> kinds, std::span<const glm::vec3> positions,
              std::span<const std::uint32_t> welded, std::span<geometry::Edge> edges);
  [[nodiscard]] SharpPaths Build();

 private:
  [[nodiscard]] std::uint32_t End(std::uint32_t edge, std::size_t end) const {
    return welded_[edges_[edge].corners_left[end]];
  }
  [[nodiscard]] std::uint32_t Beyond(std::uint32_t edge, std::size_t end) const;
  void Walk(std::uint32_t edge, std::size_t end, std::vector<std::uint32_t>& path);
  void Chain(std::uint32_t edge, std::vector<std::uint32_t>& path);
  void Orient(std::vector<std::uint32_t>& path);
  [[nodiscard]] std::size_t Representative(const std::vector<std::uint32_t>& path) const;
  [[nodiscard]] glm::dvec3 Position(std::uint32_t edge, std::size_t end) const {
    return glm::dvec3(positions_[End(edge, end)]);
  }

  std::span<const EdgeKind> kinds_;
  std::span<const glm::vec3> positions_;
  std::span<const std::uint32_t> welded_;
  std::span<geometry::Edge> edges_;
  /// At each welded vertex how many sharp edges end, and the exclusive or of their indices: of two, either is found
  /// from the other.
  std::vector<std::uint32_t> count_, mixed_;
  std::vector<bool> is_done_;
};

PathBuilder::PathBuilder(std::span<const EdgeKind> kinds, std::span<const glm::vec3> positions,
                         std::span<const std::uint32_t> welded, std::span<geometry::Edge> edges)
    : kinds_(kinds),
      positions_(positions),
      welded_(welded),
      edges_(edges),
      count_(positions.size()),
      mixed_(positions.size()),
      is_done_(edges.size()) {
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (!IsSharp(kinds[e])) continue;
    for (std::size_t end = 0; end < 2; ++end) {
      ++count_[End(e, end)];
      mixed_[End(e, end)] ^= e;
    }
  }
}

/// The edge that follows at `end`, where no third sharp edge ends; else kNone.
std::uint32_t PathBuilder::Beyond(std::uint32_t edge, std::size_t end) const {
  const std::uint32_t vertex = End(edge, end);
  return count_[vertex] == 2 ? mixed_[vertex] ^ edge : kNone;
}

/// Appends the edges beyond `end` of `edge`, up to the path's end or round to where it began, each turned so that it
/// runs on the way of the walk.
void PathBuilder::Walk(std::uint32_t edge, std::size_t end, std::vector<std::uint32_t>& path) {
  for (std::uint32_t next = Beyond(edge, end); next != kNone && !is_done_[next]; next = Beyond(edge, end)) {
    // Walking on from an edge's second end, the next must begin there; from its first end, it must end there.
    if (End(next, 1 - end) != End(edge, end)) Turn(edges_[next]);
    is_done_[next] = true;
    path.push_back(next);
    edge = next;
  }
}

void PathBuilder::Chain(std::uint32_t edge, std::vector<std::uint32_t>& path) {
  is_done_[edge] = true;
  Walk(edge, 0, path);
  std::ranges::reverse(path);
  path.push_back(edge);
  Walk(edge, 1, path);
}

std::size_t PathBuilder::Representative(const std::vector<std::uint32_t>& path) const {
  std::size_t best = 0;
  double best_along = 0.0;
  glm::dvec3 best_middle(0);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const glm::dvec3 middle = 0.5 * (Position(path[i], 0) + Position(path[i], 1));
    const double along = glm::dot(middle, kFarthestAlong);
    const bool is_better = i == 0 || along > best_along ||
                           (along == best_along && (LexicographicallyLess(best_middle, middle) ||
                                                    (middle == best_middle && path[i] < path[best])));
    if (!is_better) continue;
    best = i;
    best_along = along;
    best_middle = middle;
  }
  return best;
}

void PathBuilder::Orient(std::vector<std::uint32_t>& path) {
  const std::uint32_t edge = path[Representative(path)];
  const glm::dvec3 from = Position(edge, 0), to = Position(edge, 1);
  const double along = glm::dot(to - from, kRunsAlong);
  if (along > 0.0 || (along == 0.0 && LexicographicallyLess(from, to))) return;
  for (const std::uint32_t e : path) Turn(edges_[e]);
  std::ranges::reverse(path);
}

SharpPaths PathBuilder::Build() {
  SharpPaths paths;
  std::vector<std::uint32_t> path;
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    if (!IsSharp(kinds_[e]) || is_done_[e]) continue;
    path.clear();
    Chain(e, path);
    Orient(path);
    paths.begins.push_back(static_cast<std::uint32_t>(paths.edges.size()));
    paths.edges.insert(paths.edges.end(), path.begin(), path.end());
  }
  if (!paths.edges.empty()) paths.begins.push_back(static_cast<std::uint32_t>(paths.edges.size()));
  return paths;
}

}  // namespace

SharpPaths OrientSharpPaths(std::span<const EdgeKind> kinds, std::span<const glm::vec3> positions,
                            std::span<const std::uint32_t> welded, std::span<geometry::Edge> edges) {
  return PathBuilder(kinds, positions, welded, edges).Build();
}

}  // namespace burin::overdraw
