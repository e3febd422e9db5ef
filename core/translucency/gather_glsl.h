// SPDX-License-Identifier: Apache-2.0
#pragma once
// Gathering radiosity from a body's sources, and looking it up on its faces.
//
// Sources form a pyramid: each texel of a level sums four of the level below. All levels lie in one texture, level k
// below level k - 1, so that a tap costs one fetch of 16 bytes:
//   x: unit position x, y as 16-bit fractions   y: z as one, and area as a half float
//   z: red and green as half floats             w: blue
// Light and area are divided by the level's number of base texels.
//
// A receiver goes through every face from its coarsest level down. At each level it takes a window of 2M x 2M texels
// about itself; the inner M x M are left to the next finer level if any of them lies near in space, else taken too.
// There is no radius at which the dipole is cut off. (Jensen and Buhler 2002 descend an octree of samples by the solid
// angle of its nodes; windows need no stack and neighbouring receivers take nearly the same texels.)

#include <string>

#include "core/translucency/scattering_quality.h"

namespace burin::translucency {

/// Packs the source pass's two textures, and sums levels.
[[nodiscard]] std::string PyramidBaseFragmentText();
[[nodiscard]] std::string PyramidLevelFragmentText();

/// Radiosity of the faces' texels.
[[nodiscard]] std::string ReceiverFragmentText(const Quality& quality, bool has_parts);

/// After BodyDeclarations(), PARTS 0 or 1:
///   void Radiosity(vec3 world, vec3 g, out vec3 all, out vec3 near)
[[nodiscard]] std::string LookUpFunctions();

/// Covers the viewport.
[[nodiscard]] std::string CoveringVertexText();

}  // namespace burin::translucency
