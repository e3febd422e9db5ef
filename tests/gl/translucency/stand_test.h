// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/gl/gl/context_fixture.h"
#include "tests/support/scattering_stand.h"

namespace burin::translucency {

class TranslucencyTest : public gl::ContextTest {
 protected:
  static Lighting Lamp(const glm::dvec3& at) {
    Lighting lighting;
    lighting.lamp = at;
    return lighting;
  }
  static Lighting Sky(const std::function<glm::dvec3(const glm::dvec3&)>& radiance) {
    Lighting lighting;
    lighting.sky = radiance;
    return lighting;
  }

  /// Against the reference, at a few points of four views.
  static Deviation Measure(const Surface& surface, const char* medium_name, const Lighting& lighting,
                           Scattering scattering, std::size_t piece_count = 15000) {
    const Medium medium = *FindMeasuredMedium(medium_name);
    const double ior = static_cast<double>(medium.ior);
    const Occlusion occlusion(surface);
    const Entering entering =
        lighting.lamp ? PointLight(*lighting.lamp, lighting.intensity, ior, occlusion) : Environment(lighting.sky, ior);
    const Pieces pieces(surface, piece_count, entering);
    Stand stand(surface, medium, lighting, scattering);
    return Compare(stand, pieces, medium, 120, {{30, 35, 70}, {-40, -30, 65}, {45, -25, -66}, {-50, 40, -50}}, 96);
  }
};

/// Two balls that hide each other from two faces of their box, and inner sides that look at each other.
inline Surface TwoBalls() {
  Surface two = Ball(7.5, 48);
  const Surface other = two;
  const auto first = static_cast<std::uint32_t>(two.positions.size());
  for (glm::dvec3& p : two.positions) p.x -= 7.0;
  for (const glm::dvec3& p : other.positions) two.positions.push_back(p + glm::dvec3(7.0, 0.0, 0.0));
  two.normals.insert(two.normals.end(), other.normals.begin(), other.normals.end());
  for (const std::uint32_t i : other.indices) two.indices.push_back(first + i);
  return two;
}

}  // namespace burin::translucency
