// SPDX-License-Identifier: Apache-2.0
#pragma once
// Light from all around, as the shading wants it: irradiance in spherical harmonics, reflections prefiltered by
// roughness. Arrays in, arrays out; no GL.
//
// An equirectangular map's centre lies at -z, where a camera without rotation looks; x grows to the right, the top is
// +y.

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "core/base/error.h"
#include "core/image/image.h"

namespace burin::gbuffer {

/// Radiance, equirectangular, rows top first; scene-linear RGB, finite and not negative.
struct EnvironmentMap {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;
};

/// Any image, equirectangular or, by its proportions, the faces of a cube (image::CubeLayoutOf): display-encoded ones
/// are decoded, NaNs become 0, infinities the largest half. Errors: kInput when empty.
[[nodiscard]] Result<EnvironmentMap> EnvironmentFromImage(const image::Image& image);

/// The built-in one: a grey studio with a soft key light from above left in front, a rim light behind, a darker floor.
[[nodiscard]] EnvironmentMap StudioEnvironment();
/// Towards the studio's key light, unit.
[[nodiscard]] glm::vec3 StudioKeyDirection();

/// Bilinear; `direction` need not be unit but not zero.
[[nodiscard]] glm::vec3 SampleEnvironment(const EnvironmentMap& map, const glm::vec3& direction);

/// Coefficients of irradiance / pi: the sum of sh[i] * Y_i(n) is what a white diffuse surface of normal n gives off.
[[nodiscard]] std::array<glm::vec3, 9> ProjectIrradiance(const EnvironmentMap& map);

/// A cube map, faces in GL's order (+x -x +y -y +z -z), rows as GL has them; level i is for the perceptual roughness
/// i / (levels - 1) and has size face_size >> i.
struct ReflectionMap {
  int face_size = 0;
  std::vector<std::vector<glm::vec3>> levels;  ///< each: 6 faces of size * size
};
[[nodiscard]] ReflectionMap FilterReflections(const EnvironmentMap& map, int face_size);

}  // namespace burin::gbuffer
