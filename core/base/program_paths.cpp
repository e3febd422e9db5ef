// SPDX-License-Identifier: Apache-2.0
#include "core/base/program_paths.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace burin::base {
namespace fs = std::filesystem;

namespace {

std::vector<std::string> FromEnvironment(const char* variable) {
  const char* list = std::getenv(variable);
  return list != nullptr ? SplitSearchPath(list) : std::vector<std::string>{};
}

}  // namespace

std::vector<std::string> SplitSearchPath(std::string_view list) {
  std::vector<std::string> folders;
  while (!list.empty()) {
    const std::size_t end = list.find(':');
    const std::string_view folder = list.substr(0, end);
    if (!folder.empty()) folders.emplace_back(folder);
    list = end == std::string_view::npos ? std::string_view{} : list.substr(end + 1);
  }
  return folders;
}

std::string ExecutableFolder() {
  std::error_code error;
  const fs::path executable = fs::read_symlink("/proc/self/exe", error);
  return error ? std::string{} : executable.parent_path().string();
}

std::vector<std::string> EffectFolders() {
  std::vector<std::string> candidates = FromEnvironment("BURIN_EFFECTS_PATH");
  if (const std::string folder = ExecutableFolder(); !folder.empty()) {
    candidates.push_back(folder + "/../share/burin/effects");
  }
  std::vector<std::string> found;
  for (const std::string& candidate : candidates) {
    std::error_code error;
    const fs::path resolved = fs::canonical(candidate, error);
    if (!error && fs::is_directory(resolved, error)) found.push_back(resolved.string());
  }
  return found;
}

std::vector<std::string> ModuleFolders() {
  std::vector<std::string> folders = FromEnvironment("BURIN_MODULE_PATH");
  if (const std::string folder = ExecutableFolder(); !folder.empty()) {
    folders.push_back((fs::path(folder).parent_path() / "lib" / "burin").string());
  }
  return folders;
}

}  // namespace burin::base
