// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/effect/effect_runner.h"

namespace burin::render {

/// Finds an effect's texture files as it finds its includes: in the effect's own folder, as written, then in
/// `include_folders`, without regard to case. Errors: kInput, naming the folders that were searched.
[[nodiscard]] effect::TextureLoader TextureLoaderFor(const std::string& effect_path,
                                                     const std::vector<std::string>& include_folders);

}  // namespace burin::render
