// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/overdraw/face_planes.h"
#include "core/overdraw/silhouette_edges.h"

namespace burin::overdraw {

/// A search hierarchy over edges of a mesh that keeps its shape: whole clusters are skipped when the eye lies where all
/// their faces look towards it, or all away from it (Sander et al., Silhouette Clipping, 2000, section 3: anchored
/// cones). Finds exactly the edges that ScanSilhouettes finds, in the same order.
///
/// Leaves are 32 edges with the planes of both their faces, eight of which are tested at once; eight leaves make a
/// node, eight nodes the next, and so on, so children are known by their number and no pointers are kept.
class SilhouetteTree {
 public:
  static constexpr std::size_t kLeafEdges = 32;
  static constexpr std::size_t kChildren = 8;

  /// Puts `edges` into the order of the leaves, so that edges with like planes are together, and builds the tree over
  /// them in O(n log n), in parallel, the same for any number of threads.
  /// `midpoints`: of each of `edges`, object space. None of the faces may be degenerate.
  [[nodiscard]] static SilhouetteTree Build(const FacePlanes& planes, std::span<const glm::vec3> midpoints,
                                            SilhouetteEdges& edges);

  [[nodiscard]] bool empty() const { return edge_count_ == 0; }

  /// Appends to `found` the index in the ordered `edges` of each edge with one front and one back face, ascending.
  /// Returns how many edges it looked at. Any number of threads at once.
  std::size_t Find(const glm::vec4& local_eye, bool uses_avx2, std::vector<std::uint32_t>& found) const;

 private:
  friend class SilhouetteTreeBuilder;

  /// The planes of a leaf's edges; after the last edge, its left plane on both sides, which is never a silhouette.
  struct Leaf {
    float left[4][kLeafEdges];
    float right[4][kLeafEdges];
  };
  /// For each of eight children two cones of eyes, with one axis and angle: from the front anchor along the axis, where
  /// all faces are front; from the back anchor against the axis, where all are back.
  struct Node {
    float axis[3][kChildren];  ///< times SilhouetteCone::Depth(), as is the cosine
    float cosine[kChildren];   ///< of half the opening angle; kNever where there is no such cone
    float front[3][kChildren];
    float back[3][kChildren];
  };

  [[nodiscard]] static std::uint32_t OpenChildren(const Node& node, const glm::vec4& eye, float margin);
  [[nodiscard]] static std::uint32_t OpenChildrenAvx2(const Node& node, const glm::vec4& eye, float margin);
  static void SearchLeaf(const Leaf& leaf, const glm::vec4& eye, std::uint32_t first,
                         std::vector<std::uint32_t>& found);
  static void SearchLeafAvx2(const Leaf& leaf, const glm::vec4& eye, std::uint32_t first,
                             std::vector<std::uint32_t>& found);

  std::size_t edge_count_ = 0;
  float radius_ = 0.0f;
  std::vector<Leaf> leaves_;
  /// levels_[0] holds the cones of the leaves, levels_[k] those of the nodes of levels_[k - 1]; the last has one node.
  std::vector<std::vector<Node>> levels_;
};

}  // namespace burin::overdraw
