// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/scene/gltf_document.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// Every mesh, with lists of indices, unused vertices dropped, normals and tangents made where they are missing.
/// `materials` say which primitives need tangents.
[[nodiscard]] Result<std::vector<Mesh>> ReadMeshes(GltfDocument& document, const std::vector<Material>& materials);

}  // namespace burin::scene
