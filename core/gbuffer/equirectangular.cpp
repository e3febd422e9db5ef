// SPDX-License-Identifier: Apache-2.0
// Faces are looked up as in the OpenGL specification, section 8.13, table 8.19 (right, left, top, bottom, front, back
// for +x, -x, +y, -y, +z, -z), where z points away from the viewer.
#include "core/gbuffer/equirectangular.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace burin::gbuffer {
namespace {

struct FacePoint {
  std::size_t face;
  float s, t;  ///< 0 to 1, t downwards
};

FacePoint FacePointOf(const glm::vec3& d) {
  const glm::vec3 a(std::abs(d.x), std::abs(d.y), std::abs(d.z));
  const auto at = [](std::size_t face, float s, float t, float major) {
    return FacePoint{face, 0.5f * (s / major + 1.0f), 0.5f * (t / major + 1.0f)};
  };
  if (a.x >= a.y && a.x >= a.z) return d.x > 0.0f ? at(0, -d.z, -d.y, a.x) : at(1, d.z, -d.y, a.x);
  if (a.y >= a.z) return d.y > 0.0f ? at(2, d.x, d.z, a.y) : at(3, d.x, -d.z, a.y);
  return d.z > 0.0f ? at(4, d.x, -d.y, a.z) : at(5, -d.x, -d.y, a.z);
}

/// Bilinear within one face of `size` texels.
glm::vec3 Sample(const EnvironmentMap& faces, const image::CubeGrid& grid, int size, FacePoint point) {
  const image::FacePlace& place = grid.faces[point.face];
  if (place.is_turned) {
    point.s = 1.0f - point.s;
    point.t = 1.0f - point.t;
  }
  const auto most = static_cast<float>(size - 1);
  const float x = std::clamp(point.s * static_cast<float>(size) - 0.5f, 0.0f, most);
  const float y = std::clamp(point.t * static_cast<float>(size) - 0.5f, 0.0f, most);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, size - 1), y1 = std::min(y0 + 1, size - 1);
  const auto texel = [&](int column, int row) {
    return faces.pixels[static_cast<std::size_t>(place.row * size + row) * static_cast<std::size_t>(faces.width) +
                        static_cast<std::size_t>(place.column * size + column)];
  };
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  const glm::vec3 top = texel(x0, y0) * (1.0f - fx) + texel(x1, y0) * fx;
  const glm::vec3 bottom = texel(x0, y1) * (1.0f - fx) + texel(x1, y1) * fx;
  return top * (1.0f - fy) + bottom * fy;
}

}  // namespace

EnvironmentMap EquirectangularOf(const EnvironmentMap& faces, image::CubeLayout layout) {
  constexpr float kPi = glm::pi<float>();
  const image::CubeGrid& grid = image::GridOf(layout);
  const int size = faces.width / grid.columns;
  EnvironmentMap map{.width = 4 * size, .height = 2 * size, .pixels = {}};
  map.pixels.reserve(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  for (int y = 0; y < map.height; ++y) {
    const float latitude = kPi * (0.5f - (static_cast<float>(y) + 0.5f) / static_cast<float>(map.height));
    for (int x = 0; x < map.width; ++x) {
      const float longitude = 2.0f * kPi * ((static_cast<float>(x) + 0.5f) / static_cast<float>(map.width) - 0.5f);
      // The front, -z in the scene, is +z here.
      const glm::vec3 direction(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                std::cos(latitude) * std::cos(longitude));
      map.pixels.push_back(Sample(faces, grid, size, FacePointOf(direction)));
    }
  }
  return map;
}

}  // namespace burin::gbuffer
