// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/scene/gltf_reader.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// Reads a Wavefront .obj and its .mtl files: a node with a mesh for each "o", a primitive for each of its materials.
/// Faces without normals are flat, or smooth within their smoothing group. Objects whose faces are all quads without
/// normals, and those with crease tags, are control cages of Catmull-Clark surfaces: their primitives have `patches`.
/// Errors: kInput, naming the file and line.
[[nodiscard]] Result<Scene> ReadObj(const std::string& path, const ReadOptions& options);

}  // namespace burin::scene
