// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>

#include "core/scene/item_geometry.h"
#include "core/scene/mesh_writer.h"

namespace burin::scene {
namespace {

/// "v 1 2 0.1": the shortest digits that read back as the same floats.
void AddLine(SinkBuffer& out, std::string_view keyword, std::initializer_list<float> numbers) {
  std::array<char, 160> line{};
  char* at = std::copy(keyword.begin(), keyword.end(), line.data());
  for (const float number : numbers) {
    *at++ = ' ';
    at = std::to_chars(at, line.data() + line.size() - 1, number).ptr;
  }
  *at++ = '\n';
  out.Add({line.data(), at});
}

/// Words end at blanks.
std::string OneWord(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= ' ') c = '_';
  }
  return name;
}

}  // namespace

Result<void> WriteObj(const Scene& scene, std::span<const DrawItem* const> items, const ByteSink& sink) {
  SinkBuffer out(sink);
  std::size_t base = 1, texcoord_base = 1;
  for (const DrawItem* item : items) {
    const ItemGeometry geometry = GeometryOf(scene, *item);
    const WorldVertices world = InWorld(scene, *item);
    out.Add(fmt::format("o {}\n", OneWord(NameOf(scene, *item))));
    if (item->material_id > 0 && !scene.materials[item->material_id - 1].name.empty()) {
      out.Add(fmt::format("usemtl {}\n", OneWord(scene.materials[item->material_id - 1].name)));
    }
    const bool has_colors = !geometry.colors.empty(), has_texcoords = !geometry.texcoords[0].empty();
    for (std::size_t i = 0; i < world.positions.size(); ++i) {
      const glm::vec3 p = world.positions[i];
      if (!has_colors) AddLine(out, "v", {p.x, p.y, p.z});
      if (has_colors) {
        const glm::vec4 c = geometry.colors[i];
        AddLine(out, "v", {p.x, p.y, p.z, c.r, c.g, c.b});
      }
    }
    for (const glm::vec3& n : world.normals) AddLine(out, "vn", {n.x, n.y, n.z});
    for (const glm::vec2& t : geometry.texcoords[0]) AddLine(out, "vt", {t.x, 1.0f - t.y});
    for (std::size_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
      std::string face = "f";
      for (const std::size_t k : {0u, world.is_mirrored ? 2u : 1u, world.is_mirrored ? 1u : 2u}) {
        const std::size_t v = geometry.indices[i + k];
        face += has_texcoords ? fmt::format(" {}/{}/{}", base + v, texcoord_base + v, base + v)
                              : fmt::format(" {}//{}", base + v, base + v);
      }
      out.Add(face + "\n");
    }
    base += world.positions.size();
    texcoord_base += geometry.texcoords[0].size();
  }
  return out.Finish();
}

}  // namespace burin::scene
