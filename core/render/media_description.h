// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"

namespace burin::render {

/// What `burin info` says about a scene (meshes, materials, cameras, lights, animations), or an image, image sequence
/// or video (y4m too): size, samples, rate, frames. Errors: kInput.
[[nodiscard]] Result<std::string> MediaText(const std::string& path);
[[nodiscard]] Result<std::string> MediaJson(const std::string& path);

}  // namespace burin::render
