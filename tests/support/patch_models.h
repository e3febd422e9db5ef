// SPDX-License-Identifier: Apache-2.0
#pragma once
// Closed models of patches for tests.

#include <glm/geometric.hpp>
#include <memory>
#include <utility>

#include "core/geometry/catmull_clark.h"
#include "core/scene/scene.h"

namespace burin::test {

/// A pot with a handle: a box with a hole through its side, rounded by subdivision. Genus 1, irregular vertices.
inline geometry::SubdivisionCage PotCage() {
  geometry::SubdivisionCage cage;
  // A 3 x 3 x 1 block of cells without its middle one.
  const auto vertex = [](int x, int y, int z) { return static_cast<std::uint32_t>(x + 4 * y + 16 * z); };
  for (int z = 0; z < 2; ++z) {
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 4; ++x)
        cage.positions.emplace_back(static_cast<float>(x) - 1.5f, static_cast<float>(y) - 1.5f,
                                    1.4f * (static_cast<float>(z) - 0.5f));
    }
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    cage.corners.insert(cage.corners.end(), {a, b, c, d});
    cage.face_sizes.push_back(4);
  };
  const auto is_solid = [](int x, int y) { return x >= 0 && x < 3 && y >= 0 && y < 3 && !(x == 1 && y == 1); };
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      if (!is_solid(x, y)) continue;
      quad(vertex(x, y, 1), vertex(x + 1, y, 1), vertex(x + 1, y + 1, 1), vertex(x, y + 1, 1));
      quad(vertex(x, y, 0), vertex(x, y + 1, 0), vertex(x + 1, y + 1, 0), vertex(x + 1, y, 0));
      if (!is_solid(x - 1, y)) quad(vertex(x, y, 0), vertex(x, y, 1), vertex(x, y + 1, 1), vertex(x, y + 1, 0));
      if (!is_solid(x + 1, y)) {
        quad(vertex(x + 1, y, 0), vertex(x + 1, y + 1, 0), vertex(x + 1, y + 1, 1), vertex(x + 1, y, 1));
      }
      if (!is_solid(x, y - 1)) quad(vertex(x, y, 0), vertex(x + 1, y, 0), vertex(x + 1, y, 1), vertex(x, y, 1));
      if (!is_solid(x, y + 1)) {
        quad(vertex(x, y + 1, 0), vertex(x, y + 1, 1), vertex(x + 1, y + 1, 1), vertex(x + 1, y + 1, 0));
      }
    }
  }
  return cage;
}

inline scene::Primitive Pot() {
  auto patches = geometry::MakeCatmullClarkPatches(PotCage());
  scene::Primitive primitive;
  primitive.patches = std::make_shared<const geometry::BezierPatches>(std::move(patches->front()));
  return primitive;
}

}  // namespace burin::test
