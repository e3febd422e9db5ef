// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "core/tessellation/lanes.h"

namespace burin::tessellation {

/// What forward differencing starts from: the value of the Bézier curve at 0 and its differences of order 1 to `degree`
/// for steps of `step`. Control point k is points[k * stride].
void StartDifferences(const Lanes* points, std::ptrdiff_t stride, int degree, double step, Lanes* differences);

/// The curve's value at 1/2. Sums the points in pairs from both ends, so that either direction gives the same bits.
[[nodiscard]] Lanes MiddleOf(const Lanes* points, std::ptrdiff_t stride, int degree);

/// The degree + 1 Bernstein polynomials at t.
void BernsteinWeights(int degree, double t, double* weights);

}  // namespace burin::tessellation
