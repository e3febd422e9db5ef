// SPDX-License-Identifier: Apache-2.0
#include "core/scene/obj_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/scene/mtl_file.h"
#include "core/scene/obj_file.h"
#include "core/scene/obj_mesh.h"
#include "core/scene/primitive_geometry.h"
#include "core/scene/scene_folder.h"
#include "core/scene/text_lines.h"

namespace burin::scene {
namespace {

class ObjReader {
 public:
  ObjReader(const std::string& path, const ReadOptions& options, ObjFile file)
      : path_(path), options_(options), file_(std::move(file)) {
    scene_.path = path;
    scene_.name = std::filesystem::path(path).stem().string();
    for (const std::string& warning : file_.warnings) Warn(warning);
  }

  Result<Scene> Read() {
    if (file_.polygons.empty()) return Fail(ErrorKind::kInput, "has no faces, lines or points");
    if (Result<void> read = ReadMaterials(); !read) return std::unexpected(read.error());
    const std::vector<std::vector<ObjGroup>> objects = GroupByObject(file_);
    for (std::size_t object = 0; object < objects.size(); ++object) AddObject(object, objects[object]);
    return std::move(scene_);
  }

 private:
  void Warn(const std::string& message) { scene_.warnings.push_back(fmt::format("{}: {}", path_, message)); }

  /// Into scene_.materials in the order in which the file uses them; the last is for what has none.
  Result<void> ReadMaterials() {
    std::vector<Material> known;
    const SceneFolder folder(path_);
    for (const std::string& library : file_.libraries) {
      const Result<std::string> at = folder.Resolve(library);
      if (!at) {
        Warn(fmt::format("mtllib {}: {}; its materials are plain", library, at.error().message));
        continue;
      }
      Result<std::vector<Material>> materials = ReadMtl(*at, options_.decode_image, scene_);
      if (!materials) return std::unexpected(materials.error());
      known.insert(known.end(), materials->begin(), materials->end());
    }
    for (const std::string& name : file_.materials) {
      const auto found = std::ranges::find(known, name, &Material::name);
      if (found == known.end()) Warn(fmt::format("usemtl {}: no mtllib has it, so it is plain", name));
      scene_.materials.push_back(found != known.end() ? *found : PlainMaterial());
      scene_.materials.back().name = name;
    }
    scene_.materials.push_back(PlainMaterial());
    return {};
  }

  int MaterialOf(const ObjGroup& group) const {
    return group.material == kNoIndex ? static_cast<int>(scene_.materials.size()) - 1
                                      : static_cast<int>(group.material);
  }

  void AddObject(std::size_t object, const std::vector<ObjGroup>& groups) {
    if (groups.empty()) return;
    Mesh mesh;
    mesh.name = file_.objects[object].empty() ? scene_.name : file_.objects[object];
    for (const ObjGroup& group : groups) {
      Primitive primitive = MakePrimitive(file_, group);
      primitive.material = MaterialOf(group);
      const Material& material = scene_.materials[static_cast<std::size_t>(primitive.material)];
      if (material.normal_texture && !primitive.texcoords[0].empty() && !primitive.normals.empty()) {
        MakeTangents(primitive, 0);
      }
      mesh.primitives.push_back(std::move(primitive));
    }
    if (options_.subdivides && IsCage(file_, groups)) Subdivide(groups, mesh);
    Node node;
    node.name = mesh.name;
    node.mesh = static_cast<int>(scene_.meshes.size());
    scene_.meshes.push_back(std::move(mesh));
    scene_.roots.push_back(static_cast<int>(scene_.nodes.size()));
    scene_.nodes.push_back(std::move(node));
  }

  void Subdivide(const std::vector<ObjGroup>& groups, Mesh& mesh) {
    auto patches =
        geometry::MakeCatmullClarkPatches(MakeCage(file_, groups), static_cast<std::uint32_t>(groups.size()));
    if (!patches) {
      Warn(fmt::format("object \"{}\": {}; drawn as polygons", mesh.name, patches.error().message));
      return;
    }
    std::size_t face_group = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (groups[g].element != ObjElement::kFace) continue;
      mesh.primitives[g].patches = std::make_shared<const geometry::BezierPatches>(std::move((*patches)[face_group++]));
    }
  }

  std::string path_;
  const ReadOptions& options_;
  ObjFile file_;
  Scene scene_;
};

}  // namespace

Result<Scene> ReadObj(const std::string& path, const ReadOptions& options) {
  const auto with_path = [&](const Error& error) {
    return Fail(error.kind,
                error.message.starts_with(path) ? error.message : fmt::format("{}: {}", path, error.message));
  };
  const Result<std::string> text = ReadText(path);
  if (!text) return with_path(text.error());
  Result<ObjFile> file = ParseObj(*text);
  if (!file) return with_path(file.error());
  Result<Scene> scene = ObjReader(path, options, *std::move(file)).Read();
  if (!scene) return with_path(scene.error());
  return scene;
}

}  // namespace burin::scene
