// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the translucency shaders read, byte for byte: std140 uniform blocks. BodyDeclarations() is the GLSL of the same.
//
// A body is what light scatters through: the translucent surfaces of one object. Its bounding box has six faces, each
// an orthographic picture of the surfaces that look its way, side by side in one texture. Faces count +x -x +y -y +z
// -z; the picture of axis a has u along axis a + 1 and v along axis a + 2 (modulo 3), whichever its side, and depth 0
// on the face, 1 on the opposite one. "Unit" positions run from 0 to 1 in the box.

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <string>

#include "core/translucency/sh_light.h"

namespace burin::translucency {

enum UniformBinding : unsigned { kBodyBinding = 3, kShadowBinding = 4 };
enum StorageBinding : unsigned { kWantedBinding = 2 };  ///< beyond those of core/gbuffer

/// Texture units beyond those of core/gbuffer.
enum TextureUnit : unsigned {
  kReceiverUnit = 7,  ///< radiosity of the faces' texels, and depth
  kLocalUnit = 8,     ///< of it what entered nearby
  kSourceUnit = 9,    ///< the pyramid
  kShadowUnit = 10,
  kFaceDepthUnit = 11,
  kDipoleUnit = 12,
  kFaceDeepestUnit = 13,
};

/// The pyramid's highest level has 4 x 4 texels a face; two levels above it one stands for the whole face.
inline constexpr int kWholeAboveTop = 2;

inline constexpr int kMaxShadowMaps = 48;
inline constexpr int kMaxShadowedLights = 32;

struct BodyBlock {
  glm::vec4 box_min;      ///< world; w: millimetres a scene unit
  glm::vec4 box_mm;       ///< extents
  glm::ivec4 texels;      ///< of a face along x, y and z; w: those between two faces' origins
  glm::ivec4 levels;      ///< lowest and highest of the pyramid; log2 of source texels a receiver; lights
  glm::vec4 real_mm;      ///< z_r; w: eta
  glm::vec4 virtual_mm;   ///< z_v; w: largest irradiance, by which sources are divided
  glm::vec4 sigma_tr;     ///< 1/mm
  glm::vec4 strength;     ///< alpha' / (4 pi)
  glm::vec4 reflectance;  ///< of a plane, all in all
  std::array<glm::vec4, kShTerms> environment;  ///< FoldIrradiance
};

struct ShadowBlock {
  std::array<glm::mat4, kMaxShadowMaps> clip_from_world;
  std::array<glm::vec4, kMaxShadowMaps> texel;          ///< world size of a texel: x + y * depth
  std::array<glm::ivec4, kMaxShadowedLights> of_light;  ///< first map, number of maps: 0, 1 or 6
};

[[nodiscard]] std::string BodyDeclarations();

}  // namespace burin::translucency
