// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/geometry/edges.h"
#include "core/overdraw/edge_kind.h"
#include "core/overdraw/face_planes.h"
#include "core/overdraw/mesh_input.h"
#include "core/overdraw/silhouette_edges.h"
#include "core/overdraw/silhouette_tree.h"

namespace burin::overdraw {

/// Below this many edges in the search a scan is over in 10 microseconds and a tree saves nothing worth its building.
/// A tree pays for its building after some 300 views; for fewer, set EdgeMeshOptions::least_tree_edges to kNoTree.
inline constexpr std::size_t kLeastTreeEdges = 6'000;
inline constexpr std::size_t kNoTree = static_cast<std::size_t>(-1);

struct EdgeMeshOptions {
  float crease_angle_deg = 60.0f;  ///< faces that meet at more are a crease even where the shading is smooth; 0..180
  /// Single-sided faces show from behind, as in the paper's pictures. Off: they are not on screen then (glTF's
  /// culling), so an edge all of whose faces are seen from behind is drawn only if one of them is double-sided.
  bool shows_back_faces = false;
  /// Silhouettes among the concave edges of closed surfaces are kept. They are hidden, but close the outline: where it
  /// folds back and forth, they are the way back.
  bool keeps_concave = false;
  std::size_t least_tree_edges = kLeastTreeEdges;  ///< smaller searches, and moving meshes, build no tree
};

/// A mesh's edges, prepared once: what they are, which way sharp ones run, and how to find silhouettes.
/// Reading it, ExtractEdges included, is safe on any number of threads; UpdateDeformed is not.
struct EdgeMesh {
  std::string name;
  std::vector<glm::vec3> positions;        ///< object space, one a vertex; the last that UpdateDeformed was given
  std::vector<std::uint32_t> triangles;    ///< as in the input: degenerate ones too
  std::vector<std::uint8_t> double_sided;  ///< one a triangle; empty: none is

  /// In the order of geometry::BuildEdges. Sharp edges are turned so that their path runs from corner 0 to corner 1 and
  /// has all its left faces on one side.
  std::vector<geometry::Edge> edges;
  std::vector<EdgeKind> kinds;           ///< one an edge
  std::vector<std::uint8_t> is_concave;  ///< one an edge: outer angle of its faces 180 degrees or less, as it was built
  /// One an edge: its connected surface has boundaries or double-sided faces, so that concave edges can be seen
  /// (section 5).
  std::vector<std::uint8_t> is_open;

  /// Sharp edges path by path, each path from its beginning to its end; path p is
  /// sharp[path_begins[p]] .. sharp[path_begins[p + 1] - 1].
  std::vector<std::uint32_t> sharp;
  std::vector<std::uint32_t> path_begins;
  std::vector<std::uint32_t> boundaries;  ///< edges of kind kBoundary, ascending

  FacePlanes planes;       ///< one a triangle; 0 for degenerate ones
  bool is_closed = false;  ///< no surface of it is open
  bool shows_back_faces = false;
  bool keeps_concave = false;
  bool is_deformed = false;  ///< UpdateDeformed was called: kinds and paths are as built, concavity is tested per view
  SilhouetteEdges silhouettes;  ///< smooth edges that may show as silhouettes, in the tree's order if there is one
  SilhouetteTree tree;          ///< over `silhouettes`; empty: they are scanned

  [[nodiscard]] std::size_t face_count() const { return triangles.size() / 3; }
  /// The face is drawn when it looks away from the eye.
  [[nodiscard]] bool ShowsBack(std::uint32_t face) const {
    return shows_back_faces || (!double_sided.empty() && double_sided[face] != 0);
  }
  /// The vertex of `face` that is not one of `corners`, which are two of its own.
  [[nodiscard]] std::uint32_t ThirdCorner(std::uint32_t face, const std::array<std::uint32_t, 2>& corners) const;
  [[nodiscard]] glm::vec3 Midpoint(const geometry::Edge& edge) const {
    return 0.5f * (positions[edge.corners_left[0]] + positions[edge.corners_left[1]]);
  }
};

/// Welds, finds and classifies edges, turns sharp paths one way and builds the silhouette search. An empty mesh gives
/// an empty result. Errors: those of CheckMeshInput.
[[nodiscard]] Result<EdgeMesh> BuildEdgeMesh(const MeshInput& input, const EdgeMeshOptions& options = {});

/// Moves the vertices (`positions`: one a vertex of the mesh, as many as before). Planes are computed anew, in
/// parallel; from now on silhouettes are scanned. Positions that aren't finite give faces that look nowhere.
void UpdateDeformed(EdgeMesh& mesh, std::span<const glm::vec3> positions);

}  // namespace burin::overdraw
