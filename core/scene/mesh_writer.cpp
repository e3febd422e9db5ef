// SPDX-License-Identifier: Apache-2.0
#include "core/scene/mesh_writer.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/scene/item_geometry.h"

namespace burin::scene {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;

}  // namespace

void SinkBuffer::Flush() {
  if (result_ && !bytes_.empty()) result_ = sink_(bytes_);
  bytes_.clear();
}

void SinkBuffer::AddBytes(std::span<const std::byte> bytes) {
  if (bytes_.size() + bytes.size() > kPiece) Flush();
  if (bytes.size() > kPiece) {
    if (result_) result_ = sink_(bytes);
    return;
  }
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

Result<void> SinkBuffer::Finish() {
  Flush();
  return result_;
}

std::string NameOf(const Scene& scene, const DrawItem& item) {
  const std::string& node = scene.nodes[static_cast<std::size_t>(item.node)].name;
  const std::string& mesh = scene.meshes[static_cast<std::size_t>(item.mesh)].name;
  std::string name = !node.empty() ? node : !mesh.empty() ? mesh : fmt::format("node {}", item.node);
  if (item.primitive > 0) name += fmt::format(" {}", item.primitive);
  return name;
}

WorldVertices InWorld(const Scene& scene, const DrawItem& item) {
  const ItemGeometry geometry = GeometryOf(scene, item);
  const glm::dmat4 world(item.world_from_object);
  WorldVertices vertices;
  vertices.is_mirrored = glm::determinant(glm::dmat3(world)) < 0.0;
  const bool is_in_world = item.world_from_object == glm::mat4(1.0f);
  for (const glm::vec3& p : geometry.positions) {
    vertices.positions.push_back(is_in_world ? p : glm::vec3(world * glm::dvec4(glm::dvec3(p), 1.0)) + 0.0f);
  }
  // Cofactors: the inverse transpose times the determinant, defined for flattened items too.
  const glm::dmat3 m(world);
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  for (const glm::vec3& n : geometry.normals) {
    const glm::dvec3 turned = cofactors * glm::dvec3(n) * (vertices.is_mirrored ? -1.0 : 1.0);
    const double length = glm::length(turned);
    vertices.normals.push_back(is_in_world || !(length > 0.0) ? n : glm::vec3(turned / length));
  }
  return vertices;
}

Result<void> WriteMesh(MeshFormat format, const Scene& scene, std::span<const DrawItem> items, const ByteSink& sink) {
  std::vector<const DrawItem*> with_triangles;
  for (const DrawItem& item : items) {
    const ItemGeometry geometry = GeometryOf(scene, item);
    if (geometry.mode == PrimitiveMode::kTriangles && !geometry.indices.empty()) with_triangles.push_back(&item);
  }
  if (with_triangles.empty()) return Fail(ErrorKind::kInput, "no triangles to write");
  switch (format) {
    case MeshFormat::kGlb:
      return WriteGlb(scene, with_triangles, sink);
    case MeshFormat::kObj:
      return WriteObj(scene, with_triangles, sink);
    case MeshFormat::kPly:
      return WritePly(scene, with_triangles, sink);
  }
  return Fail(ErrorKind::kFailed, "unreachable: unknown mesh format");
}

}  // namespace burin::scene
