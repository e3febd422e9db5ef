// SPDX-License-Identifier: Apache-2.0
#pragma once
// The inner loops, built once for every processor and once for AVX2. Each component of each value sees the same
// operations in the same order in both, none of them fused, so both give the same bits.

#include <cstddef>
#include <cstdint>

#include "core/tessellation/lanes.h"

namespace burin::tessellation {

/// A Bézier curve of some degree ready to be stepped from both ends: the value at 0 and its differences of order 1 to
/// degree; the same from the other end; the value at 1/2.
struct SteppedCurve {
  Lanes values[2 * kMaxNetOrder + 1];
};

/// A line's vertices in order: its start, those stepped from there, one in the middle, those stepped from its end, and
/// its end.
struct LineVertices {
  std::uint32_t from_start = 0, from_end = 0;
  bool has_middle = false, has_start = false, has_end = false;
  [[nodiscard]] bool is_one_ended() const { return from_end == 0 && !has_middle && !has_end; }
};

/// Which parts of a curve are wanted.
enum class CurveParts : std::uint8_t { kFromStart, kEndsAndMiddle, kAll };

/// How a net's control points lie: v_count rows, each as long as the first or, of triangles, one shorter than the last.
struct NetShape {
  int u_count = 0, v_count = 0;
  bool is_triangle = false;
};

struct Kernels {
  /// The product of two polynomials by their scaled control points, x y z as cross products: a convolution.
  void (*multiply_cross)(const Lanes* a, const NetShape& a_shape, const Lanes* b, const NetShape& b_shape,
                         Lanes* product);
  /// to[i] = from[i] * scales[i].
  void (*scale)(const Lanes* from, const double* scales, int count, Lanes* to);
  /// For each of `row_count` Bézier curves of one degree, control points `point_stride` apart, those of curve r from
  /// points[r * row_stride] on: what forward differencing for steps of `step` starts from (SteppedCurve).
  void (*start_curves)(const Lanes* points, std::ptrdiff_t point_stride, std::ptrdiff_t row_stride, int row_count,
                       int degree, double step, CurveParts parts, SteppedCurve* curves);
  /// The degree + 1 Bernstein polynomials at each parameter, one set after the other.
  void (*bernstein)(const double* parameters, std::uint32_t count, int degree, double* weights);
  /// *sum = the sum over j of weights[j] * curves[j], of curves of one degree.
  void (*combine)(const SteppedCurve* curves, const double* weights, int count, int degree, CurveParts parts,
                  SteppedCurve* sum);
  /// Forward differencing: writes a line's vertices one after the other. The curve moves on as far as it was stepped.
  void (*run_curve)(SteppedCurve& curve, int degree, const LineVertices& vertices, Lanes* out);
  void (*copy)(const Lanes* from, std::uint32_t count, Lanes* to);
  // These write `count` values without gaps, rounded to float.
  void (*store_xy)(const Lanes* values, std::uint32_t count, float* out);
  void (*store_xyz)(const Lanes* values, std::uint32_t count, float* out);
  void (*store_xyzw)(const Lanes* values, std::uint32_t count, float* out);
  void (*store_projected)(const Lanes* values, std::uint32_t count, float* out);  ///< xyz / w
  /// Unit vectors along `values` (at least one). Returns whether any of them is shorter than kShortNormal; what it
  /// writes for those is not to be used.
  bool (*store_units)(const Lanes* values, std::uint32_t count, float* out);
  /// from + parameters[i] * (to - from), for pairs.
  void (*store_line)(const double* parameters, std::uint32_t count, const double* from, const double* to, float* out);
  /// Multiplies by the power of two that makes the largest component at least 1 and below 2, if there is any but 0.
  void (*rescale)(Lanes* values, int count);
  /// to[i] = from[i] + shift; the ranges are the same or apart.
  void (*shift_indices)(const std::uint32_t* from, std::size_t count, std::uint32_t shift, std::uint32_t* to);
};

/// Below this (control vectors are about 1 long) a stepped normal is evaluated exactly instead: differencing may have
/// left it too few digits, or it vanishes.
inline constexpr float kShortNormal = 1e-6f;
/// As store_units tells it.
[[nodiscard]] bool IsShortNormal(const Lanes& value);

[[nodiscard]] const Kernels& PlainKernels();
/// PlainKernels() where the program was built for another kind of processor. Otherwise needs base::HasAvx2().
[[nodiscard]] const Kernels& Avx2Kernels();

}  // namespace burin::tessellation
