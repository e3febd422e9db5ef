// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin::geometry {

inline constexpr std::uint32_t kNoFace = 0xFFFFFFFFu;

/// An edge of a triangle mesh with the faces on its two sides. The left face runs through the edge from its first end
/// to its second, counterclockwise seen from the front; the right face, unless the edge is non-manifold, the other way.
struct Edge {
  /// Vertex indices (as the triangles have them, not welded) of the two ends, on each face; the order of the ends is
  /// the same on both. At a boundary corners_right repeats corners_left.
  std::array<std::uint32_t, 2> corners_left, corners_right;
  std::uint32_t left = kNoFace;   ///< triangle index, always there
  std::uint32_t right = kNoFace;  ///< triangle index, kNoFace at a boundary
  /// Three faces or more (left and right are the first two), two faces that run through the edge the same way, or two
  /// faces with the same three corners.
  bool is_non_manifold = false;
};

/// The edges between triangles whose corners are at the same places.
/// `triangles`: three vertex indices a triangle. `welded`: one index a vertex, as WeldPositions gives them.
/// `degenerate`: empty or one byte a triangle; nonzero ones take no part, nor do triangles with two equal welded
/// corners. Where such a triangle had a neighbour on its own, that neighbour's edge is a boundary.
/// Order: by the lower welded end, then the higher one, so it does not depend on the order of the triangles.
/// Time O(n), up to sorting at vertices of many edges.
[[nodiscard]] std::vector<Edge> BuildEdges(std::span<const std::uint32_t> triangles,
                                           std::span<const std::uint32_t> welded,
                                           std::span<const std::uint8_t> degenerate = {});

}  // namespace burin::geometry
