// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_mesh.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/scene/gltf_accessor.h"
#include "core/scene/gltf_attributes.h"
#include "core/scene/primitive_geometry.h"

namespace burin::scene {
namespace {

std::unexpected<Error> Bad(const std::string& where, const std::string& what) {
  return Fail(ErrorKind::kInput, fmt::format("{}: {}", where, what));
}

/// The file's indices, or 0..n-1 without.
Result<std::vector<std::uint32_t>> ReadIndices(GltfDocument& document, const tinygltf::Primitive& source,
                                               std::size_t vertices, const std::string& where) {
  if (source.indices < 0) {
    std::vector<std::uint32_t> indices(vertices);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
  }
  auto indices = ReadIntegers(document, source.indices, 1);
  if (!indices) return Bad(where + ".indices", indices.error().message);
  for (std::size_t i = 0; i < indices->size(); ++i) {
    if ((*indices)[i] < vertices) continue;
    return Bad(where + ".indices", fmt::format("accessor {}: element {} is {}, but there are {} vertices",
                                               source.indices, i, (*indices)[i], vertices));
  }
  return indices;
}

void WarnOfLeftovers(GltfDocument& document, const std::string& where, int mode, std::size_t indices) {
  const std::size_t group = mode == 1 ? 2 : mode == 4 ? 3 : 1;
  if (indices % group != 0) {
    document.Warn(fmt::format("{}: {} indices are no whole number of {}; the last {} dropped", where, indices,
                              group == 2 ? "lines" : "triangles", indices % group == 1 ? "one is" : "two are"));
  }
}

/// A shading normal of no length cannot be repaired, except where only triangles without area use it.
Result<void> CheckNormals(Primitive& primitive, const std::string& where) {
  for (std::size_t i = 0; i < primitive.normals.size(); ++i) {
    glm::vec3& normal = primitive.normals[i];
    const double length = glm::length(glm::dvec3(normal));
    if (length > 0.0) normal = glm::vec3(glm::dvec3(normal) / length);
  }
  if (primitive.mode != PrimitiveMode::kTriangles || primitive.normals.empty()) return {};
  for (std::size_t t = 0; t + 2 < primitive.indices.size(); t += 3) {
    const std::uint32_t* corner = &primitive.indices[t];
    const glm::dvec3 a(primitive.positions[corner[0]]);
    const glm::dvec3 b(primitive.positions[corner[1]]);
    const glm::dvec3 c(primitive.positions[corner[2]]);
    if (glm::length(glm::cross(b - a, c - a)) <= 0.0) continue;
    for (int k = 0; k < 3; ++k) {
      if (primitive.normals[corner[k]] == glm::vec3(0.0f)) {
        return Bad(where + ".attributes.NORMAL", fmt::format("the normal of vertex {} has no length", corner[k]));
      }
    }
  }
  return {};
}

bool WantsTangents(const Primitive& primitive, const std::vector<Material>& materials) {
  if (primitive.mode != PrimitiveMode::kTriangles || primitive.material == kNone || !primitive.tangents.empty())
    return false;
  const Material& material = materials[static_cast<std::size_t>(primitive.material)];
  if (!material.normal_texture || material.unlit) return false;
  return !primitive.texcoords[static_cast<std::size_t>(material.normal_texture.texcoord)].empty();
}

void FinishTriangles(Primitive& primitive, const std::vector<Material>& materials) {
  for (glm::vec3& normal : primitive.normals) {
    if (normal == glm::vec3(0.0f)) normal = glm::vec3(0.0f, 0.0f, 1.0f);
  }
  if (primitive.normals.empty()) MakeFlatNormals(primitive);
  if (WantsTangents(primitive, materials)) {
    MakeTangents(primitive, materials[static_cast<std::size_t>(primitive.material)].normal_texture.texcoord);
  }
}

std::uint64_t BytesOf(const Primitive& p) {
  std::uint64_t floats = 3 * (p.positions.size() + p.normals.size()) + 4 * (p.tangents.size() + p.colors.size());
  for (std::size_t set = 0; set < 2; ++set) {
    floats += 2 * (p.texcoords[set].size() + p.joints[set].size()) + 4 * p.weights[set].size();
  }
  for (const Primitive::MorphTarget& target : p.targets) {
    floats += 3 * (target.positions.size() + target.normals.size() + target.tangents.size());
  }
  return sizeof(float) * (floats + p.indices.size());
}

Result<Primitive> ReadPrimitive(GltfDocument& document, const tinygltf::Primitive& source, const std::string& where,
                                const std::vector<Material>& materials) {
  const std::uint64_t spent_before = document.spent_bytes();
  auto primitive = ReadAttributes(document, source, where);
  if (!primitive) return primitive;
  auto indices = ReadIndices(document, source, primitive->positions.size(), where);
  if (!indices) return std::unexpected(indices.error());
  const int mode = source.mode;
  WarnOfLeftovers(document, where, mode, indices->size());
  primitive->material = source.material;
  primitive->mode = mode == 0 ? PrimitiveMode::kPoints : mode < 4 ? PrimitiveMode::kLines : PrimitiveMode::kTriangles;
  // Strips and fans grow up to threefold.
  if (auto ok = document.Spend(3 * indices->size() * sizeof(std::uint32_t)); !ok) return Bad(where, ok.error().message);
  primitive->indices = IndexList(std::move(*indices), mode);
  if (auto ok = CheckNormals(*primitive, where); !ok) return std::unexpected(ok.error());
  DropUnusedVertices(*primitive);
  if (primitive->mode == PrimitiveMode::kTriangles) {
    if (primitive->normals.empty()) {  // flat ones give each corner a vertex of its own
      const std::uint64_t vertex_bytes =
          BytesOf(*primitive) / std::max<std::size_t>(primitive->positions.size(), 1) + 12;
      if (auto ok = document.Spend(vertex_bytes * primitive->indices.size()); !ok)
        return Bad(where, ok.error().message);
    }
    FinishTriangles(*primitive, materials);
  }
  document.SetSpent(spent_before + BytesOf(*primitive));
  return primitive;
}

Result<Mesh> ReadMesh(GltfDocument& document, const tinygltf::Mesh& source, const std::string& where,
                      const std::vector<Material>& materials) {
  Mesh mesh;
  mesh.name = source.name;
  for (std::size_t i = 0; i < source.primitives.size(); ++i) {
    const std::string at = fmt::format("{}.primitives[{}]", where, i);
    if (!source.primitives[i].attributes.contains("POSITION")) {
      document.Warn(fmt::format("{}: has no POSITION and is not drawn", at));
      continue;
    }
    auto primitive = ReadPrimitive(document, source.primitives[i], at, materials);
    if (!primitive) return std::unexpected(primitive.error());
    if (!mesh.primitives.empty() && primitive->targets.size() != mesh.primitives.front().targets.size()) {
      return Bad(at, fmt::format("has {} morph targets, the mesh's first primitive has {}", primitive->targets.size(),
                                 mesh.primitives.front().targets.size()));
    }
    mesh.primitives.push_back(std::move(*primitive));
  }
  const std::size_t targets = mesh.primitives.empty() ? 0 : mesh.primitives.front().targets.size();
  if (!source.weights.empty() && source.weights.size() != targets) {
    return Bad(where + ".weights", fmt::format("{} weights for {} morph targets", source.weights.size(), targets));
  }
  mesh.weights.assign(source.weights.begin(), source.weights.end());
  mesh.weights.resize(targets, 0.0f);
  return mesh;
}

}  // namespace

Result<std::vector<Mesh>> ReadMeshes(GltfDocument& document, const std::vector<Material>& materials) {
  std::vector<Mesh> meshes;
  for (std::size_t i = 0; i < document.model().meshes.size(); ++i) {
    auto mesh = ReadMesh(document, document.model().meshes[i], fmt::format("meshes[{}]", i), materials);
    if (!mesh) return std::unexpected(mesh.error());
    meshes.push_back(std::move(*mesh));
  }
  return meshes;
}

}  // namespace burin::scene
