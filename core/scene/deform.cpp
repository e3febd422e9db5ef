// SPDX-License-Identifier: Apache-2.0
#include "core/scene/deform.h"

// glTF 2.0, 3.7.2.2 (morph targets) and 3.7.3.3 (skins: the blend of the joints' matrices). Normals go by the
// inverse transpose of the blended matrix, tangents by the matrix itself; a mirroring matrix turns a tangent's
// handedness.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "core/scene/primitive_geometry.h"

namespace burin::scene {
namespace {

constexpr std::size_t kGrain = 2048;  // vertices: some 50 us of work, well over the cost of a task

template <class Body>
void ForVertices(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kGrain),
                    [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); });
}

/// The three upper rows of the joints' matrices, by column.
struct Affine {
  glm::vec3 x{0.0f}, y{0.0f}, z{0.0f}, origin{0.0f};

  void Add(const glm::mat4& m, float weight) {
    x += glm::vec3(m[0]) * weight;
    y += glm::vec3(m[1]) * weight;
    z += glm::vec3(m[2]) * weight;
    origin += glm::vec3(m[3]) * weight;
  }
  [[nodiscard]] glm::vec3 Point(const glm::vec3& p) const { return x * p.x + y * p.y + z * p.z + origin; }
  [[nodiscard]] glm::vec3 Direction(const glm::vec3& d) const { return x * d.x + y * d.y + z * d.z; }
  /// The inverse transpose but for a positive factor: cofactors times the determinant's sign.
  [[nodiscard]] glm::vec3 Normal(const glm::vec3& n) const {
    const glm::vec3 yz = glm::cross(y, z);
    const glm::vec3 turned = yz * n.x + glm::cross(z, x) * n.y + glm::cross(x, y) * n.z;
    return glm::dot(x, yz) < 0.0f ? -turned : turned;
  }
  [[nodiscard]] bool Mirrors() const { return glm::dot(x, glm::cross(y, z)) < 0.0f; }
};

Affine Blend(const Primitive& p, std::span<const glm::mat4> joints, std::size_t vertex) {
  Affine sum;
  for (std::size_t set = 0; set < 2 && !p.joints[set].empty(); ++set) {
    const glm::u16vec4 joint = p.joints[set][vertex];
    const glm::vec4 weight = p.weights[set][vertex];
    for (int c = 0; c < 4; ++c) {
      if (weight[c] != 0.0f) sum.Add(joints[joint[c]], weight[c]);
    }
  }
  return sum;
}

glm::vec3 UnitOr(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : otherwise;
}

bool IsSkinned(const Primitive& primitive, const Deformation& deformation) {
  return !deformation.joint_matrices.empty() && !primitive.joints[0].empty();
}

/// base + sum of weight * displacement, for the range [begin, end). T is vec3 or vec4 (tangents, whose w stays).
template <class T>
void Morph(const Primitive& p, std::span<const float> weights,
           std::vector<glm::vec3> Primitive::MorphTarget::*displacements, const std::vector<T>& base,
           std::vector<T>& out, std::size_t begin, std::size_t end) {
  std::copy(base.begin() + static_cast<std::ptrdiff_t>(begin), base.begin() + static_cast<std::ptrdiff_t>(end),
            out.begin() + static_cast<std::ptrdiff_t>(begin));
  for (std::size_t t = 0; t < weights.size() && t < p.targets.size(); ++t) {
    const std::vector<glm::vec3>& displacement = p.targets[t].*displacements;
    if (displacement.empty() || weights[t] == 0.0f) continue;
    for (std::size_t i = begin; i < end; ++i) {
      if constexpr (T::length() == 4) {
        out[i] += glm::vec4(displacement[i] * weights[t], 0.0f);
      } else {
        out[i] += displacement[i] * weights[t];
      }
    }
  }
}

void DeformPositions(const Primitive& p, const Deformation& at, std::vector<glm::vec3>& out) {
  out.resize(p.positions.size());
  const bool skinned = IsSkinned(p, at);
  ForVertices(out.size(), [&](std::size_t begin, std::size_t end) {
    Morph(p, at.weights, &Primitive::MorphTarget::positions, p.positions, out, begin, end);
    if (!skinned) return;
    for (std::size_t i = begin; i < end; ++i) out[i] = Blend(p, at.joint_matrices, i).Point(out[i]);
  });
}

void DeformAll(const Primitive& p, const Deformation& at, DeformedVertices& out) {
  out.positions.resize(p.positions.size());
  out.normals.resize(p.normals.size());
  out.tangents.resize(p.tangents.size());
  const bool skinned = IsSkinned(p, at);
  ForVertices(out.positions.size(), [&](std::size_t begin, std::size_t end) {
    Morph(p, at.weights, &Primitive::MorphTarget::positions, p.positions, out.positions, begin, end);
    if (!p.normals.empty()) Morph(p, at.weights, &Primitive::MorphTarget::normals, p.normals, out.normals, begin, end);
    if (!p.tangents.empty())
      Morph(p, at.weights, &Primitive::MorphTarget::tangents, p.tangents, out.tangents, begin, end);
    for (std::size_t i = begin; i < end; ++i) {
      const Affine m = skinned ? Blend(p, at.joint_matrices, i) : Affine{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
      if (skinned) out.positions[i] = m.Point(out.positions[i]);
      if (!p.normals.empty()) out.normals[i] = UnitOr(m.Normal(out.normals[i]), p.normals[i]);
      if (!p.tangents.empty()) {
        const glm::vec4 tangent = out.tangents[i];
        out.tangents[i] = glm::vec4(UnitOr(m.Direction(glm::vec3(tangent)), glm::vec3(p.tangents[i])),
                                    m.Mirrors() ? -tangent.w : tangent.w);
      }
    }
  });
}

/// Each triangle has three vertices of its own: its plane's normal, on the side that the skin's matrix leaves it.
void RemakeFlatNormals(const Primitive& p, const Deformation& at, DeformedVertices& out) {
  const bool skinned = IsSkinned(p, at);
  ForVertices(out.positions.size() / 3, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const std::size_t i = 3 * t;
      glm::vec3 normal = TriangleNormal(out.positions[i], out.positions[i + 1], out.positions[i + 2]);
      if (skinned && Blend(p, at.joint_matrices, i).Mirrors()) normal = -normal;
      out.normals[i] = out.normals[i + 1] = out.normals[i + 2] = normal;
    }
  });
}

bool IsSame(const Deformation& a, const Deformation& b) {
  return std::equal(a.weights.begin(), a.weights.end(), b.weights.begin(), b.weights.end()) &&
         std::equal(a.joint_matrices.begin(), a.joint_matrices.end(), b.joint_matrices.begin(), b.joint_matrices.end());
}

}  // namespace

void DeformPrimitive(const Primitive& primitive, const Deformation& now, const Deformation& previous,
                     DeformedVertices& out, bool wants_previous_normals) {
  DeformAll(primitive, now, out);
  if (primitive.flat_normals) RemakeFlatNormals(primitive, now, out);
  out.previous_normals.clear();
  if (IsSame(now, previous)) {
    out.previous_positions = out.positions;
    if (wants_previous_normals) out.previous_normals = out.normals;
  } else if (wants_previous_normals) {
    DeformedVertices before;
    DeformAll(primitive, previous, before);
    out.previous_positions = std::move(before.positions);
    out.previous_normals = std::move(before.normals);
  } else {
    DeformPositions(primitive, previous, out.previous_positions);
  }
}

}  // namespace burin::scene
