// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the geometry shaders read, byte for byte: std140 uniform blocks and one std430 array. BlockDeclarations() is the
// GLSL of the same.

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <string_view>

namespace burin::gbuffer {

enum UniformBinding : unsigned { kFrameBinding = 0, kDrawBinding = 1, kMaterialBinding = 2 };
enum StorageBinding : unsigned { kLightBinding = 0, kFaceSampleBinding = 1 };

/// Texture units. The first five follow MaterialTexture.
inline constexpr unsigned kEnvironmentUnit = 5;

enum MaterialTexture : std::size_t {
  kBaseColorTexture,
  kMetallicRoughnessTexture,
  kNormalTexture,
  kOcclusionTexture,
  kEmissiveTexture,
  kMaterialTextures
};

struct FrameBlock {
  glm::mat4 clip_from_world;  ///< depth reversed: 1 at the near plane, 0 at the far one
  glm::mat4 previous_clip_from_world;
  glm::mat4 view_from_world;
  glm::vec4 eye;       ///< world position (w 1) or the direction towards the eye (w 0)
  glm::vec4 viewport;  ///< width, height
  glm::vec4 key_position;
  glm::vec4 key_direction;              ///< w: scene::LightType
  std::array<glm::vec4, 9> irradiance;  ///< spherical harmonics of irradiance / pi
  glm::vec4 environment;                ///< x: strength, y: last level of the reflections, z: number of lights
};

struct DrawBlock {
  glm::mat4 world_from_object;
  glm::mat4 previous_world_from_object;
  std::array<glm::vec4, 3> normal_columns;  ///< world normal from object normal; w of the first: the determinant's sign
  glm::uvec4 ids;                           ///< object, material, first primitive, first patch
};

struct MaterialBlock {
  glm::vec4 base_color;
  glm::vec4 emissive;     ///< w: alpha cutoff
  glm::vec4 factors;      ///< metallic, roughness, normal scale, occlusion strength
  glm::vec4 reflectance;  ///< x: of a dielectric at normal incidence
  /// Two rows each: uv' = (dot(row0.xyz, (u, v, 1)), dot(row1.xyz, (u, v, 1))); w of the first: the set, 0 or 1.
  std::array<glm::vec4, 2 * kMaterialTextures> uv_rows;
};

struct LightRecord {
  glm::vec4 position;   ///< w: 1 / range^2, 0 without a range
  glm::vec4 direction;  ///< towards which it shines; w: scene::LightType
  glm::vec4 color;      ///< intensity and exposure multiplied in
  glm::vec4 cone;       ///< x, y: scale and offset of the cosine, KHR_lights_punctual
};

/// A point of a face with all that its shading depends on. World space; changes are those from pixel to pixel.
struct FaceSample {
  glm::vec4 position;  ///< w: 1 where the face's back is seen
  glm::vec4 normal;    ///< any length
  glm::vec4 tangent;   ///< w: handedness
  glm::vec4 color;
  glm::vec4 texcoords;  ///< sets 0 and 1
  glm::vec4 position_dx, position_dy;
  glm::vec4 texcoords_dx, texcoords_dy;
};

/// Blocks in one buffer start at multiples of this: the largest alignment that OpenGL lets a driver ask for.
inline constexpr std::size_t kBlockAlignment = 256;
constexpr std::size_t AlignBlock(std::size_t size) {
  return (size + kBlockAlignment - 1) / kBlockAlignment * kBlockAlignment;
}

[[nodiscard]] std::string_view BlockDeclarations();

}  // namespace burin::gbuffer
