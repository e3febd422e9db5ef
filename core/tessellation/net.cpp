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

NetLine QuadLine(const Net& net, std::uint32_t side, int depth) {
  const int n = net.u_degree, m = net.v_degree;
  if (side < 2) return {&net.At(0, side == 0 ? depth : m - depth), 1, n};
  return {&net.At(side == 2 ? depth : n - depth, 0), n + 1, m};
}

}  // namespace burin::tessellation
