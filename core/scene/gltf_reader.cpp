// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_reader.h"

#include <fmt/format.h>

#include <filesystem>
#include <new>

#include "core/scene/gltf_animation.h"
#include "core/scene/gltf_document.h"
#include "core/scene/gltf_material.h"
#include "core/scene/gltf_mesh.h"
#include "core/scene/gltf_node.h"

namespace burin::scene {
namespace {

Result<void> CheckNodeWeights(const Scene& scene) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (node.weights.empty()) continue;
    const std::size_t targets =
        node.mesh == kNone ? 0 : scene.meshes[static_cast<std::size_t>(node.mesh)].weights.size();
    if (node.weights.size() == targets) continue;
    return Fail(ErrorKind::kInput,
                fmt::format("nodes[{}].weights: {} weights for {} morph targets", i, node.weights.size(), targets));
  }
  return {};
}

Result<Scene> Read(const std::string& path, const ReadOptions& options) {
  auto document = GltfDocument::Open(path);
  if (!document) return std::unexpected(document.error());
  Scene scene;
  scene.path = path;
  scene.name = std::filesystem::path(path).stem().string();
  if (auto ok = ReadNodes(*document, scene); !ok) return std::unexpected(ok.error());
  auto materials = ReadMaterials(*document);
  if (!materials) return std::unexpected(materials.error());
  scene.materials = std::move(*materials);
  auto meshes = ReadMeshes(*document, scene.materials);
  if (!meshes) return std::unexpected(meshes.error());
  scene.meshes = std::move(*meshes);
  if (auto ok = CheckNodeWeights(scene); !ok) return std::unexpected(ok.error());
  if (auto ok = ReadSkins(*document, scene); !ok) return std::unexpected(ok.error());
  auto animations = ReadAnimations(*document, scene);
  if (!animations) return std::unexpected(animations.error());
  scene.animations = std::move(*animations);
  auto images = ReadImages(*document, scene.materials, options.decode_image);
  if (!images) return std::unexpected(images.error());
  scene.images = std::move(*images);
  for (const std::string& warning : document->TakeWarnings()) scene.warnings.push_back(path + ": " + warning);
  return scene;
}

}  // namespace

Result<Scene> ReadGltf(const std::string& path, const ReadOptions& options) {
  Result<Scene> scene = [&]() -> Result<Scene> {
    try {
      return Read(path, options);
    } catch (const std::bad_alloc&) {
      return Fail(ErrorKind::kInput, "the scene does not fit in memory");
    }
  }();
  if (!scene) return Fail(scene.error().kind, fmt::format("{}: {}", path, scene.error().message));
  return scene;
}

}  // namespace burin::scene
