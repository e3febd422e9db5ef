// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/scene/gltf_document.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// Every animation; needs the scene's nodes and meshes. Channels that can move nothing are left out with a warning.
[[nodiscard]] Result<std::vector<Animation>> ReadAnimations(GltfDocument& document, const Scene& scene);

}  // namespace burin::scene
