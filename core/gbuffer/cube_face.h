// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

namespace burin::gbuffer {

/// Through a point of a cube map's face: OpenGL 4.5 core, table 8.19, solved for the direction. Faces are +x -x +y -y
/// +z -z; s and t -1 to 1, t downwards. Not unit.
template <class Number>
[[nodiscard]] glm::vec<3, Number> CubeFaceDirection(int face, Number s, Number t) {
  const Number one(1);
  switch (face) {
    case 0:
      return {one, -t, -s};
    case 1:
      return {-one, -t, s};
    case 2:
      return {s, one, t};
    case 3:
      return {s, -one, -t};
    case 4:
      return {s, -t, one};
    default:
      return {-s, -t, -one};
  }
}

}  // namespace burin::gbuffer
