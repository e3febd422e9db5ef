// SPDX-License-Identifier: Apache-2.0
// The run-time part of Sander et al. 2001, section 3.5. Deviations from the pseudocode:
// - V is eye - midpoint throughout, as in section 3.3; the pseudocode's dots have the other sign and would cull what
//   looks towards the eye. As the midpoint lies in both planes, V . n is the eye's distance from the plane.
// - A sharp edge with one face behind takes the face in front (section 3.3), where beta would leave 0..1.
// - Which faces are on screen depends on culling: see EdgeMeshOptions::shows_back_faces. A concave silhouette of a
//   surface whose back shows has its back face in front.
#include "core/overdraw/extract_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <span>

#include "core/overdraw/concavity.h"
#include "core/overdraw/silhouette_scan.h"

namespace burin::overdraw {
namespace {

/// Footnote 1: sharp edges with beta outside these are near the silhouette and may hide others.
constexpr float kNearLeft = 0.1f, kNearRight = 0.9f;
/// Scans of fewer edges are over before a second thread has woken up.
constexpr std::size_t kParallelScan = 200'000;

class Extractor {
 public:
  Extractor(const EdgeMesh& mesh, const EdgeView& view);

  /// Appends those of `indices` that are on screen, in their order. One thread: tasks with lists of their own took 1.5
  /// times as long on two (82 000 sharp edges, 1.9 ms).
  void DescribeAll(std::span<const std::uint32_t> indices, std::vector<RenderedEdge>& edges) const;
  [[nodiscard]] const glm::vec4& local_eye() const { return local_eye_; }

 private:
  /// False: not on screen.
  [[nodiscard]] bool Describe(std::uint32_t index, RenderedEdge& rendered) const;
  [[nodiscard]] float Distance2(const geometry::Edge& edge) const;
  [[nodiscard]] float FaceDot(std::uint32_t face) const {
    return face == geometry::kNoFace ? 0.0f : FacingValue(mesh_.planes.Plane(face), local_eye_);
  }
  [[nodiscard]] bool IsConcaveNow(std::uint32_t edge) const {
    return mesh_.is_deformed ? IsConcave(mesh_, mesh_.edges[edge]) : mesh_.is_concave[edge] != 0;
  }
  [[nodiscard]] float WorldCosine(std::uint32_t face, float dot) const;
  [[nodiscard]] float Beta(const geometry::Edge& edge, float left, float right) const;
  [[nodiscard]] float Mapped(float beta) const;

  const EdgeMesh& mesh_;
  const EdgeView& view_;
  glm::vec4 local_eye_;
  glm::mat3 normal_matrix_{1.0f}, world_from_object_{1.0f};
  glm::vec3 world_direction_{0.0f};  ///< orthographic: unit, towards the eye
  float tau_;
};

Extractor::Extractor(const EdgeMesh& mesh, const EdgeView& view)
    : mesh_(mesh), view_(view), local_eye_(mesh.planes.LocalEye(view.eye)), tau_(std::clamp(view.tau, 0.0f, 1.0f)) {
  const float determinant = glm::determinant(view.normal_matrix);
  if (std::isnormal(determinant)) {
    normal_matrix_ = view.normal_matrix;
    world_from_object_ = glm::transpose(glm::inverse(view.normal_matrix));
  }
  const glm::vec3 direction = world_from_object_ * glm::vec3(view.eye);
  const float length = glm::length(direction);
  if (length > 0.0f) world_direction_ = direction / length;
}

/// Facing values are invariant, V . n = (M V) . (N n), so only the normal's new length is left to divide by.
float Extractor::WorldCosine(std::uint32_t face, float dot) const {
  const float length = glm::length(normal_matrix_ * mesh_.planes.Normal(face));
  return length > 0.0f ? std::abs(dot) / length : 0.0f;
}

/// Section 3.3, for two faces that are both seen from the front or both from behind.
float Extractor::Beta(const geometry::Edge& edge, float left, float right) const {
  const float l = WorldCosine(edge.left, left), r = WorldCosine(edge.right, right);
  return l + r > 0.0f ? r / (l + r) : 0.0f;
}

float Extractor::Mapped(float beta) const {
  return beta <= tau_ ? 0.0f : std::min(1.0f, (beta - tau_) / (1.0f - tau_));
}

bool Extractor::Describe(std::uint32_t index, RenderedEdge& rendered) const {
  const geometry::Edge& edge = mesh_.edges[index];
  const EdgeKind kind = mesh_.kinds[index];
  const float left = FaceDot(edge.left), right = FaceDot(edge.right);
  const bool has_right = edge.right != geometry::kNoFace;
  const bool front_left = left > 0.0f, front_right = right > 0.0f;
  const bool shows_left = front_left || mesh_.ShowsBack(edge.left);
  const bool shows_right = has_right && (front_right || mesh_.ShowsBack(edge.right));
  if (!shows_left && !shows_right) return false;
  rendered = {.edge = index, .is_front_left = front_left, .is_front_right = front_right};
  if (kind == EdgeKind::kBoundary) {
    rendered.cls = EdgeClass::kBoundary;
    rendered.beta = shows_left && (front_left || !front_right) ? 0.0f : 1.0f;
    rendered.is_sorted = true;
  } else if (front_left != front_right) {
    rendered.cls = EdgeClass::kSilhouette;
    const bool back_shows = front_left ? shows_right : shows_left;
    const bool takes_back = back_shows && IsConcaveNow(index);
    rendered.beta = front_left != takes_back ? 0.0f : 1.0f;
    rendered.is_sorted = true;
  } else if (kind == EdgeKind::kSmooth) {
    return false;
  } else {
    rendered.cls = kind == EdgeKind::kCrease     ? EdgeClass::kCrease
                   : kind == EdgeKind::kMaterial ? EdgeClass::kMaterial
                                                 : EdgeClass::kSeam;
    const bool both_show = shows_left && shows_right;
    const float beta = both_show ? Beta(edge, left, right) : shows_left ? 0.0f : 1.0f;
    rendered.beta = both_show ? Mapped(beta) : beta;
    rendered.is_sorted = beta < kNearLeft || beta > kNearRight;
  }
  rendered.is_sorted = rendered.is_sorted && view_.sorted;
  rendered.distance2 = Distance2(edge);
  return true;
}

float Extractor::Distance2(const geometry::Edge& edge) const {
  const glm::vec3 midpoint = mesh_.Midpoint(edge);
  float distance2 = 0.0f;
  if (view_.eye.w != 0.0f) {
    const glm::vec3 v = world_from_object_ * (glm::vec3(view_.eye) - midpoint);
    distance2 = glm::dot(v, v);
  } else {
    const float distance = view_.eye_distance - glm::dot(world_direction_, world_from_object_ * midpoint);
    distance2 = distance * std::abs(distance);
  }
  // Not a number would break the order.
  return std::isnan(distance2) ? 0.0f : distance2;
}

void Extractor::DescribeAll(std::span<const std::uint32_t> indices, std::vector<RenderedEdge>& edges) const {
  RenderedEdge rendered;
  for (const std::uint32_t index : indices) {
    if (Describe(index, rendered)) edges.push_back(rendered);
  }
}

/// Edges that can't hide others first, in the order they have; then the others from far to near.
void Sort(std::vector<RenderedEdge>& edges) {
  const auto middle =
      std::stable_partition(edges.begin(), edges.end(), [](const RenderedEdge& e) { return !e.is_sorted; });
  std::sort(middle, edges.end(), [](const RenderedEdge& a, const RenderedEdge& b) {
    return a.distance2 != b.distance2 ? a.distance2 > b.distance2 : a.edge < b.edge;
  });
}

/// Smooth edges with one front and one back face that can be seen.
std::vector<std::uint32_t> FindSilhouettes(const EdgeMesh& mesh, const glm::vec4& local_eye,
                                           const ExtractOptions& options, EdgeStatistics& statistics) {
  const bool uses_avx2 = options.uses_avx2 && HasAvx2();
  const bool uses_tree = !mesh.tree.empty() && options.way.value_or(SilhouetteWay::kTree) == SilhouetteWay::kTree;
  statistics.way = uses_tree ? SilhouetteWay::kTree : SilhouetteWay::kScan;
  statistics.searched = statistics.visited = mesh.silhouettes.size();
  std::vector<std::uint32_t> found;
  if (uses_tree) {
    statistics.visited = mesh.tree.Find(local_eye, uses_avx2, found);
  } else {
    const bool is_parallel = options.is_parallel && mesh.silhouettes.size() >= kParallelScan;
    ScanSilhouettes(mesh.planes, mesh.silhouettes, local_eye, {uses_avx2, is_parallel}, found);
  }
  statistics.found = found.size();
  for (std::uint32_t& index : found) index = mesh.silhouettes.edge[index];
  // A moving mesh's search holds concave edges too; of closed surfaces they are hidden.
  if (mesh.is_deformed && !mesh.keeps_concave)
    std::erase_if(found, [&](std::uint32_t e) { return mesh.is_open[e] == 0 && IsConcave(mesh, mesh.edges[e]); });
  return found;
}

}  // namespace

EdgeStatistics& EdgeStatistics::operator+=(const EdgeStatistics& other) {
  faces += other.faces;
  edges += other.edges;
  sharp += other.sharp;
  boundaries += other.boundaries;
  silhouettes += other.silhouettes;
  rendered += other.rendered;
  sorted += other.sorted;
  blended += other.blended;
  searched += other.searched;
  visited += other.visited;
  found += other.found;
  if (other.way == SilhouetteWay::kTree) way = other.way;
  return *this;
}

void ExtractEdges(const EdgeMesh& mesh, const EdgeView& view, std::vector<RenderedEdge>& edges,
                  EdgeStatistics& statistics, const ExtractOptions& options) {
  edges.clear();
  statistics = {};
  statistics.faces = mesh.face_count();
  statistics.edges = mesh.edges.size();
  statistics.sharp = mesh.sharp.size();
  statistics.boundaries = mesh.boundaries.size();
  const Extractor extractor(mesh, view);
  extractor.DescribeAll(mesh.sharp, edges);
  const std::size_t sharp_rendered = edges.size();
  extractor.DescribeAll(mesh.boundaries, edges);
  extractor.DescribeAll(FindSilhouettes(mesh, extractor.local_eye(), options, statistics), edges);
  statistics.rendered = edges.size();
  statistics.silhouettes = edges.size() - sharp_rendered;
  for (const RenderedEdge& edge : edges) {
    statistics.sorted += edge.is_sorted;
    statistics.blended += edge.beta > 0.0f && edge.beta < 1.0f;
  }
  if (view.sorted) Sort(edges);
}

}  // namespace burin::overdraw
