// SPDX-License-Identifier: Apache-2.0
#pragma once
// Morph targets and linear-blend skinning of one primitive, in parallel over its vertices. Each vertex is computed
// alone, so the bits do not depend on the number of threads.

#include <glm/mat4x4.hpp>
#include <span>

#include "core/scene/pose.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// What moves a primitive's vertices at one time.
struct Deformation {
  std::span<const float> weights;             ///< one a morph target, or none
  std::span<const glm::mat4> joint_matrices;  ///< world from bind space, one a joint of the skin; empty: not skinned
};

/// Fills `out`, reusing its arrays: world-space vertices when skinned, else object-space ones.
void DeformPrimitive(const Primitive& primitive, const Deformation& now, const Deformation& previous,
                     DeformedVertices& out, bool wants_previous_normals = false);

}  // namespace burin::scene
