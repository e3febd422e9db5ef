// SPDX-License-Identifier: Apache-2.0
#pragma once
// Random networks of Bézier patches that share sides in every way there is, and the .bpt files of the shared data.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/geometry/bezier_patches.h"

namespace burin::test {

using geometry::BezierPatch;
using geometry::BezierPatches;
using geometry::ControlNet;
using geometry::PatchDomain;

/// Adds a quad whose control points are at(i, j), i along u.
inline void AddQuad(BezierPatches& patches, int u_order, int v_order, const std::function<glm::vec4(int, int)>& at,
                    bool is_rational = false) {
  BezierPatch patch;
  patch.is_rational = is_rational;
  patch.position = {static_cast<std::uint32_t>(patches.positions.size()), static_cast<std::uint8_t>(u_order),
                    static_cast<std::uint8_t>(v_order)};
  patch.face = static_cast<std::uint32_t>(patches.patches.size());
  for (int j = 0; j < v_order; ++j) {
    for (int i = 0; i < u_order; ++i) patches.positions.push_back(at(i, j));
  }
  patches.patches.push_back(patch);
}

/// Adds a triangle whose control points are at(i, j), i along u, i + j < order.
inline void AddTriangle(BezierPatches& patches, int order, const std::function<glm::vec4(int, int)>& at,
                        bool is_rational = false) {
  BezierPatch patch;
  patch.domain = PatchDomain::kTriangle;
  patch.is_rational = is_rational;
  patch.position = {static_cast<std::uint32_t>(patches.positions.size()), static_cast<std::uint8_t>(order),
                    static_cast<std::uint8_t>(order)};
  patch.face = static_cast<std::uint32_t>(patches.patches.size());
  for (int j = 0; j < order; ++j) {
    for (int i = 0; i + j < order; ++i) patches.positions.push_back(at(i, j));
  }
  patches.patches.push_back(patch);
}

/// Patches of a .bpt file: their count, then for each its degrees along u and v and its points row by row.
inline std::optional<BezierPatches> ReadBpt(const std::string& path) {
  std::ifstream file(path);
  std::size_t count = 0;
  if (!(file >> count)) return std::nullopt;
  BezierPatches patches;
  for (std::size_t p = 0; p < count; ++p) {
    int u = 0, v = 0;
    if (!(file >> u >> v)) return std::nullopt;
    AddQuad(patches, v + 1, u + 1, [&](int, int) {
      glm::vec4 point(0.0f, 0.0f, 0.0f, 1.0f);
      file >> point.x >> point.y >> point.z;
      return point;
    });
  }
  if (!file) return std::nullopt;
  return patches;
}

/// A file of the shared data.
inline std::string SharedData(const std::string& name) {
  if (const char* data = std::getenv("BURIN_SHARED_DATA"); data != nullptr) return std::string(data) + "/" + name;
  const char* source = std::getenv("BURIN_SOURCE_DIR");
  return std::string(source != nullptr ? source : ".") + "/../shared/data/" + name;
}

}  // namespace burin::test
