// SPDX-License-Identifier: Apache-2.0
#include "core/render/effect_textures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "core/image/image_module.h"
#include "core/render/effect_file.h"
#include "fx_parser/source/file_system.h"

namespace burin::render {

namespace {

std::vector<std::string> Folders(const std::string& effect_path, const std::vector<std::string>& include_folders) {
  std::vector<std::string> folders{std::filesystem::path(effect_path).parent_path().string()};
  if (!folders.front().empty()) folders.emplace_back();  // the working folder
  folders.insert(folders.end(), include_folders.begin(), include_folders.end());
  return folders;
}

// Files are named with the folders of whoever made the effect: the file alone may lie in one of ours.
std::string WithoutFolder(const std::string& path) {
  const std::size_t folder = path.find_last_of("/\\");
  return folder == std::string::npos ? std::string() : path.substr(folder + 1);
}

// Empty when there is no such file.
std::string Find(const std::string& path, const std::vector<std::string>& folders) {
  const fx::DiskFileSystem files;
  for (const std::string& name : {path, WithoutFolder(path)}) {
    for (const std::string& folder : folders) {
      if (name.empty()) continue;
      std::string found = files.Find(folder.empty() || name.starts_with('/') ? name : folder + "/" + name);
      if (!found.empty()) return found;
    }
  }
  return {};
}

}  // namespace

std::string TextureFolders(const std::string& effect_path, const std::vector<std::string>& include_folders) {
  std::vector<std::string> searched;
  for (const std::string& folder : Folders(effect_path, include_folders))
    searched.push_back(folder.empty() ? "." : folder);
  return fmt::format("{}", fmt::join(searched, ", "));
}

effect::TextureLoader TextureLoaderFor(const std::string& effect_path,
                                       const std::vector<std::string>& include_folders) {
  const std::vector<std::string> folders = Folders(effect_path, include_folders);
  return [folders](const std::string& path) -> Result<std::optional<image::Image>> {
    const std::string found = Find(path, folders);
    if (found.empty()) return std::optional<image::Image>();
    auto module = image::LoadImageModule();
    if (!module) return std::unexpected(module.error());
    auto picture = (*module)->Read(found);
    if (!picture) return std::unexpected(picture.error());
    return std::optional(*std::move(picture));
  };
}

effect::EffectOpener EffectOpenerFor(const std::string& effect_path, const std::vector<std::string>& include_folders) {
  return [effect_path, include_folders](const std::string& path) -> Result<std::shared_ptr<const fx::Effect>> {
    const std::string found = Find(path, Folders(effect_path, include_folders));
    if (found.empty()) {
      return Fail(ErrorKind::kInput,
                  fmt::format("'{}' not found; searched: {}", path, TextureFolders(effect_path, include_folders)));
    }
    const EffectFile file = CompileEffectFile(found, {include_folders, {}});
    if (!file.effect) return std::unexpected(ErrorOf(file));
    return file.effect;
  };
}

}  // namespace burin::render
