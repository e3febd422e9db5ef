// SPDX-License-Identifier: Apache-2.0
// Sharp edges: Sander et al. 2001, section 3.2. Deviations: a crease angle adds edges that are smoothly shaded but
// bent; differences too small to be seen don't count, since files store quantised and recomputed attributes.
#include "core/overdraw/edge_classifier.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace burin::overdraw {
namespace {

/// Normals and planes closer than 1 degree shade alike: a quantisation to 8 bits moves a normal by up to 0.4 degrees.
constexpr float kSameDirectionDeg = 1.0f;
constexpr float kSameColor = 0.5f / 255.0f;
/// A tenth of a texel of a 1024 texture.
constexpr float kSameTexcoord = 1e-4f;

template <class Vector>
bool Differ(std::span<const Vector> values, std::uint32_t a, std::uint32_t b, float tolerance) {
  if (values.empty() || a == b) return false;
  for (int k = 0; k < Vector::length(); ++k) {
    const float x = values[a][k], y = values[b][k];
    // Negated, so that a NaN on one side differs; infinities of one sign are the same.
    if (x != y && !(std::abs(x - y) <= tolerance) && !(std::isnan(x) && std::isnan(y))) return true;
  }
  return false;
}

class Classifier {
 public:
  Classifier(const MeshInput& input, const FacePlanes& planes, float crease_angle_deg)
      : input_(input),
        planes_(planes),
        same_cosine_(std::cos(glm::radians(kSameDirectionDeg))),
        crease_cosine_(std::cos(glm::radians(std::clamp(crease_angle_deg, 0.0f, 180.0f)))) {}

  [[nodiscard]] EdgeKind KindOf(const geometry::Edge& edge) const;

 private:
  /// At one end or at both.
  template <class Test>
  [[nodiscard]] static bool AtAnEnd(const geometry::Edge& edge, const Test& test) {
    return test(edge.corners_left[0], edge.corners_right[0]) || test(edge.corners_left[1], edge.corners_right[1]);
  }
  [[nodiscard]] bool NormalsDiffer(std::uint32_t a, std::uint32_t b) const;

  const MeshInput& input_;
  const FacePlanes& planes_;
  float same_cosine_, crease_cosine_;
};

bool Classifier::NormalsDiffer(std::uint32_t a, std::uint32_t b) const {
  if (input_.normals.empty() || a == b) return false;
  const glm::vec3 na = input_.normals[a], nb = input_.normals[b];
  const float lengths = glm::length(na) * glm::length(nb);
  // A zero or broken normal says nothing about the shading.
  if (!(lengths > 0.0f) || !std::isfinite(lengths)) return false;
  return glm::dot(na, nb) < same_cosine_ * lengths;
}

EdgeKind Classifier::KindOf(const geometry::Edge& edge) const {
  if (edge.right == geometry::kNoFace || edge.is_non_manifold) return EdgeKind::kBoundary;
  if (!input_.face_materials.empty() && input_.face_materials[edge.left] != input_.face_materials[edge.right])
    return EdgeKind::kMaterial;
  const float cosine = glm::dot(planes_.Normal(edge.left), planes_.Normal(edge.right));
  const bool normals_differ = AtAnEnd(edge, [&](std::uint32_t a, std::uint32_t b) { return NormalsDiffer(a, b); });
  if (normals_differ && cosine < same_cosine_) return EdgeKind::kCrease;
  if (!input_.is_curved && cosine < same_cosine_ && cosine < crease_cosine_) return EdgeKind::kCrease;
  const bool attributes_differ = AtAnEnd(edge, [&](std::uint32_t a, std::uint32_t b) {
    return Differ(input_.colors, a, b, kSameColor) || Differ(input_.texcoords[0], a, b, kSameTexcoord) ||
           Differ(input_.texcoords[1], a, b, kSameTexcoord);
  });
  return normals_differ || attributes_differ ? EdgeKind::kSeam : EdgeKind::kSmooth;
}

}  // namespace

std::vector<EdgeKind> ClassifyEdges(const MeshInput& input, std::span<const geometry::Edge> edges,
                                    const FacePlanes& planes, float crease_angle_deg) {
  const Classifier classifier(input, planes, crease_angle_deg);
  std::vector<EdgeKind> kinds(edges.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, edges.size(), 8192), [&](const auto& range) {
    for (std::size_t e = range.begin(); e < range.end(); ++e) kinds[e] = classifier.KindOf(edges[e]);
  });
  return kinds;
}

}  // namespace burin::overdraw
