// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/source/include_resolver.h"

#include <algorithm>
#include <filesystem>

namespace burin::fx {

namespace {

std::string FolderOf(const std::string& path) {
  const std::size_t slash = path.find_last_of("/\\");
  if (slash == std::string::npos) return {};
  return path.substr(0, slash == 0 ? 1 : slash);
}

std::string Concatenate(const std::string& folder, const std::string& name) {
  if (folder.empty() || folder == ".") return name;
  return folder.ends_with('/') ? folder + name : folder + "/" + name;
}

bool IsAbsolute(const std::string& name) {
  const bool has_drive = name.size() > 2 && name[1] == ':' && (name[2] == '/' || name[2] == '\\');
  return name.starts_with('/') || name.starts_with('\\') || has_drive;
}

}  // namespace

ResolvedInclude ResolveInclude(const std::string& name, const std::string& including_path,
                               const std::vector<std::string>& include_folders, const FileSystem& files) {
  ResolvedInclude result;
  if (name.empty()) return result;
  if (IsAbsolute(name)) {
    result.path = files.Find(name);
    return result;
  }
  std::string bare = name;
  while (bare.starts_with("./") || bare.starts_with(".\\")) bare.erase(0, 2);
  std::vector<std::string> folders{FolderOf(including_path)};
  folders.insert(folders.end(), include_folders.begin(), include_folders.end());
  for (const std::string& folder : folders) {
    const std::string shown = folder.empty() ? "." : folder;
    if (std::ranges::find(result.searched, shown) != result.searched.end()) continue;
    result.searched.push_back(shown);
    result.path = files.Find(Concatenate(folder, bare));
    if (!result.path.empty()) break;
  }
  return result;
}

std::string PathKey(const std::string& path) {
  std::string slashed = path;
  std::ranges::replace(slashed, '\\', '/');
  return std::filesystem::path(slashed).lexically_normal().string();
}

}  // namespace burin::fx
