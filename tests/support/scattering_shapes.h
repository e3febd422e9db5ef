// SPDX-License-Identifier: Apache-2.0
#pragma once
// Closed surfaces of 30 mm, in millimetres.

#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "core/scene/scene.h"
#include "tests/support/scattering_reference.h"

namespace burin::translucency {

inline Surface Ball(double radius, int slices) {
  Surface ball;
  const int stacks = slices / 2;
  for (int i = 0; i <= stacks; ++i) {
    const double polar = glm::pi<double>() * i / stacks;
    for (int j = 0; j <= slices; ++j) {
      const double around = 2.0 * glm::pi<double>() * j / slices;
      ball.normals.emplace_back(std::sin(polar) * std::cos(around), std::cos(polar),
                                std::sin(polar) * std::sin(around));
      ball.positions.push_back(radius * ball.normals.back());
    }
  }
  for (int i = 0; i < stacks; ++i) {
    for (int j = 0; j < slices; ++j) {
      const auto a = static_cast<std::uint32_t>(i * (slices + 1) + j);
      const auto b = a + static_cast<std::uint32_t>(slices) + 1;
      ball.indices.insert(ball.indices.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  }
  return ball;
}

/// A block about the origin, its sides in n x n squares.
inline Surface Block(const glm::dvec3& size, int n) {
  Surface block;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      glm::dvec3 normal(0.0), u(0.0), v(0.0);
      normal[axis] = side;
      u[(axis + 1) % 3] = 1.0;
      v[(axis + 2) % 3] = side;
      const auto first = static_cast<std::uint32_t>(block.positions.size());
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          const glm::dvec3 p = normal + (2.0 * i / n - 1.0) * u + (2.0 * j / n - 1.0) * v;
          block.positions.push_back(0.5 * size * p);
          block.normals.push_back(normal);
        }
      }
      const auto row = static_cast<std::uint32_t>(n) + 1;
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i) {
        for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(n); ++j) {
          const std::uint32_t a = first + i * row + j;
          block.indices.insert(block.indices.end(), {a, a + row, a + 1, a + 1, a + row, a + row + 1});
        }
      }
    }
  }
  return block;
}

/// Its largest extent becomes `size`, its middle the origin.
inline void Fit(Surface& surface, double size) {
  glm::dvec3 low(1e300), high(-1e300);
  for (const glm::dvec3& p : surface.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::dvec3 extent = high - low;
  const double scale = size / std::max({extent.x, extent.y, extent.z});
  for (glm::dvec3& p : surface.positions) p = (p - 0.5 * (low + high)) * scale;
}

/// Smooth normals, weighted by area, over corners in one place.
inline void Smooth(Surface& surface) {
  surface.normals.assign(surface.positions.size(), glm::dvec3(0.0));
  std::map<std::array<double, 3>, glm::dvec3> sums;
  const auto key = [](const glm::dvec3& p) { return std::array<double, 3>{p.x, p.y, p.z}; };
  for (std::size_t t = 0; t < surface.triangles(); ++t) {
    const glm::dvec3 n =
        glm::cross(surface.corner(t, 1) - surface.corner(t, 0), surface.corner(t, 2) - surface.corner(t, 0));
    for (int i = 0; i < 3; ++i) sums.try_emplace(key(surface.corner(t, i)), glm::dvec3(0.0)).first->second += n;
  }
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    const glm::dvec3 sum = sums[key(surface.positions[i])];
    surface.normals[i] = glm::dot(sum, sum) > 0.0 ? glm::normalize(sum) : glm::dvec3(0.0, 1.0, 0.0);
  }
}

/// Positions and faces of a Wavefront file, 30 mm large and smooth; empty when it can't be read.
inline Surface ReadObj(const std::string& path) {
  Surface surface;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      glm::dvec3 p(0.0);
      words >> p.x >> p.y >> p.z;
      surface.positions.push_back(p);
    } else if (kind == "f") {
      std::vector<std::uint32_t> corners;
      for (std::string word; words >> word;) corners.push_back(static_cast<std::uint32_t>(std::stoul(word)) - 1);
      for (std::size_t i = 2; i < corners.size(); ++i) {
        surface.indices.insert(surface.indices.end(), {corners[0], corners[i - 1], corners[i]});
      }
    }
  }
  if (surface.indices.empty()) return {};
  Fit(surface, 30.0);
  Smooth(surface);
  return surface;
}

inline scene::Primitive ToPrimitive(const Surface& surface, int material) {
  scene::Primitive primitive;
  for (const glm::dvec3& p : surface.positions) primitive.positions.emplace_back(p);
  for (const glm::dvec3& n : surface.normals) primitive.normals.emplace_back(n);
  primitive.indices = surface.indices;
  primitive.material = material;
  return primitive;
}

}  // namespace burin::translucency
