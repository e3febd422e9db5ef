// SPDX-License-Identifier: Apache-2.0
#include "core/scene/bpt_reader.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "core/scene/bpt_file.h"
#include "core/scene/mtl_file.h"
#include "core/scene/patch_orientation.h"
#include "core/scene/patch_primitive.h"
#include "core/scene/text_lines.h"

namespace burin::scene {
namespace {

Result<Scene> Read(const std::string& path, const ReadOptions& options) {
  const Result<std::string> text = ReadText(path);
  if (!text) return std::unexpected(text.error());
  Result<geometry::BezierPatches> patches = ParseBpt(*text);
  if (!patches) return std::unexpected(patches.error());
  TurnOutwards(*patches);
  Scene scene;
  scene.path = path;
  const std::filesystem::path file(path);
  scene.name = file.stem().string();
  std::filesystem::path sidecar = file;
  sidecar.replace_extension(".mtl");
  if (std::error_code status; std::filesystem::is_regular_file(sidecar, status)) {
    Result<std::vector<Material>> materials = ReadMtl(sidecar.string(), options.decode_image, scene);
    if (!materials) return std::unexpected(materials.error());
    if (!materials->empty()) scene.materials = {std::move(materials->front())};
  }
  if (scene.materials.empty()) scene.materials.push_back(PlainMaterial());
  scene.materials.front().double_sided = true;  // which side is the front is nothing that the format says
  Mesh mesh{.name = scene.name, .primitives = {}, .weights = {}};
  mesh.primitives.push_back(MakePatchPrimitive(*std::move(patches), 0));
  scene.meshes.push_back(std::move(mesh));
  Node node;
  node.name = scene.name;
  node.mesh = 0;
  scene.nodes.push_back(std::move(node));
  scene.roots = {0};
  return scene;
}

}  // namespace

Result<Scene> ReadBpt(const std::string& path, const ReadOptions& options) {
  Result<Scene> scene = Read(path, options);
  if (!scene && !scene.error().message.starts_with(path)) {
    return Fail(scene.error().kind, fmt::format("{}: {}", path, scene.error().message));
  }
  return scene;
}

}  // namespace burin::scene
