// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a tessellated surface must keep, told from its positions by their bits alone.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

namespace burin::test {

using PositionBits = std::array<std::uint32_t, 3>;

struct PositionBitsHash {
  std::size_t operator()(const PositionBits& bits) const {
    std::uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const std::uint32_t word : bits) hash = (hash ^ word) * 0xff51afd7ed558ccdu, hash ^= hash >> 32;
    return hash;
  }
};

inline PositionBits BitsOf(const glm::vec3& position) {
  return {std::bit_cast<std::uint32_t>(position.x), std::bit_cast<std::uint32_t>(position.y),
          std::bit_cast<std::uint32_t>(position.z)};
}

/// A number for each distinct position.
inline std::vector<std::uint32_t> WeldByBits(std::span<const glm::vec3> positions) {
  std::unordered_map<PositionBits, std::uint32_t, PositionBitsHash> places;
  places.reserve(positions.size());
  std::vector<std::uint32_t> welded;
  welded.reserve(positions.size());
  for (const glm::vec3& position : positions)
    welded.push_back(places.try_emplace(BitsOf(position), static_cast<std::uint32_t>(places.size())).first->second);
  return welded;
}

/// Directed edges between distinct positions, and how often each direction of an edge is used.
struct EdgeUse {
  std::size_t inner = 0;      ///< used once in each direction
  std::size_t boundary = 0;   ///< used once in one direction
  std::size_t faulty = 0;     ///< anything else
  std::size_t collapsed = 0;  ///< triangles with two corners at one position
};

inline EdgeUse CountEdgeUse(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> welded) {
  EdgeUse use;
  std::unordered_map<std::uint64_t, std::array<std::uint8_t, 2>> edges;
  edges.reserve(indices.size());
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    bool is_collapsed = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t a = welded[indices[i + k]], b = welded[indices[i + (k + 1) % 3]];
      is_collapsed |= a == b;
      if (a != b) ++edges[a < b ? a << 32 | b : b << 32 | a][a < b ? 0 : 1];
    }
    use.collapsed += is_collapsed ? 1 : 0;
  }
  for (const auto& [edge, count] : edges) {
    if (count[0] == 1 && count[1] == 1) {
      ++use.inner;
    } else if (count[0] + count[1] == 1) {
      ++use.boundary;
    } else {
      ++use.faulty;
    }
  }
  return use;
}

}  // namespace burin::test
