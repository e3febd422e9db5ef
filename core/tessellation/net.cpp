// SPDX-License-Identifier: Apache-2.0
#include "core/tessellation/net.h"

#include <algorithm>

namespace burin::tessellation {

void DeriveU(const Net& net, Net& derivative) {
  const int degree = net.u_degree;
  derivative.domain = net.domain;
  derivative.u_degree = std::max(degree - 1, 0);
  derivative.v_degree = net.is_quad() ? net.v_degree : derivative.u_degree;
  for (int j = 0; j <= derivative.v_degree; ++j) {
    for (int i = 0; i < derivative.RowLength(j); ++i)
      derivative.At(i, j) = degree == 0 ? Lanes{} : (net.At(i + 1, j) - net.At(i, j)) * static_cast<double>(degree);
  }
}

void DeriveV(const Net& net, Net& derivative) {
  const int degree = net.v_degree;
  derivative.domain = net.domain;
  derivative.v_degree = std::max(degree - 1, 0);
  derivative.u_degree = net.is_quad() ? net.u_degree : derivative.v_degree;
  for (int j = 0; j <= derivative.v_degree; ++j) {
    for (int i = 0; i < derivative.RowLength(j); ++i)
      derivative.At(i, j) = degree == 0 ? Lanes{} : (net.At(i, j + 1) - net.At(i, j)) * static_cast<double>(degree);
  }
}

int SideCurve(const Net& net, std::uint32_t side, Lanes* points) {
  const int n = net.u_degree, m = net.v_degree;
  if (net.is_quad()) {
    const int degree = side < 2 ? n : m;
    for (int k = 0; k <= degree; ++k)
      points[k] = side < 2 ? net.At(k, side == 0 ? 0 : m) : net.At(side == 2 ? 0 : n, k);
    return degree;
  }
  for (int k = 0; k <= n; ++k) points[k] = side == 0 ? net.At(k, 0) : side == 1 ? net.At(n - k, k) : net.At(0, n - k);
  return n;
}

double Choose(int n, int k) {
  constexpr int kRows = 22;
  static constexpr auto kTriangle = [] {
    std::array<std::array<double, kRows>, kRows> rows{};
    for (std::size_t r = 0; r < kRows; ++r) {
      rows[r][0] = 1.0;
      for (std::size_t c = 1; c <= r; ++c) rows[r][c] = rows[r - 1][c - 1] + rows[r - 1][c];
    }
    return rows;
  }();
  return kTriangle[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

}  // namespace burin::tessellation
