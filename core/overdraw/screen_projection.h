// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace burin::overdraw {

/// A point in the picture: pixels from its top left corner, and reversed window depth.
struct ScreenPoint {
  float x, y, z;
};

/// From world space to a picture of some size.
class Projection {
 public:
  Projection(const glm::mat4& clip_from_world, int width, int height)
      : clip_(clip_from_world),
        half_width_(0.5f * static_cast<float>(width)),
        half_height_(0.5f * static_cast<float>(height)) {}

  [[nodiscard]] glm::vec4 Clip(const glm::vec3& world) const { return clip_ * glm::vec4(world, 1.0f); }
  [[nodiscard]] ScreenPoint Screen(const glm::vec4& clip) const {
    const float scale = 1.0f / clip.w;
    return {(clip.x * scale + 1.0f) * half_width_, (1.0f - clip.y * scale) * half_height_, clip.z * scale};
  }
  [[nodiscard]] glm::vec2 ClipOfPixel(float x, float y) const {
    return {x / half_width_ - 1.0f, 1.0f - y / half_height_};
  }
  /// |dz/dx| + |dz/dy| of the plane of three clip-space points in the picture; infinite where it is seen edge on or
  /// reaches behind the eye.
  [[nodiscard]] float Slope(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c) const;

 private:
  glm::mat4 clip_;
  float half_width_, half_height_;
};

}  // namespace burin::overdraw
