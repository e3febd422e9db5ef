// SPDX-License-Identifier: Apache-2.0
// Forward differences of a polynomial (Moreton, section 3). In powers of t its coefficients are C(n, m) times the m-th
// differences of the control points; the k-th difference of t^m for steps of h is h^m k! S(m, k) at 0, S the Stirling
// numbers of the second kind.
#include "core/tessellation/differences.h"

#include <array>

#include "core/tessellation/net.h"

namespace burin::tessellation {
namespace {

constexpr std::size_t kOrders = kMaxNetOrder;

/// k! S(m, k) at [m][k]: the ways to map m things onto k.
constexpr auto kSurjections = [] {
  std::array<std::array<double, kOrders>, kOrders> counts{};
  counts[0][0] = 1.0;
  for (std::size_t m = 1; m < kOrders; ++m) {
    for (std::size_t k = 1; k <= m; ++k)
      counts[m][k] = static_cast<double>(k) * (counts[m - 1][k] + counts[m - 1][k - 1]);
  }
  return counts;
}();

}  // namespace

void StartDifferences(const Lanes* points, std::ptrdiff_t stride, int degree, double step, Lanes* differences) {
  Lanes powers[kMaxNetOrder];
  for (int k = 0; k <= degree; ++k) powers[k] = points[k * stride];
  for (int level = 1; level <= degree; ++level) {
    for (int k = degree; k >= level; --k) powers[k] -= powers[k - 1];
  }
  double scale = 1.0;
  for (int m = 1; m <= degree; ++m) {
    scale *= step;
    powers[m] *= scale * Choose(degree, m);
  }
  differences[0] = powers[0];
  for (int k = 1; k <= degree; ++k) {
    Lanes sum{};
    for (int m = k; m <= degree; ++m)
      sum += powers[m] * kSurjections[static_cast<std::size_t>(m)][static_cast<std::size_t>(k)];
    differences[k] = sum;
  }
}

Lanes MiddleOf(const Lanes* points, std::ptrdiff_t stride, int degree) {
  Lanes sum{};
  double total = 1.0;
  for (int k = 0; k < degree; ++k) total *= 2.0;
  for (int k = 0; 2 * k < degree; ++k)
    sum += (points[k * stride] + points[(degree - k) * stride]) * (Choose(degree, k) / total);
  if (degree % 2 == 0) sum += points[degree / 2 * stride] * (Choose(degree, degree / 2) / total);
  return sum;
}

void BernsteinWeights(int degree, double t, double* weights) {
  weights[0] = 1.0;
  for (int d = 1; d <= degree; ++d) {
    weights[d] = t * weights[d - 1];
    for (int k = d - 1; k > 0; --k) weights[k] = (1.0 - t) * weights[k] + t * weights[k - 1];
    weights[0] *= 1.0 - t;
  }
}

}  // namespace burin::tessellation
