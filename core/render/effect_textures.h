// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/effect/effect_runner.h"

namespace burin::render {

/// Finds an effect's texture files as it finds its includes: in the effect's own folder, as written, then in
/// `include_folders`, without regard to case; and, where the path that is written leads nowhere, by the file's own
/// name. Errors: kInput for a file that cannot be read.
[[nodiscard]] effect::TextureLoader TextureLoaderFor(const std::string& effect_path,
                                                     const std::vector<std::string>& include_folders);

/// Compiles effects that others name, found in the same places. Errors: kInput, naming the file.
[[nodiscard]] effect::EffectOpener EffectOpenerFor(const std::string& effect_path,
                                                   const std::vector<std::string>& include_folders);

/// The folders that are searched, for messages.
[[nodiscard]] std::string TextureFolders(const std::string& effect_path,
                                         const std::vector<std::string>& include_folders);

}  // namespace burin::render
