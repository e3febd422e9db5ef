// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/bezier_patches.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// A primitive that is drawn as these patches, and without tessellation as each patch's two triangles (one of a
/// triangular patch).
[[nodiscard]] Primitive MakePatchPrimitive(geometry::BezierPatches patches, int material);

}  // namespace burin::scene
