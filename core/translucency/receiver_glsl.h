// SPDX-License-Identifier: Apache-2.0
#pragma once
// Radiosity on a body's faces: gathered, or taken from receivers around, and looked up.
//
// Two rows of six faces of receivers. Those of a wide lattice on the faces are all gathered; then those amid four of
// them, those amid two of each, and so on with half the spacing, only where the light around them does not change
// evenly. What is to be gathered is put in a list first, so that no lane of a vector idles: on a software rasterizer
// nothing costs as much as gathering. The list's order is any, each receiver's light is not.

#include <string>

#include "core/translucency/scattering_quality.h"

namespace burin::translucency {

/// Compute shaders of groups of kReceiverGroup. The first, (faces' receivers of a lattice in groups of 8 x 8) x 12
/// groups, writes receivers or puts them in the list; the second gathers the list's.
[[nodiscard]] std::string ReceiverChoiceText(const Quality& quality, bool has_parts);
[[nodiscard]] std::string ReceiverText(const Quality& quality, bool has_parts);
inline constexpr int kReceiverGroup = 64;

/// After BodyDeclarations(), PARTS 0 or 1:
///   void Radiosity(vec3 world, vec3 g, out vec3 all, out vec3 near)
[[nodiscard]] std::string LookUpFunctions();

}  // namespace burin::translucency
