// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_mesh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "core/geometry/degenerate.h"
#include "core/geometry/weld.h"
#include "core/overdraw/concavity.h"
#include "core/overdraw/edge_classifier.h"
#include "core/overdraw/open_surfaces.h"
#include "core/overdraw/sharp_paths.h"
#include "core/overdraw/slivers.h"

namespace burin::overdraw {
namespace {

constexpr std::size_t kGrain = 8192;

template <class Body>
void ForEach(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kGrain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
  });
}

void ListSharpAndBoundaries(std::span<const std::uint32_t> welded, EdgeMesh& mesh) {
  SharpPaths paths = OrientSharpPaths(mesh.kinds, mesh.positions, welded, mesh.edges);
  mesh.sharp = std::move(paths.edges);
  mesh.path_begins = std::move(paths.begins);
  for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
    if (mesh.kinds[e] == EdgeKind::kBoundary) mesh.boundaries.push_back(e);
  }
}

/// Smooth edges, but of closed surfaces the convex ones only unless `with_concave`: others are hidden behind the
/// surface's own faces wherever they are silhouettes (section 3.2).
void ListSilhouettes(bool with_concave, EdgeMesh& mesh) {
  mesh.silhouettes = {};
  for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
    if (mesh.kinds[e] != EdgeKind::kSmooth) continue;
    if (!with_concave && mesh.is_concave[e] != 0 && mesh.is_open[e] == 0) continue;
    mesh.silhouettes.left.push_back(mesh.edges[e].left);
    mesh.silhouettes.right.push_back(mesh.edges[e].right);
    mesh.silhouettes.edge.push_back(e);
  }
}

void BuildTree(EdgeMesh& mesh) {
  std::vector<glm::vec3> midpoints(mesh.silhouettes.size());
  ForEach(midpoints.size(), [&](std::size_t i) { midpoints[i] = mesh.Midpoint(mesh.edges[mesh.silhouettes.edge[i]]); });
  mesh.tree = SilhouetteTree::Build(mesh.planes, midpoints, mesh.silhouettes);
}

}  // namespace

std::uint32_t EdgeMesh::ThirdCorner(std::uint32_t face, const std::array<std::uint32_t, 2>& corners) const {
  const std::uint32_t* corner = &triangles[std::size_t{3} * face];
  for (int k = 0; k < 2; ++k, ++corner) {
    if (*corner != corners[0] && *corner != corners[1]) break;
  }
  return *corner;
}

Result<EdgeMesh> BuildEdgeMesh(const MeshInput& input, const EdgeMeshOptions& options) {
  if (Result<void> checked = CheckMeshInput(input); !checked) return std::unexpected(std::move(checked.error()));
  EdgeMesh mesh;
  mesh.name = input.name;
  mesh.positions.assign(input.positions.begin(), input.positions.end());
  mesh.triangles.assign(input.triangles.begin(), input.triangles.end());
  if (std::ranges::any_of(input.face_double_sided, [](std::uint8_t b) { return b != 0; }))
    mesh.double_sided.assign(input.face_double_sided.begin(), input.face_double_sided.end());
  mesh.shows_back_faces = options.shows_back_faces;
  mesh.keeps_concave = options.keeps_concave;

  const std::vector<std::uint32_t> welded = geometry::WeldPositions(mesh.positions);
  // Without a curved surface's slivers there would be boundaries on both sides of each.
  std::vector<std::uint8_t> degenerate;
  if (!input.is_curved) degenerate = geometry::FindDegenerate(mesh.triangles, mesh.positions);
  mesh.edges = geometry::BuildEdges(mesh.triangles, welded, degenerate);
  ComputeFacePlanes(mesh.triangles, mesh.positions, degenerate, mesh.planes);
  if (input.is_curved) TurnSlivers(mesh.triangles, mesh.positions, input.normals, mesh.edges, mesh.planes);
  mesh.kinds = ClassifyEdges(input, mesh.edges, mesh.planes, options.crease_angle_deg);
  mesh.is_open = FindOpenSurfaces(mesh.edges, mesh.kinds, mesh.double_sided, mesh.face_count());
  mesh.is_closed = !mesh.edges.empty() && std::ranges::find(mesh.is_open, 1) == mesh.is_open.end();
  mesh.is_concave.resize(mesh.edges.size());
  ForEach(mesh.edges.size(), [&](std::size_t e) { mesh.is_concave[e] = IsConcave(mesh, mesh.edges[e]); });
  ListSharpAndBoundaries(welded, mesh);
  ListSilhouettes(/*with_concave=*/mesh.keeps_concave, mesh);
  if (mesh.silhouettes.size() >= std::max<std::size_t>(options.least_tree_edges, 1)) BuildTree(mesh);
  return mesh;
}

void UpdateDeformed(EdgeMesh& mesh, std::span<const glm::vec3> positions) {
  const std::size_t count = std::min(positions.size(), mesh.positions.size());
  std::copy_n(positions.begin(), count, mesh.positions.begin());
  // No mask of degenerate faces: a triangle that had no area may have one now, and the other way round.
  ComputeFacePlanes(mesh.triangles, mesh.positions, {}, mesh.planes);
  if (mesh.is_deformed) return;
  mesh.is_deformed = true;
  mesh.tree = {};
  ListSilhouettes(/*with_concave=*/true, mesh);
}

}  // namespace burin::overdraw
