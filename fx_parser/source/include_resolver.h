// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fx_parser/source/file_system.h"

namespace burin::fx {

struct ResolvedInclude {
  std::string path;                    ///< empty if it was not found
  std::vector<std::string> searched;   ///< the folders looked into, in order, as messages show them
};

/// Both quote forms search alike, as under Direct3D's default handler: the folder of the including file, then
/// `include_folders` in order. Backslashes separate, case is ignored. An absolute path stands for itself.
[[nodiscard]] ResolvedInclude ResolveInclude(const std::string& name, const std::string& including_path,
                                             const std::vector<std::string>& include_folders, const FileSystem& files);

/// One spelling for paths that differ only in "." and ".." steps and separators; tells files apart, opens none.
[[nodiscard]] std::string PathKey(const std::string& path);

}  // namespace burin::fx
