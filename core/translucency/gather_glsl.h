// SPDX-License-Identifier: Apache-2.0
#pragma once
// Gathering radiosity from a body's sources.
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

/// Packs the source pass's two textures into a level, 0 or 1, and sums the levels above it.
[[nodiscard]] std::string PyramidBaseFragmentText(int level);
[[nodiscard]] std::string PyramidLevelFragmentText();

/// GLSL: the pyramid's texture, `Source Unpack(uvec4 texel)` and `int LevelTop(int level)`.
[[nodiscard]] std::string PyramidFunctions();

/// GLSL after PyramidFunctions(), PARTS 0 or 1: `Sum Gather(vec3 unit, int face, bool is_asked)`.
[[nodiscard]] std::string GatherFunctions(const Quality& quality);

/// Covers the viewport.
[[nodiscard]] std::string CoveringVertexText();

}  // namespace burin::translucency
