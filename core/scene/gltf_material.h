// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/scene/gltf_document.h"
#include "core/scene/gltf_reader.h"
#include "core/scene/scene.h"

namespace burin::scene {

[[nodiscard]] Result<std::vector<Material>> ReadMaterials(GltfDocument& document);

/// As many images as the file has; those that a material uses are decoded, each once, the others stay empty. Images
/// that only hold data (normals, roughness, occlusion) are marked kData.
[[nodiscard]] Result<std::vector<image::Image>> ReadImages(const GltfDocument& document,
                                                           const std::vector<Material>& materials,
                                                           const ImageDecoder& decode);

}  // namespace burin::scene
