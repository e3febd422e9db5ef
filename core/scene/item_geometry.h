// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "core/scene/pose.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// What an item draws in this frame, whichever way it came about: the file's vertices, deformed ones or a tessellated
/// surface. The spans look into the scene and the item. Arrays are empty or have one entry a vertex.
struct ItemGeometry {
  PrimitiveMode mode = PrimitiveMode::kTriangles;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> previous_positions;  ///< empty: as now
  std::span<const glm::vec3> normals;
  std::span<const glm::vec4> tangents;
  std::array<std::span<const glm::vec2>, 2> texcoords;
  std::span<const glm::vec4> colors;
  std::span<const glm::vec2> patch_uv;  ///< of tessellated items only, as patch_ids
  std::span<const std::uint32_t> patch_ids;
  std::span<const std::uint32_t> indices;
};

[[nodiscard]] const Primitive& PrimitiveOf(const Scene& scene, const DrawItem& item);
[[nodiscard]] ItemGeometry GeometryOf(const Scene& scene, const DrawItem& item);

/// Points, lines or triangles that so many indices make.
[[nodiscard]] std::uint32_t ElementCount(PrimitiveMode mode, std::size_t indices);

}  // namespace burin::scene
