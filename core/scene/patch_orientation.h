// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/bezier_patches.h"

namespace burin::scene {

/// Mirrors all patches along u if their normals look inwards, by the volume that they enclose: what light enters has to
/// know where its outside is, and patch files don't say (Newell's teapot is inside out). Flat ones and those with
/// normals of their own stay as they are. Patches must have passed geometry::CheckPatches.
void TurnOutwards(geometry::BezierPatches& patches);

}  // namespace burin::scene
