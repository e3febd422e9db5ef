// SPDX-License-Identifier: Apache-2.0
#pragma once
// Meshes for tests and benchmarks: made ones, and a small reader of Wavefront files.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace burin::test {

struct TriangleMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals{};    ///< empty or one a position
  std::vector<glm::vec2> texcoords{};  ///< empty or one a position
  std::vector<std::uint32_t> triangles;
};

inline TriangleMesh Icosahedron() {
  const float t = 0.5f * (1.0f + std::sqrt(5.0f));
  TriangleMesh mesh;
  mesh.positions = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                    {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  mesh.triangles = {0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,  11, 10, 2,  10, 7, 6, 7, 1, 8,
                    3, 9,  4, 3, 4, 2, 3, 2, 6, 3, 6, 8,  3, 8,  9,  4, 9, 5, 2, 4,  11, 6,  2,  10, 8,  6, 7, 9, 8, 1};
  for (glm::vec3& p : mesh.positions) p = glm::normalize(p);
  return mesh;
}

/// A vertex between the ends of every edge, four triangles for one. `middle`: the new position from the two ends and
/// the vertices opposite (kNoVertex at a boundary), all as indices.
inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFFu;

template <class Middle>
TriangleMesh SplitEdges(const TriangleMesh& mesh, const Middle& middle) {
  struct Side {
    std::uint32_t opposite[2] = {kNoVertex, kNoVertex};
    std::uint32_t vertex = kNoVertex;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Side> sides;
  const auto key = [](std::uint32_t a, std::uint32_t b) { return std::pair(std::min(a, b), std::max(a, b)); };
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      Side& side = sides[key(mesh.triangles[t + k], mesh.triangles[t + (k + 1) % 3])];
      side.opposite[side.opposite[0] == kNoVertex ? 0 : 1] = mesh.triangles[t + (k + 2) % 3];
    }
  }
  TriangleMesh split;
  split.positions = mesh.positions;
  for (auto& [ends, side] : sides) {
    side.vertex = static_cast<std::uint32_t>(split.positions.size());
    split.positions.push_back(middle(ends.first, ends.second, side.opposite[0], side.opposite[1]));
  }
  split.triangles.reserve(mesh.triangles.size() * 4);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const std::uint32_t a = mesh.triangles[t], b = mesh.triangles[t + 1], c = mesh.triangles[t + 2];
    const std::uint32_t ab = sides[key(a, b)].vertex, bc = sides[key(b, c)].vertex, ca = sides[key(c, a)].vertex;
    const std::uint32_t four[] = {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca};
    split.triangles.insert(split.triangles.end(), std::begin(four), std::end(four));
  }
  return split;
}

/// A unit sphere of 20 * 4^levels triangles.
inline TriangleMesh Icosphere(int levels) {
  TriangleMesh mesh = Icosahedron();
  for (int i = 0; i < levels; ++i)
    mesh = SplitEdges(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t, std::uint32_t) {
      return glm::normalize(mesh.positions[a] + mesh.positions[b]);
    });
  return mesh;
}

/// One step of Loop's subdivision (1987) for closed meshes whose neighbours share vertices: four triangles for one.
inline TriangleMesh LoopSubdivided(const TriangleMesh& mesh) {
  TriangleMesh fine = SplitEdges(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    const auto& p = mesh.positions;
    if (d == kNoVertex) return 0.5f * (p[a] + p[b]);
    return 0.375f * (p[a] + p[b]) + 0.125f * (p[c] + p[d]);
  });
  // In a closed mesh every neighbour is met once on either side, so halves add up to the sum of all neighbours.
  std::vector<glm::vec3> sums(mesh.positions.size(), glm::vec3(0));
  std::vector<float> valences(mesh.positions.size(), 0.0f);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t + k], b = mesh.triangles[t + (k + 1) % 3];
      sums[a] += 0.5f * mesh.positions[b];
      sums[b] += 0.5f * mesh.positions[a];
      valences[a] += 0.5f;
      valences[b] += 0.5f;
    }
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const float n = valences[v];
    if (n == 0.0f) continue;
    const float c = 0.375f + 0.25f * std::cos(6.2831853f / n);
    const float beta = (0.625f - c * c) / n;
    fine.positions[v] = (1.0f - n * beta) * mesh.positions[v] + beta * sums[v];
  }
  return fine;
}

/// A closed tube of rings: rings * sides * 2 triangles.
inline TriangleMesh Torus(int rings, int sides, float radius = 1.0f, float thickness = 0.35f) {
  TriangleMesh mesh;
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < sides; ++s) {
      const float u = 6.2831853f * static_cast<float>(r) / static_cast<float>(rings);
      const float v = 6.2831853f * static_cast<float>(s) / static_cast<float>(sides);
      const float distance = radius + thickness * std::cos(v);
      mesh.positions.emplace_back(distance * std::cos(u), distance * std::sin(u), thickness * std::sin(v));
      const auto at = [&](int i, int j) { return static_cast<std::uint32_t>((i % rings) * sides + j % sides); };
      const std::uint32_t quad[] = {at(r, s), at(r + 1, s), at(r + 1, s + 1), at(r, s), at(r + 1, s + 1), at(r, s + 1)};
      mesh.triangles.insert(mesh.triangles.end(), std::begin(quad), std::end(quad));
    }
  }
  return mesh;
}

/// The cube of side 2 about 0, its faces with vertices and normals of their own.
inline TriangleMesh Cube() {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0f, 1.0f}) {
      glm::vec3 n(0), u(0), v(0);
      n[axis] = sign;
      u[(axis + 1) % 3] = 1;
      v[(axis + 2) % 3] = sign;
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const glm::vec3& p : {n - u - v, n + u - v, n + u + v, n - u + v}) {
        mesh.positions.push_back(p);
        mesh.normals.push_back(n);
      }
      for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.triangles.push_back(first + k);
    }
  }
  return mesh;
}

inline void Append(const TriangleMesh& other, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const std::uint32_t v : other.triangles) mesh.triangles.push_back(first + v);
}

/// Moves every vertex by up to `amount` in each coordinate.
inline void Perturb(float amount, std::mt19937& random, TriangleMesh& mesh) {
  std::uniform_real_distribution<float> offset(-amount, amount);
  for (glm::vec3& p : mesh.positions) {
    p.x += offset(random);
    p.y += offset(random);
    p.z += offset(random);
  }
}

/// Area-weighted vertex normals.
inline void SmoothNormals(TriangleMesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0));
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const glm::vec3 a = mesh.positions[mesh.triangles[t]], b = mesh.positions[mesh.triangles[t + 1]],
                    c = mesh.positions[mesh.triangles[t + 2]];
    for (std::size_t k = 0; k < 3; ++k) mesh.normals[mesh.triangles[t + k]] += glm::cross(b - a, c - a);
  }
  for (glm::vec3& n : mesh.normals) n = glm::dot(n, n) > 0.0f ? glm::normalize(n) : n;
}

/// Polygons of a Wavefront file as fans of triangles over its positions alone; nothing if it can't be read.
inline std::optional<TriangleMesh> ReadObjPositions(const std::string& path) {
  std::ifstream file(path);
  if (!file) return std::nullopt;
  TriangleMesh mesh;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      glm::vec3 p;
      if (words >> p.x >> p.y >> p.z) mesh.positions.push_back(p);
    } else if (word == "f") {
      std::vector<std::uint32_t> corners;
      while (words >> word) corners.push_back(static_cast<std::uint32_t>(std::stoul(word)) - 1);
      for (std::size_t k = 2; k < corners.size(); ++k)
        mesh.triangles.insert(mesh.triangles.end(), {corners[0], corners[k - 1], corners[k]});
    }
  }
  return mesh;
}

}  // namespace burin::test
