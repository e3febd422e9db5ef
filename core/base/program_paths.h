// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where this program's own files live. The build tree is laid out like an install prefix (bin, lib/burin, share/burin),
// so everything is found relative to the executable and an installed tree can be moved.

#include <string>
#include <string_view>
#include <vector>

namespace burin::base {

/// Folder of the running executable (/proc/self/exe), without a trailing slash; empty when /proc is not there.
[[nodiscard]] std::string ExecutableFolder();

/// Folders of the shipped effects that exist: each of $BURIN_EFFECTS_PATH (separated by ':'), then share/burin/effects
/// beside the executable's bin. Links are resolved, so in the build tree this names the source folder.
[[nodiscard]] std::vector<std::string> EffectFolders();

/// Folders where modules are looked for, in order: each of $BURIN_MODULE_PATH, then lib/burin beside the executable's
/// folder. They need not exist.
[[nodiscard]] std::vector<std::string> ModuleFolders();

/// "a:b::c" as {"a", "b", "c"}.
[[nodiscard]] std::vector<std::string> SplitSearchPath(std::string_view list);

}  // namespace burin::base
