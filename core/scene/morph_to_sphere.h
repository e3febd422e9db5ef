// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/scene/pose.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// Moves each object's triangles towards the sphere about its bounding box's centre that holds it: a point p goes to
/// (1 - amount) p + amount (c + r (p - c) / |p - c|). Normals and tangents follow exactly, by the map's derivative.
/// `amount`: 0 (nothing changes) to 1 (the sphere).
void MorphToSphere(const Scene& scene, float amount, std::vector<DrawItem>& items);

}  // namespace burin::scene
