// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string_view>

#include "core/base/error.h"

namespace burin::overdraw {

/// One object's triangles, all its primitives in a row. The arrays are looked at while the edges are built, not after.
struct MeshInput {
  std::string_view name;                   ///< for messages
  std::span<const glm::vec3> positions{};  ///< object space
  /// Empty or one a vertex. Vertex normals needn't be of unit length; zero ones say nothing.
  std::span<const glm::vec3> normals{};
  std::span<const glm::vec4> colors{};
  std::array<std::span<const glm::vec2>, 2> texcoords{};
  std::span<const std::uint32_t> triangles{};  ///< three vertex indices a triangle, counterclockwise from the front
  std::span<const int> face_materials{};       ///< empty (one material) or one a triangle
  /// Empty (none is) or one a triangle, nonzero: drawn from behind too.
  std::span<const std::uint8_t> face_double_sided{};
  /// The triangles stand for a curved surface whose normals are the vertices': only those say where it is sharp, and a
  /// sliver, whose own plane is what rounding left of it, looks where its neighbour looks.
  bool is_curved = false;
};

/// kInput, naming the mesh, when an array has the wrong length, an index has no vertex, a position is no finite number
/// or there are more vertices or triangles than 32-bit indices of corners can tell apart.
[[nodiscard]] Result<void> CheckMeshInput(const MeshInput& input);

}  // namespace burin::overdraw
