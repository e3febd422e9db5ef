// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/scene/gltf_reader.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// True when the extension is one that ReadScene takes: .gltf .glb .obj .bpt, in any case.
[[nodiscard]] bool IsScenePath(const std::string& path);

/// Reads a scene by its extension. Errors: kInput, naming the file and the object or line.
[[nodiscard]] Result<Scene> ReadScene(const std::string& path, const ReadOptions& options);

}  // namespace burin::scene
