// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/scene/gltf_document.h"
#include "core/scene/scene.h"

namespace tinygltf {
struct Primitive;
}

namespace burin::scene {

/// The vertex arrays and morph targets of a glTF primitive that has POSITION, as the file holds them: counts, component
/// types and numbering checked, joints' weights made to add up to 1. No indices yet. `where` starts its messages.
[[nodiscard]] Result<Primitive> ReadAttributes(GltfDocument& document, const tinygltf::Primitive& source,
                                               const std::string& where);

}  // namespace burin::scene
