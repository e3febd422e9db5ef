// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

namespace burin::effect {

/// A light of the scene, in world space.
struct LightContext {
  std::optional<glm::vec3> position;       ///< absent: it shines from far away
  glm::vec3 direction{0.0f, -1.0f, 0.0f};  ///< towards which it shines, unit
  glm::vec4 color{1.0f};
  float range = 0.0f;  ///< scene units; 0: without end
};

/// What the fixed pipeline knows of an object's surface; colours are display-encoded, as Direct3D 9's are.
struct MaterialContext {
  int index = -1;            ///< in the scene; -1: none of its own
  bool has_texture = false;  ///< of the base colour
  glm::vec4 diffuse{1.0f};
  glm::vec3 specular{0.2f};
  glm::vec3 emissive{0.0f};
  float specular_power = 16.0f;
};

/// What a frame knows that effect parameters ask for. Matrices are column-vector matrices (clip = P * V * p) in
/// glm's storage; core/effect gives shaders the transposes that Direct3D's row vectors expect. Clip z is 0..w.
struct FrameContext {
  long frame = 1;          ///< absolute frame number
  double time_s = 0.0;     ///< (frame - 1) / fps
  double elapsed_s = 0.0;  ///< 1 / fps
  int width = 0;           ///< of the frame, pixels
  int height = 0;
  glm::mat4 view_from_world{1.0f};
  glm::mat4 clip_from_view{1.0f};
  glm::mat4 previous_view_from_world{1.0f};
  glm::mat4 previous_clip_from_view{1.0f};
  glm::mat4 world_from_object{1.0f};  ///< identity but for the draws of a custom attribute
  bool has_scene = true;              ///< false: a picture, whose eye and light are made up
  glm::vec3 eye_world{0.0f};
  glm::vec3 light_direction_world{0.0f, -1.0f, 0.0f};  ///< towards which the key light shines, unit
  glm::vec4 light_color{1.0f};
  /// Of a key light that has a place; absent, effects that ask for one get a point far against its direction.
  std::optional<glm::vec3> light_position_world;
  /// All lights, the key light first; empty: the key light alone.
  std::vector<LightContext> lights;
  /// A sphere around the scene; radius 0: not known.
  glm::vec3 scene_center_world{0.0f};
  float scene_radius = 0.0f;
  MaterialContext material;  ///< of the object that is drawn
};

}  // namespace burin::effect
