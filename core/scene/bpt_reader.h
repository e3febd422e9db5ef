// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/scene/gltf_reader.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// Reads a Bézier patch file: the number of patches; then for each its degrees in u and v (1 to 7) and (m + 1)(n + 1)
/// control points of three numbers, those along v first. Words are separated by any blanks. One node, one mesh, one
/// primitive with `patches`, shown from both sides. The material is the first of NAME.mtl beside NAME.bpt, if that is
/// there. Errors: kInput, naming file, line, patch and point (from 1).
[[nodiscard]] Result<Scene> ReadBpt(const std::string& path, const ReadOptions& options);

}  // namespace burin::scene
