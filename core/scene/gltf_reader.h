// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// Decodes an encoded image (PNG, JPEG ...). core/render passes the image module's ReadMemory.
using ImageDecoder = std::function<Result<image::Image>(std::span<const std::byte> bytes, const std::string& name)>;

struct ReadOptions {
  ImageDecoder decode_image;  ///< null: images stay empty (`burin info`, tests)
  bool subdivides = true;     ///< .obj: control cages get the patches of their surfaces
};

/// Reads .gltf or .glb. Nothing outside the file's own folder is opened; accessors, indices, node hierarchy and sizes
/// are checked before use. Errors: kInput, naming the file and the object ("Cube.gltf: accessors[3]: ...").
[[nodiscard]] Result<Scene> ReadGltf(const std::string& path, const ReadOptions& options);

}  // namespace burin::scene
