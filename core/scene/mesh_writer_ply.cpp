// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

#include "core/scene/item_geometry.h"
#include "core/scene/mesh_writer.h"

namespace burin::scene {
namespace {

static_assert(std::endian::native == std::endian::little, "the file's numbers are the processor's");

/// Which properties the file has: those of any item.
struct Properties {
  bool texcoords = false, colors = false;
};

std::string Header(std::size_t vertices, std::size_t faces, const Properties& has) {
  std::string text = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", vertices);
  for (const char* const name : {"x", "y", "z", "nx", "ny", "nz"}) text += fmt::format("property float {}\n", name);
  if (has.texcoords) text += "property float s\nproperty float t\n";
  if (has.colors) {
    for (const char* const name : {"red", "green", "blue", "alpha"}) text += fmt::format("property float {}\n", name);
  }
  return text + fmt::format("element face {}\nproperty list uchar uint vertex_indices\nend_header\n", faces);
}

void AddVertices(const ItemGeometry& geometry, const WorldVertices& world, const Properties& has, SinkBuffer& out) {
  for (std::size_t i = 0; i < world.positions.size(); ++i) {
    const glm::vec3 normal = world.normals.empty() ? glm::vec3(0.0f) : world.normals[i];
    const glm::vec2 t = geometry.texcoords[0].empty() ? glm::vec2(0.0f) : geometry.texcoords[0][i];
    const glm::vec4 c = geometry.colors.empty() ? glm::vec4(1.0f) : geometry.colors[i];
    const glm::vec3 p = world.positions[i];
    std::array<float, 12> values{p.x, p.y, p.z, normal.x, normal.y, normal.z};
    std::size_t count = 6;
    if (has.texcoords) {
      for (int k = 0; k < 2; ++k) values[count++] = t[k];
    }
    if (has.colors) {
      for (int k = 0; k < 4; ++k) values[count++] = c[k];
    }
    out.AddValues(std::span<const float>(values.data(), count));
  }
}

void AddFaces(const ItemGeometry& geometry, std::uint32_t base, bool is_mirrored, SinkBuffer& out) {
  for (std::size_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
    std::array<std::byte, 13> face{std::byte{3}};
    const std::array<std::uint32_t, 3> corners = {base + geometry.indices[i],
                                                  base + geometry.indices[i + (is_mirrored ? 2 : 1)],
                                                  base + geometry.indices[i + (is_mirrored ? 1 : 2)]};
    std::memcpy(&face[1], corners.data(), sizeof(corners));
    out.AddBytes(face);
  }
}

}  // namespace

Result<void> WritePly(const Scene& scene, std::span<const DrawItem* const> items, const ByteSink& sink) {
  Properties has;
  std::size_t vertices = 0, faces = 0;
  for (const DrawItem* item : items) {
    const ItemGeometry geometry = GeometryOf(scene, *item);
    has.texcoords |= !geometry.texcoords[0].empty();
    has.colors |= !geometry.colors.empty();
    vertices += geometry.positions.size();
    faces += geometry.indices.size() / 3;
  }
  SinkBuffer out(sink);
  out.Add(Header(vertices, faces, has));
  std::vector<bool> mirrored;
  for (const DrawItem* item : items) {
    const WorldVertices world = InWorld(scene, *item);
    mirrored.push_back(world.is_mirrored);
    AddVertices(GeometryOf(scene, *item), world, has, out);
  }
  std::uint32_t base = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const ItemGeometry geometry = GeometryOf(scene, *items[i]);
    AddFaces(geometry, base, mirrored[i], out);
    base += static_cast<std::uint32_t>(geometry.positions.size());
  }
  return out.Finish();
}

}  // namespace burin::scene
