// SPDX-License-Identifier: Apache-2.0
#pragma once
// Translucency by brute force, in double precision: every piece of a surface's irradiance times the dipole's planar
// form, added up. Lengths in millimetres.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>
#include <numeric>
#include <vector>

#include "core/translucency/dipole.h"
#include "core/translucency/fresnel.h"

namespace burin::translucency {

/// Triangles with a normal a corner.
struct Surface {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
  std::vector<std::uint32_t> indices;

  [[nodiscard]] std::size_t triangles() const { return indices.size() / 3; }
  [[nodiscard]] const glm::dvec3& corner(std::size_t triangle, int i) const {
    return positions[indices[3 * triangle + static_cast<std::size_t>(i)]];
  }
  [[nodiscard]] const glm::dvec3& normal(std::size_t triangle, int i) const {
    return normals[indices[3 * triangle + static_cast<std::size_t>(i)]];
  }
};

/// Asks whether anything lies between two points: a tree of boxes, halved at the middle triangle.
class Occlusion {
 public:
  explicit Occlusion(const Surface& surface) : surface_(&surface), order_(surface.triangles()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!order_.empty()) Build(0, order_.size());
  }

  [[nodiscard]] bool IsBlocked(const glm::dvec3& from, const glm::dvec3& to) const {
    const glm::dvec3 d = to - from;
    std::vector<std::size_t> stack = {0};
    while (!stack.empty() && !nodes_.empty()) {
      const Node& node = nodes_[stack.back()];
      stack.pop_back();
      if (!MeetsBox(node, from, d)) continue;
      if (node.left != 0) {
        stack.push_back(node.left);
        stack.push_back(node.right);
        continue;
      }
      for (std::size_t i = node.begin; i < node.end; ++i) {
        if (MeetsTriangle(order_[i], from, d)) return true;
      }
    }
    return false;
  }

 private:
  struct Node {
    glm::dvec3 low{1e300}, high{-1e300};
    std::size_t begin = 0, end = 0, left = 0, right = 0;
  };

  std::size_t Build(std::size_t begin, std::size_t end) {
    Node node;
    node.begin = begin;
    node.end = end;
    for (std::size_t i = begin; i < end; ++i) {
      for (int c = 0; c < 3; ++c) {
        node.low = glm::min(node.low, surface_->corner(order_[i], c));
        node.high = glm::max(node.high, surface_->corner(order_[i], c));
      }
    }
    const std::size_t index = nodes_.size();
    nodes_.push_back(node);
    if (end - begin <= 4) return index;
    const glm::dvec3 size = node.high - node.low;
    const int axis = size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t middle = (begin + end) / 2;
    const auto at = [&](std::uint32_t t) {
      return surface_->corner(t, 0)[axis] + surface_->corner(t, 1)[axis] + surface_->corner(t, 2)[axis];
    };
    std::nth_element(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                     order_.begin() + static_cast<std::ptrdiff_t>(middle),
                     order_.begin() + static_cast<std::ptrdiff_t>(end),
                     [&](std::uint32_t a, std::uint32_t b) { return at(a) < at(b); });
    const std::size_t left = Build(begin, middle);
    const std::size_t right = Build(middle, end);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
  }

  static bool MeetsBox(const Node& node, const glm::dvec3& from, const glm::dvec3& d) {
    double first = 0.0;
    double last = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double inverse = 1.0 / (d[axis] != 0.0 ? d[axis] : 1e-300);
      double a = (node.low[axis] - from[axis]) * inverse;
      double b = (node.high[axis] - from[axis]) * inverse;
      if (a > b) std::swap(a, b);
      first = std::max(first, a);
      last = std::min(last, b);
    }
    return first <= last;
  }

  // Moller and Trumbore 1997.
  bool MeetsTriangle(std::uint32_t triangle, const glm::dvec3& from, const glm::dvec3& d) const {
    const glm::dvec3& a = surface_->corner(triangle, 0);
    const glm::dvec3 e1 = surface_->corner(triangle, 1) - a;
    const glm::dvec3 e2 = surface_->corner(triangle, 2) - a;
    const glm::dvec3 p = glm::cross(d, e2);
    const double det = glm::dot(e1, p);
    if (det == 0.0) return false;
    const glm::dvec3 s = from - a;
    const double u = glm::dot(s, p) / det;
    const glm::dvec3 q = glm::cross(s, e1);
    const double v = glm::dot(d, q) / det;
    const double t = glm::dot(e2, q) / det;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 1e-4 && t < 1.0;
  }

  const Surface* surface_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

/// Irradiance that enters at a point: position, shading normal, normal of the triangle.
using Entering = std::function<glm::dvec3(const glm::dvec3&, const glm::dvec3&, const glm::dvec3&)>;

/// A point light of that intensity, shadowed by the surface itself.
inline Entering PointLight(const glm::dvec3& position, double intensity, double ior, const Occlusion& occlusion) {
  return [=, &occlusion](const glm::dvec3& p, const glm::dvec3& n, const glm::dvec3& g) {
    const glm::dvec3 to_light = position - p;
    const double d2 = glm::dot(to_light, to_light);
    const glm::dvec3 l = to_light / std::sqrt(d2);
    const double cosine = glm::dot(n, l);
    if (cosine <= 0.0 || glm::dot(g, l) <= 0.0 || occlusion.IsBlocked(p + 0.01 * g, position)) return glm::dvec3(0.0);
    return glm::dvec3(intensity / d2 * cosine * (1.0 - FresnelReflectance(cosine, ior)));
  };
}

/// Light from all around that nothing hides, by a table over normals of the integral over the hemisphere.
template <class Radiance>
Entering Environment(const Radiance& radiance, double ior) {
  constexpr int kHeight = 32;
  constexpr int kWidth = 2 * kHeight;
  const auto direction = [](double row, double column) {
    const double theta = glm::pi<double>() * row / kHeight;
    const double phi = 2.0 * glm::pi<double>() * column / kWidth;
    return glm::dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
  };
  std::vector<glm::dvec3> table;
  for (int row = 0; row <= kHeight; ++row) {
    for (int column = 0; column <= kWidth; ++column) {
      const glm::dvec3 n = direction(row, column);
      glm::dvec3 sum(0.0);
      for (int y = 0; y < kHeight; ++y) {
        const double area =
            2.0 * glm::pi<double>() / kWidth *
            (std::cos(glm::pi<double>() * y / kHeight) - std::cos(glm::pi<double>() * (y + 1) / kHeight));
        for (int x = 0; x < kWidth; ++x) {
          const glm::dvec3 l = direction(y + 0.5, x + 0.5);
          const double cosine = glm::dot(n, l);
          if (cosine > 0.0) sum += radiance(l) * (area * cosine * (1.0 - FresnelReflectance(cosine, ior)));
        }
      }
      table.push_back(sum);
    }
  }
  return [table](const glm::dvec3&, const glm::dvec3& n, const glm::dvec3&) {
    const double row = std::acos(std::clamp(n.y, -1.0, 1.0)) / glm::pi<double>() * kHeight;
    double turn = std::atan2(n.z, n.x) / (2.0 * glm::pi<double>());
    if (turn < 0.0) turn += 1.0;
    const double column = turn * kWidth;
    const int r = std::min(static_cast<int>(row), kHeight - 1);
    const int c = std::min(static_cast<int>(column), kWidth - 1);
    const auto at = [&](int i, int j) { return table[static_cast<std::size_t>(i * (kWidth + 1) + j)]; };
    return glm::mix(glm::mix(at(r, c), at(r, c + 1), column - c), glm::mix(at(r + 1, c), at(r + 1, c + 1), column - c),
                    row - r);
  };
}

/// The surface in small pieces, each with the light that enters it.
class Pieces {
 public:
  /// About `count` of them.
  Pieces(const Surface& surface, std::size_t count, const Entering& entering) {
    double total = 0.0;
    for (std::size_t t = 0; t < surface.triangles(); ++t) total += Area(surface, t);
    const double target = total / static_cast<double>(count);
    for (std::size_t t = 0; t < surface.triangles(); ++t) {
      const double area = Area(surface, t);
      if (!(area > 0.0)) continue;
      const int n = std::max(1, static_cast<int>(std::ceil(std::sqrt(area / target))));
      AddTriangle(surface, t, n, area / (n * n), entering);
    }
  }

  /// Radiosity at a point.
  [[nodiscard]] glm::dvec3 Gather(const glm::dvec3& point, const std::array<Dipole, 3>& dipoles) const {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const double d = glm::distance(places_[i], point);
      for (std::size_t c = 0; c < 3; ++c) {
        sum[static_cast<int>(c)] += light_[i][static_cast<int>(c)] * dipoles[c].Reflectance(d);
      }
    }
    return sum;
  }
  [[nodiscard]] std::size_t size() const { return places_.size(); }

 private:
  static double Area(const Surface& s, std::size_t t) {
    return 0.5 * glm::length(glm::cross(s.corner(t, 1) - s.corner(t, 0), s.corner(t, 2) - s.corner(t, 0)));
  }

  // n * n smaller triangles of one shape.
  void AddTriangle(const Surface& s, std::size_t t, int n, double area, const Entering& entering) {
    const glm::dvec3 g = glm::normalize(glm::cross(s.corner(t, 1) - s.corner(t, 0), s.corner(t, 2) - s.corner(t, 0)));
    for (int row = 0; row < n; ++row) {
      for (int k = 0; k < 2 * (n - row) - 1; ++k) {
        const bool is_down = k % 2 == 1;
        const double b = (row + (is_down ? 2.0 : 1.0) / 3.0) / n;
        const double c = (k / 2 + (is_down ? 2.0 : 1.0) / 3.0) / n;
        const double a = 1.0 - b - c;
        const glm::dvec3 p = a * s.corner(t, 0) + b * s.corner(t, 1) + c * s.corner(t, 2);
        const glm::dvec3 normal = glm::normalize(a * s.normal(t, 0) + b * s.normal(t, 1) + c * s.normal(t, 2));
        const glm::dvec3 light = entering(p, normal, g) * area;
        if (light == glm::dvec3(0.0)) continue;
        places_.push_back(p);
        light_.push_back(light);
      }
    }
  }

  std::vector<glm::dvec3> places_;
  std::vector<glm::dvec3> light_;
};

}  // namespace burin::translucency
