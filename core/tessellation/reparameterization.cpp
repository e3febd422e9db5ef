// SPDX-License-Identifier: Apache-2.0
// The triangle's Bernstein polynomials n!/(i!j!k!) u^i v^j (1-u-v)^k with bilinear u(s, t), v(s, t) are products of
// bilinear polynomials, so their tensor-product control points follow by convolution (as in normal_net.cpp).
#include "core/tessellation/reparameterization.h"

#include <mutex>

namespace burin::tessellation {
namespace {

/// A polynomial of one degree in s and in t; scaled control points, that of (i, j) at j * (degree + 1) + i.
struct Polynomial {
  std::size_t degree = 0;
  std::vector<double> points{1.0};
};

Polynomial Product(const Polynomial& a, const Polynomial& b) {
  Polynomial product{a.degree + b.degree, {}};
  const std::size_t order = product.degree + 1;
  product.points.resize(order * order);
  for (std::size_t ja = 0; ja <= a.degree; ++ja) {
    for (std::size_t ia = 0; ia <= a.degree; ++ia) {
      for (std::size_t jb = 0; jb <= b.degree; ++jb) {
        for (std::size_t ib = 0; ib <= b.degree; ++ib)
          product.points[(ja + jb) * order + ia + ib] +=
              a.points[ja * (a.degree + 1) + ia] * b.points[jb * (b.degree + 1) + ib];
      }
    }
  }
  return product;
}

std::vector<Polynomial> Powers(const Polynomial& base, int degree) {
  std::vector<Polynomial> powers(1);
  for (int k = 0; k < degree; ++k) powers.push_back(Product(powers.back(), base));
  return powers;
}

Reparameterization Make(TrianglePart part, int degree) {
  const auto corners = PartCorners(part);
  Polynomial u{1, {}}, v{1, {}}, w{1, {}};
  for (const glm::dvec2& corner : corners) {
    u.points.push_back(corner.x);
    v.points.push_back(corner.y);
    w.points.push_back(1.0 - corner.x - corner.y);
  }
  const auto us = Powers(u, degree), vs = Powers(v, degree), ws = Powers(w, degree);
  const std::size_t order = static_cast<std::size_t>(degree) + 1;
  std::vector<std::vector<double>> columns;  // one a triangle's point
  for (int j = 0; j <= degree; ++j) {
    for (int i = 0; i + j <= degree; ++i) {
      const auto at = [](int k) { return static_cast<std::size_t>(k); };
      Polynomial basis = Product(Product(us[at(i)], vs[at(j)]), ws[at(degree - i - j)]);
      for (double& point : basis.points) point *= Choose(degree, j) * Choose(degree - j, i);
      columns.push_back(std::move(basis.points));
    }
  }
  Reparameterization made;
  for (std::size_t point = 0; point < order * order; ++point) {
    const double scale =
        Choose(degree, static_cast<int>(point % order)) * Choose(degree, static_cast<int>(point / order));
    for (std::size_t from = 0; from < columns.size(); ++from) {
      if (columns[from][point] != 0.0)
        made.entries.push_back({static_cast<std::uint32_t>(from), columns[from][point] / scale});
    }
    made.row_ends.push_back(static_cast<std::uint32_t>(made.entries.size()));
  }
  return made;
}

}  // namespace

std::array<glm::dvec2, 4> PartCorners(TrianglePart part) {
  constexpr std::array<glm::dvec2, 3> kCorners{glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 1.0)};
  if (part == TrianglePart::kWhole) return {kCorners[0], kCorners[1], kCorners[2], kCorners[2]};
  const auto c = static_cast<std::size_t>(part);
  const glm::dvec2 &at = kCorners[c], &next = kCorners[(c + 1) % 3], &before = kCorners[(c + 2) % 3];
  return {at, 0.5 * (at + next), 0.5 * (at + before), (kCorners[0] + kCorners[1] + kCorners[2]) / 3.0};
}

const Reparameterization& ReparameterizationOf(TrianglePart part, int degree) {
  static std::array<std::array<Reparameterization, kMaxNetOrder>, 4> all;
  static std::array<std::array<std::once_flag, kMaxNetOrder>, 4> once;
  const auto p = static_cast<std::size_t>(part), d = static_cast<std::size_t>(degree);
  std::call_once(once[p][d], [&] { all[p][d] = Make(part, degree); });
  return all[p][d];
}

void Reparameterize(const Net& triangle, TrianglePart part, Net& quad) {
  quad.domain = geometry::PatchDomain::kQuad;
  quad.u_degree = quad.v_degree = triangle.u_degree;
  const Reparameterization& matrix = ReparameterizationOf(part, triangle.u_degree);
  std::uint32_t e = 0;
  for (std::size_t point = 0; point < matrix.row_ends.size(); ++point) {
    Lanes sum{};
    for (; e < matrix.row_ends[point]; ++e) sum += triangle.value[matrix.entries[e].from] * matrix.entries[e].weight;
    quad.value[point] = sum;
  }
}

}  // namespace burin::tessellation
