// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/weld.h"

#include <array>
#include <bit>
#include <cstddef>

namespace burin::geometry {
namespace {

constexpr std::uint32_t kFree = 0xFFFFFFFFu;

using PositionBits = std::array<std::uint32_t, 3>;

PositionBits BitsOf(const glm::vec3& p) {
  // Adding +0 turns -0 into +0 and leaves every other number as it is.
  return {std::bit_cast<std::uint32_t>(p.x + 0.0f), std::bit_cast<std::uint32_t>(p.y + 0.0f),
          std::bit_cast<std::uint32_t>(p.z + 0.0f)};
}

/// A multiply-and-shift mix (the finaliser of MurmurHash3) over the three words: grids of positions, whose low bits are
/// all zero, spread as well as random ones.
std::size_t Hash(const PositionBits& bits) {
  std::uint64_t h = (std::uint64_t{bits[0]} << 32 | bits[1]) * 0x9E3779B97F4A7C15u ^ bits[2];
  h = (h ^ (h >> 33)) * 0xFF51AFD7ED558CCDu;
  h = (h ^ (h >> 33)) * 0xC4CEB9FE1A85EC53u;
  return static_cast<std::size_t>(h ^ (h >> 33));
}

}  // namespace

std::vector<std::uint32_t> WeldPositions(std::span<const glm::vec3> positions) {
  std::vector<std::uint32_t> welded(positions.size());
  const std::size_t slots = std::bit_ceil(positions.size() * 2 + 1);
  std::vector<std::uint32_t> first_at(slots, kFree);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const PositionBits bits = BitsOf(positions[i]);
    std::size_t slot = Hash(bits) & (slots - 1);
    while (first_at[slot] != kFree && BitsOf(positions[first_at[slot]]) != bits) slot = (slot + 1) & (slots - 1);
    if (first_at[slot] == kFree) first_at[slot] = static_cast<std::uint32_t>(i);
    welded[i] = first_at[slot];
  }
  return welded;
}

}  // namespace burin::geometry
