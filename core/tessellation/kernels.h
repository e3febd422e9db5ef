// SPDX-License-Identifier: Apache-2.0
#pragma once
// The inner loops, built once for every processor and once for AVX2. Each component of each value sees the same
// operations in the same order in both, none of them fused, so both give the same bits.

#include <cstddef>
#include <cstdint>

#include "core/tessellation/lanes.h"

namespace burin::tessellation {

struct Kernels {
  /// sums[k] = the sum over j of weights[j] * rows[j * stride + k], for k < width.
  void (*combine)(const Lanes* rows, int stride, const double* weights, int row_count, int width, Lanes* sums);
  /// Forward differencing: `differences` (degree + 1: the value, its first difference, ...) move on by one step, then
  /// the value goes to *out, `count` times; `out` moves by `stride` values each time.
  void (*step)(Lanes* differences, int degree, std::uint32_t count, Lanes* out, std::ptrdiff_t stride);

  // These write `count` values without gaps, rounded to float.
  void (*store_xy)(const Lanes* values, std::uint32_t count, float* out);
  void (*store_xyz)(const Lanes* values, std::uint32_t count, float* out);
  void (*store_xyzw)(const Lanes* values, std::uint32_t count, float* out);
  void (*store_projected)(const Lanes* values, std::uint32_t count, float* out);  ///< xyz / w
  /// Unit vectors along `values`, which times `scale` are at most about 1 long. Returns whether any of them is shorter
  /// than kShortNormal; what it writes for those is not to be used.
  bool (*store_units)(const Lanes* values, std::uint32_t count, double scale, float* out);
  /// from + parameters[i] * (to - from), for pairs.
  void (*store_line)(const double* parameters, std::uint32_t count, const double* from, const double* to, float* out);
};

/// Below this share of the longest control vector a stepped normal is evaluated exactly instead: differencing may have
/// left it too few digits, or it vanishes.
inline constexpr float kShortNormal = 1e-6f;
/// The comparison that store_units makes of values[i] * scale.
[[nodiscard]] bool IsShortNormal(const Lanes& value, double scale);

[[nodiscard]] const Kernels& PlainKernels();
/// PlainKernels() where the program was built for another kind of processor. Otherwise needs base::HasAvx2().
[[nodiscard]] const Kernels& Avx2Kernels();

}  // namespace burin::tessellation
