// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/overdraw/edge_kind.h"
#include "core/overdraw/edge_mesh.h"
#include "core/overdraw/edge_view.h"

namespace burin::overdraw {

/// How the silhouettes among smooth edges were found.
enum class SilhouetteWay : std::uint8_t { kScan, kTree };

/// One edge to draw.
struct RenderedEdge {
  std::uint32_t edge = 0;  ///< index in EdgeMesh::edges
  EdgeClass cls = EdgeClass::kSilhouette;
  bool is_front_left = false, is_front_right = false;  ///< the face looks towards the eye
  bool is_sorted = false;                              ///< in the part sorted back to front
  /// Share of the right face's shading, after the asymmetric map: 0 left only .. 1 right only. A silhouette takes that
  /// face of the two which is on screen, in front of the other.
  float beta = 0.0f;
  /// Squared world distance of the midpoint from the eye. Orthographic: of the distance along the view, negated where
  /// that is negative.
  float distance2 = 0.0f;
};

/// Counts of Table 1, for one mesh or summed over several.
struct EdgeStatistics {
  std::size_t faces = 0, edges = 0;
  std::size_t sharp = 0;        ///< of all edges
  std::size_t boundaries = 0;   ///< of all edges
  std::size_t silhouettes = 0;  ///< drawn: smooth ones and boundaries
  std::size_t rendered = 0;     ///< drawn: silhouettes and sharp edges with a face on screen
  std::size_t sorted = 0;       ///< of the rendered, those sorted back to front
  std::size_t blended = 0;      ///< of the rendered, those with a share of both faces
  std::size_t searched = 0;     ///< smooth edges that the search is over
  std::size_t visited = 0;      ///< of these, those that it looked at
  std::size_t found = 0;        ///< of these, silhouettes
  SilhouetteWay way = SilhouetteWay::kScan;

  EdgeStatistics& operator+=(const EdgeStatistics& other);
};

struct ExtractOptions {
  std::optional<SilhouetteWay> way{};  ///< empty: the tree if the mesh has one
  bool uses_avx2 = true;               ///< where the processor has it
  bool is_parallel = true;             ///< scans of large meshes use TBB's threads; the result is the same
};

/// The discontinuity edges of one object that can show in a view: `edges` is overwritten. Order: sharp edges path by
/// path, boundaries, silhouettes; if view.sorted, those that can hide others come last, back to front (far to near,
/// equals by index). Deterministic. Sander et al. 2001, section 3.5.
void ExtractEdges(const EdgeMesh& mesh, const EdgeView& view, std::vector<RenderedEdge>& edges,
                  EdgeStatistics& statistics, const ExtractOptions& options = {});

}  // namespace burin::overdraw
