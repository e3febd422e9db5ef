// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/frame_blocks.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace burin::gbuffer {
namespace {

// Proportional to the inverse transpose, and defined for flattened objects too: the matrix of cofactors, whose columns
// are the cross products of the others.
std::array<glm::vec3, 3> NormalColumns(const glm::mat3& m) {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

// Rounding must not open z-fighting between passes: products in double precision.
glm::mat4 Product(const glm::mat4& a, const glm::mat4& b) { return glm::mat4(glm::dmat4(a) * glm::dmat4(b)); }

glm::vec4 EyeOf(const scene::View& view) {
  const glm::mat4 world_from_view(glm::inverse(glm::dmat4(view.view_from_world)));
  if (view.orthographic) return {glm::normalize(glm::vec3(world_from_view[2])), 0.0f};
  return {glm::vec3(world_from_view[3]), 1.0f};
}

}  // namespace

glm::mat4 ReverseDepth(const scene::View& view) {
  const glm::dmat4 clip(view.clip_from_view);
  glm::dmat4 reversed = clip;
  for (int column = 0; column < 4; ++column) reversed[column][2] = clip[column][3] - clip[column][2];
  const bool is_perspective = !view.orthographic && clip[2][3] == -1.0 && clip[3][3] == 0.0;
  if (is_perspective && view.znear > 0.0f && view.zfar > view.znear) {
    // The difference above loses what a far plane is away from 1; the planes themselves are exact.
    const double near = view.znear;
    const double far = view.zfar;
    const double slope = std::isinf(far) ? 0.0 : near / (far - near);
    const double offset = std::isinf(far) ? near : far * near / (far - near);
    const bool agrees = std::abs(slope - reversed[2][2]) < 1e-4 && std::abs(offset - reversed[3][2]) < 1e-3 * offset;
    if (agrees) {
      reversed[2][2] = slope;
      reversed[3][2] = offset;
    }
  }
  return glm::mat4(reversed);
}

glm::mat4 ClipFromWorld(const scene::View& view) { return Product(ReverseDepth(view), view.view_from_world); }

FrameBlock MakeFrameBlock(const FrameInput& frame, const KeyLight& key, int width, int height) {
  FrameBlock block{};
  block.clip_from_world = ClipFromWorld(frame.view);
  block.previous_clip_from_world = ClipFromWorld(frame.previous_view);
  block.view_from_world = frame.view.view_from_world;
  block.eye = EyeOf(frame.view);
  block.viewport = glm::vec4(static_cast<float>(width), static_cast<float>(height), 0.0f, 0.0f);
  block.key_position = glm::vec4(key.position, 1.0f);
  block.key_direction = glm::vec4(key.direction, static_cast<float>(key.type));
  return block;
}

bool IsMirrored(const glm::mat4& world_from_object) { return glm::determinant(glm::mat3(world_from_object)) < 0.0f; }

DrawBlock MakeDrawBlock(const scene::DrawItem& item) {
  DrawBlock block{};
  block.world_from_object = item.world_from_object;
  block.previous_world_from_object = item.previous_world_from_object;
  const std::array<glm::vec3, 3> columns = NormalColumns(glm::mat3(item.world_from_object));
  // The cofactors are the inverse transpose times the determinant: take back its sign.
  const float sign = IsMirrored(item.world_from_object) ? -1.0f : 1.0f;
  for (std::size_t i = 0; i < 3; ++i) block.normal_columns[i] = glm::vec4(sign * columns[i], sign);
  block.ids = glm::uvec4(item.object_id, item.material_id, item.first_primitive_id, item.first_patch_id);
  return block;
}

}  // namespace burin::gbuffer
