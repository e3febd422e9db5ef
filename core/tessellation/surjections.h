// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tessellation/lanes.h"

namespace burin::tessellation {

/// k! S(m, k) at [m][k], S the Stirling numbers of the second kind: how many ways there are to map m things onto k.
/// In powers of t a Bézier curve's coefficients are C(n, m) times the m-th differences of its control points, and the
/// k-th difference of t^m for steps of h is h^m k! S(m, k) at 0: that is what forward differencing starts from.
struct SurjectionTable {
  double rows[kMaxNetOrder][kMaxNetOrder];
};
inline constexpr SurjectionTable kSurjections = [] {
  SurjectionTable table{};
  table.rows[0][0] = 1.0;
  for (int m = 1; m < kMaxNetOrder; ++m) {
    for (int k = 1; k <= m; ++k) table.rows[m][k] = k * (table.rows[m - 1][k] + table.rows[m - 1][k - 1]);
  }
  return table;
}();

}  // namespace burin::tessellation
