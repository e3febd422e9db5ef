// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace burin::overdraw {

/// The planes of a mesh's triangles, one array a coefficient so that eight are tested at once.
/// Face f looks towards the eye if FacingValue(Plane(f), LocalEye(eye)) > 0; its absolute value is the distance of the
/// eye from the plane (a direction: the cosine). A degenerate face has the plane 0, looking nowhere.
struct FacePlanes {
  glm::vec3 origin{0.0f};  ///< the planes are about this point, the middle of the bounds, to keep their offsets exact
  float radius = 0.0f;     ///< no vertex lies farther from the origin
  std::size_t count = 0;   ///< faces; the arrays are padded with zeros to a multiple of 8
  std::vector<float> x, y, z, w;

  /// Unit normal and offset: dot(normal, position - origin) + w == 0 on the face.
  [[nodiscard]] glm::vec4 Plane(std::size_t face) const { return {x[face], y[face], z[face], w[face]}; }
  [[nodiscard]] glm::vec3 Normal(std::size_t face) const { return {x[face], y[face], z[face]}; }
  /// `eye`: a position (w = 1) or the direction towards the eye (w = 0), object space.
  [[nodiscard]] glm::vec4 LocalEye(const glm::vec4& eye) const { return {glm::vec3(eye) - origin * eye.w, eye.w}; }
};

/// The one expression that decides facing. Whatever evaluates it must keep this order of operations, without fused
/// multiply-adds, so that every way finds the very same edges.
[[nodiscard]] inline float FacingValue(const glm::vec4& plane, const glm::vec4& local_eye) {
  return ((plane.x * local_eye.x + plane.y * local_eye.y) + plane.z * local_eye.z) + plane.w * local_eye.w;
}

/// Fills `planes` from the triangles' corners, in parallel. Nonzero bytes of `degenerate` (empty or one a triangle)
/// give plane 0, as do triangles whose normal can't be computed. The result doesn't depend on the number of threads.
void ComputeFacePlanes(std::span<const std::uint32_t> triangles, std::span<const glm::vec3> positions,
                       std::span<const std::uint8_t> degenerate, FacePlanes& planes);

}  // namespace burin::overdraw
