// SPDX-License-Identifier: Apache-2.0
#include "core/render/effect_textures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "core/image/image_module.h"
#include "fx_parser/source/file_system.h"

namespace burin::render {

effect::TextureLoader TextureLoaderFor(const std::string& effect_path,
                                       const std::vector<std::string>& include_folders) {
  namespace fs = std::filesystem;
  std::vector<std::string> folders{fs::path(effect_path).parent_path().string()};
  if (!folders.front().empty()) folders.emplace_back();  // the working folder
  folders.insert(folders.end(), include_folders.begin(), include_folders.end());
  return [effect_path, folders](const std::string& path) -> Result<image::Image> {
    auto module = image::LoadImageModule();
    if (!module) return std::unexpected(module.error());
    const fx::DiskFileSystem files;
    for (const std::string& folder : folders) {
      const std::string found = files.Find(folder.empty() || path.starts_with('/') ? path : folder + "/" + path);
      if (!found.empty()) return (*module)->Read(found);
    }
    std::vector<std::string> searched;
    for (const std::string& folder : folders) searched.push_back(folder.empty() ? "." : folder);
    return Fail(ErrorKind::kInput,
                fmt::format("{}: texture '{}' not found; searched: {}", effect_path, path, fmt::join(searched, ", ")));
  };
}

}  // namespace burin::render
