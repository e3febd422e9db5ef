// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/scene/scene.h"

namespace burin::scene {

/// Gives tangents to all lit triangles that have none, for shaders that ask for them whether or not a material has a
/// normal map: along u of the first texture coordinates, or any way along the surface where there are none.
void AddTangents(Scene& scene);

}  // namespace burin::scene
