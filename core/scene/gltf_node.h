// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"
#include "core/scene/gltf_document.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// Nodes, the roots of the shown scene, cameras and lights, into `scene`. Refuses cycles and nodes with several
/// parents.
[[nodiscard]] Result<void> ReadNodes(GltfDocument& document, Scene& scene);

/// Skins, after nodes and meshes: checks that every mesh drawn with a skin names only its joints.
[[nodiscard]] Result<void> ReadSkins(GltfDocument& document, Scene& scene);

}  // namespace burin::scene
