// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "core/base/error.h"
#include "core/geometry/bezier_patches.h"

namespace burin::scene {

/// Bézier patches from the text of a .bpt file: the number of patches, and for each its degrees along u and v and its
/// control points, three numbers each, those along v first. Words before the degrees extend that: `triangle` (one
/// degree; points in the same order), `rational` (a weight after each point; degrees up to 3). After the points may
/// follow `normals`, `texcoords`, `texcoords2` or `colors`, each with degrees of its own, from 0 on, and as many values
/// of 3, 2, 2 or 4 numbers. '#' begins a comment that ends with its line.
/// Errors: kInput with line, patch and point, both counted from 1; messages lack the path.
[[nodiscard]] Result<geometry::BezierPatches> ParseBpt(std::string_view text);

}  // namespace burin::scene
