// SPDX-License-Identifier: Apache-2.0
#include "core/scene/read_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <string_view>

#include "core/base/path.h"
#include "core/scene/bpt_reader.h"
#include "core/scene/obj_reader.h"

namespace burin::scene {
namespace {

struct Reader {
  std::string_view extension;
  Result<Scene> (*read)(const std::string&, const ReadOptions&);
};
constexpr std::array kReaders = {Reader{"gltf", ReadGltf}, Reader{"glb", ReadGltf}, Reader{"obj", ReadObj},
                                 Reader{"bpt", ReadBpt}};

const Reader* ReaderOf(const std::string& path) {
  const auto* const found = std::ranges::find(kReaders, base::LowerExtension(path), &Reader::extension);
  return found == kReaders.end() ? nullptr : found;
}

}  // namespace

bool IsScenePath(const std::string& path) { return ReaderOf(path) != nullptr; }

Result<Scene> ReadScene(const std::string& path, const ReadOptions& options) {
  const Reader* const reader = ReaderOf(path);
  if (reader == nullptr) {
    return Fail(ErrorKind::kInput, fmt::format("{}: expected a scene: .gltf, .glb, .obj or .bpt", path));
  }
  try {
    return reader->read(path, options);
  } catch (const std::bad_alloc&) {
    return Fail(ErrorKind::kInput, fmt::format("{}: the scene does not fit in memory", path));
  }
}

}  // namespace burin::scene
