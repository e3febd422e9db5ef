// SPDX-License-Identifier: Apache-2.0
#pragma once
// Random networks of Bézier patches that share sides in every way there is, and the .bpt files of the shared data.

#include <array>
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

/// A random network: cells of a grid, each a quad or two triangles, with curved sides that neighbours share and insides
/// of their own. Every patch is turned at random, so that sides meet reversed and u against v.
struct NetworkShape {
  int columns = 2, rows = 2;
  bool wraps_columns = false, wraps_rows = false;
  bool is_moebius = false;  ///< wraps columns upside down
  bool has_pole = false;    ///< all corners and sides of the first row of corners are one point; not with wraps_rows
  int order = 4;
  bool is_rational = false;
  double triangle_share = 0.5;
};

struct Network {
  BezierPatches patches;
  std::vector<std::array<float, 6>> factors;  ///< a patch, equal on shared sides; none inside
  std::size_t boundary_sides = 0;             ///< that only one patch has
  std::vector<float> boundary_factors;        ///< of those
};

class NetworkBuilder {
 public:
  NetworkBuilder(const NetworkShape& shape, std::mt19937& random, std::function<float()> factor)
      : shape_(shape), random_(random), factor_(std::move(factor)) {}

  Network Build() {
    for (int y = 0; y < shape_.rows; ++y) {
      for (int x = 0; x < shape_.columns; ++x) AddCell(x, y);
    }
    for (const auto& [key, side] : sides_) {
      if (side.uses == 1 && !IsPole(key)) {
        ++network_.boundary_sides;
        network_.boundary_factors.push_back(side.factor);
      }
    }
    return std::move(network_);
  }

 private:
  using Corner = std::array<int, 2>;
  using SideKey = std::array<int, 5>;  ///< both corners, lower first, and which of the sides between them
  struct SideCurve {
    std::vector<glm::vec4> points;  ///< from the lower corner on
    float factor = 1.0f;
    int uses = 0;
  };
  /// One side as a patch runs along it.
  struct Run {
    SideKey key;
    bool is_reversed;
  };

  /// The corner's name: one for every way to reach it.
  [[nodiscard]] Corner Name(int x, int y) const {
    if (shape_.is_moebius && x == shape_.columns) return Name(0, shape_.rows - y);
    if (shape_.wraps_columns) x %= shape_.columns;
    if (shape_.wraps_rows) y %= shape_.rows;
    if (shape_.has_pole && y == 0) x = 0;
    return {x, y};
  }
  [[nodiscard]] bool IsPole(const SideKey& key) const { return shape_.has_pole && key[1] == 0 && key[3] == 0; }

  glm::vec4 RandomPoint() {
    std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f), weight(0.5f, 2.0f);
    glm::vec4 point(coordinate(random_), coordinate(random_), coordinate(random_), 1.0f);
    if (random_() % 16 == 0) point.x = random_() % 2 == 0 ? 0.0f : -0.0f;
    return shape_.is_rational ? point * weight(random_) : point;
  }
  const glm::vec4& CornerPoint(const Corner& corner) {
    const auto [at, is_new] = corners_.try_emplace(corner);
    if (is_new) at->second = RandomPoint();
    return at->second;
  }
  /// `which` tells sides apart that join the same corners, as happens in narrow rings.
  Run SideBetween(const Corner& a, const Corner& b, int which) {
    const bool is_reversed = b < a;
    const Corner &low = is_reversed ? b : a, &high = is_reversed ? a : b;
    const SideKey key{low[0], low[1], high[0], high[1], which};
    auto [at, is_new] = sides_.try_emplace(key);
    SideCurve& side = at->second;
    if (is_new) {
      side.factor = factor_();
      for (int k = 0; k < shape_.order; ++k) {
        const bool is_end = k == 0 || k == shape_.order - 1;
        side.points.push_back(IsPole(key) ? CornerPoint(low)
                              : is_end    ? CornerPoint(k == 0 ? low : high)
                                          : RandomPoint());
      }
    }
    ++side.uses;
    return {key, is_reversed};
  }
  [[nodiscard]] glm::vec4 PointOn(const Run& run, int k) const {
    return sides_.at(run.key).points[static_cast<std::size_t>(run.is_reversed ? shape_.order - 1 - k : k)];
  }
  [[nodiscard]] static Run Reversed(const Run& run) { return {run.key, !run.is_reversed}; }

  void AddCell(int x, int y) {
    const Corner a = Name(x, y), b = Name(x + 1, y), c = Name(x, y + 1), d = Name(x + 1, y + 1);
    const bool at_seam = shape_.is_moebius && x + 1 == shape_.columns;
    // Sides along u carry their row, sides along v their column, so that two between the same corners are two.
    const int column = x + 1 == shape_.columns && (shape_.wraps_columns || at_seam) ? 0 : x + 1;
    const int row = shape_.wraps_rows ? (y + 1) % shape_.rows : y + 1;
    const Run bottom = SideBetween(a, b, 1000 + 100 * y + x), top = SideBetween(c, d, 1000 + 100 * row + x);
    const int height = at_seam ? shape_.rows - 1 - y : y;
    const Run left = SideBetween(a, c, 100 * x + y), right = SideBetween(b, d, 100 * column + height);
    if (std::uniform_real_distribution<>()(random_) < shape_.triangle_share) {
      const Run diagonal = SideBetween(b, c, 5000 + 100 * x + y);
      AddTurnedTriangle(bottom, diagonal, Reversed(left));
      ++sides_.at(diagonal.key).uses;
      AddTurnedTriangle(right, Reversed(top), Reversed(diagonal));
    } else {
      AddTurnedQuad(bottom, top, left, right);
    }
  }

  /// Turned by a multiple of 90 degrees: sides bottom, top, left, right of the new patch.
  void AddTurnedQuad(Run bottom, Run top, Run left, Run right) {
    for (auto turns = random_() % 4; turns > 0; --turns) {
      const Run was_bottom = bottom;
      bottom = right;
      right = Reversed(top);
      top = left;
      left = Reversed(was_bottom);
    }
    const int last = shape_.order - 1;
    AddQuad(
        network_.patches, shape_.order, shape_.order,
        [&](int i, int j) {
          if (j == 0) return PointOn(bottom, i);
          if (j == last) return PointOn(top, i);
          if (i == 0) return PointOn(left, j);
          return i == last ? PointOn(right, j) : RandomPoint();
        },
        shape_.is_rational);
    network_.factors.push_back({Factor(bottom), Factor(top), Factor(left), Factor(right)});
  }

  void AddTurnedTriangle(Run first, Run second, Run third) {
    for (auto turns = random_() % 3; turns > 0; --turns) {
      const Run was_first = first;
      first = second;
      second = third;
      third = was_first;
    }
    const int last = shape_.order - 1;
    AddTriangle(
        network_.patches, shape_.order,
        [&](int i, int j) {
          if (j == 0) return PointOn(first, i);
          if (i + j == last) return PointOn(second, j);
          return i == 0 ? PointOn(third, last - j) : RandomPoint();
        },
        shape_.is_rational);
    network_.factors.push_back({Factor(first), Factor(second), Factor(third), 1.0f});
  }
  [[nodiscard]] float Factor(const Run& run) const { return sides_.at(run.key).factor; }

  NetworkShape shape_;
  std::mt19937& random_;
  std::function<float()> factor_;
  Network network_;
  std::map<Corner, glm::vec4> corners_;
  std::map<SideKey, SideCurve> sides_;
};

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
