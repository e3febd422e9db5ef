// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/open_surfaces.h"

#include <numeric>

namespace burin::overdraw {
namespace {

/// Disjoint sets of faces, with path halving.
class FaceSets {
 public:
  explicit FaceSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  [[nodiscard]] std::uint32_t Root(std::uint32_t face) {
    while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
    return face;
  }
  void Join(std::uint32_t a, std::uint32_t b) {
    a = Root(a);
    b = Root(b);
    // The lower index becomes the root: neighbours in a file have near indices, so trees stay flat.
    a < b ? parent_[b] = a : parent_[a] = b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::vector<std::uint8_t> FindOpenSurfaces(std::span<const geometry::Edge> edges, std::span<const EdgeKind> kinds,
                                           std::span<const std::uint8_t> double_sided, std::size_t face_count) {
  FaceSets sets(face_count);
  for (const geometry::Edge& edge : edges) {
    if (edge.right != geometry::kNoFace) sets.Join(edge.left, edge.right);
  }
  std::vector<std::uint8_t> is_open_root(face_count);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (kinds[e] == EdgeKind::kBoundary) is_open_root[sets.Root(edges[e].left)] = 1;
  }
  for (std::size_t f = 0; f < double_sided.size(); ++f) {
    if (double_sided[f] != 0) is_open_root[sets.Root(static_cast<std::uint32_t>(f))] = 1;
  }
  std::vector<std::uint8_t> is_open(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) is_open[e] = is_open_root[sets.Root(edges[e].left)];
  return is_open;
}

}  // namespace burin::overdraw
