// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/scene/gltf_reader.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// What has no material: a grey that is neither metal nor mirror.
[[nodiscard]] Material PlainMaterial();

/// The materials of a .mtl file in glTF's terms. Kd, d (Tr), Ke and their maps, Ni as they are; Ns by the roughness
/// whose highlight is as wide; the physically based Pr and Pm where they stand; colours are linear; nothing is metallic
/// without Pm. illum 0 is unlit. Pictures go into scene.images; one that is missing or bad, and statements that have no
/// place in glTF (Ks, bump maps), are warned of in scene.warnings and left out. Only files in the .mtl's own folder are
/// opened. Errors: kInput, naming the file and line.
[[nodiscard]] Result<std::vector<Material>> ReadMtl(const std::string& path, const ImageDecoder& decode, Scene& scene);

}  // namespace burin::scene
