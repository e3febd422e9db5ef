// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin::overdraw {

/// What an edge of a mesh is, whatever the view (Sander et al., Discontinuity Edge Overdraw, 2001, section 3.2). Where
/// several hold, the first of: boundary, material, crease, seam.
enum class EdgeKind : std::uint8_t {
  kSmooth,    ///< drawn only where it is a silhouette
  kCrease,    ///< sharp: the vertex normals of its faces differ, or the faces meet at more than the crease angle
  kMaterial,  ///< sharp: its faces' materials differ
  kSeam,      ///< sharp: colours, texture coordinates or, between faces of one plane, normals differ
  kBoundary,  ///< one face, or non-manifold: a silhouette in every view (section 5)
};

/// Why an edge is drawn in one view.
enum class EdgeClass : std::uint8_t {
  kSilhouette,  ///< one of its faces looks towards the eye, the other away; EdgeMesh::kinds tells if it is sharp too
  kCrease,
  kMaterial,
  kSeam,
  kBoundary,
};

/// Sharp edges mark a discontinuity of the shading and are drawn in every view that shows one of their faces.
[[nodiscard]] constexpr bool IsSharp(EdgeKind kind) {
  return kind == EdgeKind::kCrease || kind == EdgeKind::kMaterial || kind == EdgeKind::kSeam;
}

}  // namespace burin::overdraw
