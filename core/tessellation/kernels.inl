// SPDX-License-Identifier: Apache-2.0
// Included by kernels_plain.cpp and kernels_avx2.cpp, inside a namespace of theirs, after everything that it needs:
// with AVX2 on, no inline function of another header may be compiled here, or the linker could keep that copy for all.

using Floats = float __attribute__((vector_size(16)));
using UnalignedFloats = float __attribute__((vector_size(16), aligned(4), may_alias));
using Pair = float __attribute__((vector_size(8)));
using UnalignedPair = float __attribute__((vector_size(8), aligned(4), may_alias));
using Indices = int __attribute__((vector_size(16)));
using WideIndices = long long __attribute__((vector_size(32)));
using EightIndices = std::uint32_t __attribute__((vector_size(32)));
using UnalignedEight = std::uint32_t __attribute__((vector_size(32), aligned(4), may_alias));

#define BURIN_INLINE [[gnu::always_inline]] static inline
// Loops over degrees must vanish: copying values in halves and reading them whole stalls the processor.
#define BURIN_UNROLL _Pragma("GCC unroll 16")
// Loops over vertices are bound by how many instructions the processor takes a cycle.
#define BURIN_UNROLL_SOME _Pragma("GCC unroll 4")

BURIN_INLINE Floats Rounded(const Lanes& value) { return __builtin_convertvector(value, Floats); }

BURIN_INLINE void StorePair(const Floats& value, float* out) {
  *reinterpret_cast<UnalignedPair*>(out) = Pair{value[0], value[1]};
}

/// Writes four floats, one more than the value has; what follows in memory must be written later.
BURIN_INLINE void StoreOver(const Floats& value, float* out) { *reinterpret_cast<UnalignedFloats*>(out) = value; }

BURIN_INLINE void StoreXyz(const Floats& value, float* out) {
  StorePair(value, out);
  out[2] = value[2];
}

BURIN_INLINE Floats SquareRoots(const Floats& value) {
#if defined(__SSE2__)
  return _mm_sqrt_ps(value);
#else
  return Floats{__builtin_sqrtf(value[0]), __builtin_sqrtf(value[1]), __builtin_sqrtf(value[2]),
                __builtin_sqrtf(value[3])};
#endif
}

/// Of four vectors, (x x + y y) + z z each.
BURIN_INLINE Floats SquaredLengths(const Floats& a, const Floats& b, const Floats& c, const Floats& d) {
  const Floats aa = a * a, bb = b * b, cc = c * c, dd = d * d;
  const Floats ab_xy = __builtin_shuffle(aa, bb, Indices{0, 4, 1, 5}),
               cd_xy = __builtin_shuffle(cc, dd, Indices{0, 4, 1, 5});
  const Floats ab_z = __builtin_shuffle(aa, bb, Indices{2, 6, 3, 7}),
               cd_z = __builtin_shuffle(cc, dd, Indices{2, 6, 3, 7});
  const Floats x = __builtin_shuffle(ab_xy, cd_xy, Indices{0, 1, 4, 5});
  const Floats y = __builtin_shuffle(ab_xy, cd_xy, Indices{2, 3, 6, 7});
  const Floats z = __builtin_shuffle(ab_z, cd_z, Indices{0, 1, 4, 5});
  return (x + y) + z;
}

/// `differences` move on by one step, then the value goes to *out, `count` times.
template <int kDegree>
BURIN_INLINE void StepDegree(Lanes* differences, std::uint32_t count, Lanes* out, std::ptrdiff_t stride) {
  Lanes d[kDegree + 1];
  BURIN_UNROLL
  for (int k = 0; k <= kDegree; ++k) d[k] = differences[k];
  BURIN_UNROLL_SOME
  for (std::uint32_t i = 0; i < count; ++i) {
    BURIN_UNROLL
    for (int k = 0; k < kDegree; ++k) d[k] += d[k + 1];
    *out = d[0];
    out += stride;
  }
  BURIN_UNROLL
  for (int k = 0; k <= kDegree; ++k) differences[k] = d[k];
}

template <int kDegree>
static void RunCurveDegree(Lanes* curve, const LineVertices& vertices, Lanes* out) {
  Lanes* const end = curve + kDegree + 1;
  if (vertices.has_start) *out++ = curve[0];
  if (vertices.from_start > 0) StepDegree<kDegree>(curve, vertices.from_start, out, 1);
  out += vertices.from_start;
  if (vertices.has_middle) *out++ = curve[2 * kDegree + 2];
  if (vertices.has_end) out[vertices.from_end] = end[0];
  if (vertices.from_end > 0) StepDegree<kDegree>(end, vertices.from_end, out + vertices.from_end - 1, -1);
}

template <int kRows>
static void CombineRows(const SteppedCurve* curves, const double* weights, int first, int last, Lanes* sums) {
  Lanes weight[kRows];
  BURIN_UNROLL
  for (int j = 0; j < kRows; ++j) weight[j] = Lanes{} + weights[j];
  for (int k = first; k < last; ++k) {
    Lanes sum = curves[0].values[k] * weight[0];
    BURIN_UNROLL
    for (int j = 1; j < kRows; ++j) sum += curves[j].values[k] * weight[j];
    sums[k] = sum;
  }
}

/// Of rows of known length: all sums stay in registers.
template <int kA, int kB>
static void ConvolveCrossOf(const Lanes* a, const Lanes* b, const Lanes* b_rotated, Lanes* sum) {
  Lanes sums[kA + kB - 1];
  BURIN_UNROLL
  for (int k = 0; k < kA + kB - 1; ++k) sums[k] = sum[k];
  BURIN_UNROLL
  for (int i = 0; i < kA; ++i) {
    const Lanes plain = a[i], rotated = __builtin_shuffle(plain, WideIndices{1, 2, 0, 3});
    BURIN_UNROLL
    for (int k = 0; k < kB; ++k) sums[i + k] += plain * b_rotated[k] - rotated * b[k];
  }
  BURIN_UNROLL
  for (int k = 0; k < kA + kB - 1; ++k) sum[k] = sums[k];
}

static void ConvolveCross(const Lanes* a, int a_count, const Lanes* b, const Lanes* b_rotated, int b_count,
                          Lanes* sum) {
  if (a_count == 3 && b_count == 4) return ConvolveCrossOf<3, 4>(a, b, b_rotated, sum);
  for (int i = 0; i < a_count; ++i) {
    const Lanes plain = a[i], rotated = __builtin_shuffle(plain, WideIndices{1, 2, 0, 3});
    for (int k = 0; k < b_count; ++k) sum[i + k] += plain * b_rotated[k] - rotated * b[k];
  }
}

BURIN_INLINE int RowLength(const NetShape& shape, int row) { return shape.u_count - (shape.is_triangle ? row : 0); }

static void MultiplyCross(const Lanes* a, const NetShape& a_shape, const Lanes* b, const NetShape& b_shape,
                          Lanes* product) {
  Lanes b_rotated[kMaxNetOrder * kMaxNetOrder];
  int b_count = 0;
  for (int row = 0; row < b_shape.v_count; ++row) b_count += RowLength(b_shape, row);
  for (int k = 0; k < b_count; ++k) b_rotated[k] = __builtin_shuffle(b[k], WideIndices{1, 2, 0, 3});
  const NetShape shape{a_shape.u_count + b_shape.u_count - 1, a_shape.v_count + b_shape.v_count - 1,
                       a_shape.is_triangle};
  int starts[2 * kMaxNetOrder], count = 0;
  for (int row = 0; row < shape.v_count; ++row) {
    starts[row] = count;
    count += RowLength(shape, row);
  }
  for (int k = 0; k < count; ++k) product[k] = Lanes{};
  for (int i = 0; i < a_shape.v_count; a += RowLength(a_shape, i), ++i) {
    for (int k = 0, first = 0; k < b_shape.v_count; first += RowLength(b_shape, k), ++k)
      ConvolveCross(a, RowLength(a_shape, i), b + first, b_rotated + first, RowLength(b_shape, k),
                    product + starts[i + k]);
  }
  // The components came in the order y z x.
  for (int k = 0; k < count; ++k) product[k] = __builtin_shuffle(product[k], WideIndices{1, 2, 0, 3});
}

static void ScaleValues(const Lanes* from, const double* scales, int count, Lanes* to) {
  for (int k = 0; k < count; ++k) to[k] = from[k] * scales[k];
}

/// `points`: control points; overwritten. `scales`: C(degree, m) step^m.
template <int kDegree>
BURIN_INLINE void StartDifferences(Lanes* points, const double* scales, Lanes* differences) {
  BURIN_UNROLL
  for (int level = 1; level <= kDegree; ++level) {
    BURIN_UNROLL
    for (int k = kDegree; k >= level; --k) points[k] -= points[k - 1];
  }
  BURIN_UNROLL
  for (int m = 1; m <= kDegree; ++m) points[m] *= scales[m];
  differences[0] = points[0];
  BURIN_UNROLL
  for (int k = 1; k <= kDegree; ++k) {
    Lanes sum = points[k] * kSurjections.rows[k][k];
    BURIN_UNROLL
    for (int m = k + 1; m <= kDegree; ++m) sum += points[m] * kSurjections.rows[m][k];
    differences[k] = sum;
  }
}

/// Sums in pairs from both ends, so that either direction gives the same bits.
template <int kDegree>
BURIN_INLINE Lanes MiddleOf(const Lanes* points) {
  Lanes sum{};
  double total = 1.0;
  BURIN_UNROLL
  for (int k = 0; k < kDegree; ++k) total *= 2.0;
  BURIN_UNROLL
  for (int k = 0; 2 * k < kDegree; ++k) sum += (points[k] + points[kDegree - k]) * (kChoose.rows[kDegree][k] / total);
  if (kDegree % 2 == 0) sum += points[kDegree / 2] * (kChoose.rows[kDegree][kDegree / 2] / total);
  return sum;
}

template <int kDegree>
static void StartCurvesDegree(const Lanes* points, std::ptrdiff_t point_stride, std::ptrdiff_t row_stride,
                              int row_count, double step, CurveParts parts, SteppedCurve* curves) {
  double scales[kDegree + 1], power = 1.0;
  BURIN_UNROLL
  for (int m = 1; m <= kDegree; ++m) {
    power *= step;
    scales[m] = power * kChoose.rows[kDegree][m];
  }
  for (int row = 0; row < row_count; ++row, points += row_stride) {
    Lanes* const curve = curves[row].values;
    Lanes local[kDegree + 1];
    BURIN_UNROLL
    for (int k = 0; k <= kDegree; ++k) local[k] = points[k * point_stride];
    if (parts != CurveParts::kFromStart) curve[2 * kDegree + 2] = MiddleOf<kDegree>(local);
    if (parts == CurveParts::kEndsAndMiddle) {
      curve[0] = local[0];
      curve[kDegree + 1] = local[kDegree];
      continue;
    }
    StartDifferences<kDegree>(local, scales, curve);
    if (parts == CurveParts::kFromStart) continue;
    BURIN_UNROLL
    for (int k = 0; k <= kDegree; ++k) local[k] = points[(kDegree - k) * point_stride];
    StartDifferences<kDegree>(local, scales, curve + kDegree + 1);
  }
}

// Every degree that a net may have along one side.
#define BURIN_EACH_DEGREE(CASE) \
  CASE(0) CASE(1) CASE(2) CASE(3) CASE(4) CASE(5) CASE(6) CASE(7) CASE(8) CASE(9) CASE(10) CASE(11) CASE(12) CASE(13)

#define BURIN_CASE(D) \
  case D:             \
    return RunCurveDegree<D>(curve.values, vertices, out);
static void RunCurve(SteppedCurve& curve, int degree, const LineVertices& vertices, Lanes* out) {
  switch (degree) { BURIN_EACH_DEGREE(BURIN_CASE) }
}
#undef BURIN_CASE

#define BURIN_CASE(D) \
  case D:             \
    return CombineRows<D + 1>(curves, weights, first, last, sum->values);
static void Combine(const SteppedCurve* curves, const double* weights, int count, int degree, CurveParts parts,
                    SteppedCurve* sum) {
  const int first = parts == CurveParts::kEndsAndMiddle ? 2 * degree + 2 : 0;
  const int last = parts == CurveParts::kFromStart ? degree + 1 : 2 * degree + 3;
  switch (count - 1) { BURIN_EACH_DEGREE(BURIN_CASE) }
}
#undef BURIN_CASE

#define BURIN_CASE(D) \
  case D:             \
    return StartCurvesDegree<D>(points, point_stride, row_stride, row_count, step, parts, curves);
static void StartCurves(const Lanes* points, std::ptrdiff_t point_stride, std::ptrdiff_t row_stride, int row_count,
                        int degree, double step, CurveParts parts, SteppedCurve* curves) {
  switch (degree) { BURIN_EACH_DEGREE(BURIN_CASE) }
}
#undef BURIN_CASE

static void Copy(const Lanes* from, std::uint32_t count, Lanes* to) {
  for (std::uint32_t i = 0; i < count; ++i) to[i] = from[i];
}

#undef BURIN_EACH_DEGREE

static void StoreValuesXy(const Lanes* values, std::uint32_t count, float* out) {
  for (std::uint32_t i = 0; i < count; ++i) StorePair(Rounded(values[i]), out + std::size_t{2} * i);
}

static void StoreValuesXyzw(const Lanes* values, std::uint32_t count, float* out) {
  for (std::uint32_t i = 0; i < count; ++i) StoreOver(Rounded(values[i]), out + std::size_t{4} * i);
}

static void StoreValuesXyz(const Lanes* values, std::uint32_t count, float* out) {
  if (count == 0) return;
  BURIN_UNROLL_SOME
  for (std::uint32_t i = 0; i + 1 < count; ++i, out += 3) StoreOver(Rounded(values[i]), out);
  StoreXyz(Rounded(values[count - 1]), out);
}

static void StoreProjected(const Lanes* values, std::uint32_t count, float* out) {
  for (std::uint32_t i = 0; i < count; ++i, out += 3) StoreXyz(Rounded(values[i] / values[i][3]), out);
}

/// Four vectors; `is_short` gets all bits where one of them is.
BURIN_INLINE void MakeUnits(Floats& a, Floats& b, Floats& c, Floats& d, Indices& is_short) {
  const Floats squares = SquaredLengths(a, b, c, d);
  is_short |= ~(squares >= kShortNormal * kShortNormal);
  const Floats inverse = 1.0f / SquareRoots(squares);
  a *= __builtin_shuffle(inverse, Indices{0, 0, 0, 0});
  b *= __builtin_shuffle(inverse, Indices{1, 1, 1, 1});
  c *= __builtin_shuffle(inverse, Indices{2, 2, 2, 2});
  d *= __builtin_shuffle(inverse, Indices{3, 3, 3, 3});
}

static bool StoreUnits(const Lanes* values, std::uint32_t count, float* out) {
  Indices is_short{};
  std::uint32_t i = 0;
  for (; i + 4 < count; i += 4, out += 12) {
    Floats a = Rounded(values[i]), b = Rounded(values[i + 1]), c = Rounded(values[i + 2]), d = Rounded(values[i + 3]);
    MakeUnits(a, b, c, d, is_short);
    StoreOver(a, out);
    StoreOver(b, out + 3);
    StoreOver(c, out + 6);
    StoreOver(d, out + 9);
  }
  // One to four are left.
  const std::uint32_t last = count - 1 - i;
  Floats a = Rounded(values[i]), b = Rounded(values[i + (last < 1 ? last : 1)]),
         c = Rounded(values[i + (last < 2 ? last : 2)]), d = Rounded(values[i + last]);
  MakeUnits(a, b, c, d, is_short);
  if (last > 0) StoreOver(a, out);
  if (last > 1) StoreOver(b, out + 3);
  if (last > 2) StoreOver(c, out + 6);
  StoreXyz(d, out + 3 * last);
  return (is_short[0] | is_short[1] | is_short[2] | is_short[3]) != 0;
}

static void StoreLine(const double* parameters, std::uint32_t count, const double* from, const double* to, float* out) {
  const double across[2] = {to[0] - from[0], to[1] - from[1]};
  for (std::uint32_t i = 0; i < count; ++i) {
    out[2 * i] = static_cast<float>(from[0] + parameters[i] * across[0]);
    out[2 * i + 1] = static_cast<float>(from[1] + parameters[i] * across[1]);
  }
}

/// Four parameters at once.
static void Bernstein(const double* parameters, std::uint32_t count, int degree, double* weights) {
  const int order = degree + 1;
  for (std::uint32_t i = 0; i < count; i += 4) {
    const std::uint32_t last = count - 1 - i;
    const Lanes t{parameters[i], parameters[i + (last < 1 ? last : 1)], parameters[i + (last < 2 ? last : 2)],
                  parameters[i + (last < 3 ? last : 3)]};
    const Lanes rest = 1.0 - t;
    Lanes weight[kMaxNetOrder];
    weight[0] = Lanes{} + 1.0;
    for (int d = 1; d <= degree; ++d) {
      weight[d] = t * weight[d - 1];
      for (int k = d - 1; k > 0; --k) weight[k] = rest * weight[k] + t * weight[k - 1];
      weight[0] *= rest;
    }
    for (std::uint32_t l = 0; l < 4 && l <= last; ++l) {
      for (int k = 0; k < order; ++k)
        weights[(i + l) * static_cast<std::uint32_t>(order) + static_cast<std::uint32_t>(k)] = weight[k][l];
    }
  }
}

static void Rescale(Lanes* values, int count) {
  // Four apart, as each comparison waits for the one before.
  Lanes parts[4] = {};
  for (int k = 0; k < count; k += 4) {
    BURIN_UNROLL
    for (int l = 0; l < 4; ++l) {
      const Lanes& value = values[k + l < count ? k + l : k];
      const Lanes size = value < 0.0 ? -value : value;
      parts[l] = size > parts[l] ? size : parts[l];
    }
  }
  const Lanes even = parts[2] > parts[0] ? parts[2] : parts[0], odd = parts[3] > parts[1] ? parts[3] : parts[1];
  const Lanes largest = odd > even ? odd : even;
  double most = largest[0] > largest[1] ? largest[0] : largest[1];
  if (largest[2] > most) most = largest[2];
  if (!(most > 0.0)) return;
  // By the exponent's bits; numbers too small for that become as large as they can.
  const std::uint64_t exponent = __builtin_bit_cast(std::uint64_t, most) >> 52;
  const double scale = __builtin_bit_cast(double, (exponent == 0 ? 2045 : 2046 - exponent) << 52);
  for (int k = 0; k < count; ++k) values[k] *= scale;
}

static void ShiftIndices(const std::uint32_t* from, std::size_t count, std::uint32_t shift, std::uint32_t* to) {
  const EightIndices shifts = EightIndices{} + shift;
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8)
    *reinterpret_cast<UnalignedEight*>(to + i) = *reinterpret_cast<const UnalignedEight*>(from + i) + shifts;
  for (; i < count; ++i) to[i] = from[i] + shift;
}

/// A kernel that leaves the upper halves of the registers clean: the compiler forgets that on some ways out, and each
/// instruction of the old encoding that follows would then cost some hundred cycles.
template <auto kKernel>
struct Clean;
template <class Value, class... Arguments, Value (*kKernel)(Arguments...)>
struct Clean<kKernel> {
  static Value Run(Arguments... arguments) {
    if constexpr (std::is_void_v<Value>) {
      kKernel(arguments...);
      LeaveKernel();
    } else {
      const Value value = kKernel(arguments...);
      LeaveKernel();
      return value;
    }
  }
};

static constexpr Kernels kKernels{.multiply_cross = Clean<MultiplyCross>::Run,
                                  .scale = Clean<ScaleValues>::Run,
                                  .start_curves = Clean<StartCurves>::Run,
                                  .bernstein = Clean<Bernstein>::Run,
                                  .combine = Clean<Combine>::Run,
                                  .run_curve = Clean<RunCurve>::Run,
                                  .copy = Clean<Copy>::Run,
                                  .store_xy = Clean<StoreValuesXy>::Run,
                                  .store_xyz = Clean<StoreValuesXyz>::Run,
                                  .store_xyzw = Clean<StoreValuesXyzw>::Run,
                                  .store_projected = Clean<StoreProjected>::Run,
                                  .store_units = Clean<StoreUnits>::Run,
                                  .store_line = Clean<StoreLine>::Run,
                                  .rescale = Clean<Rescale>::Run,
                                  .shift_indices = Clean<ShiftIndices>::Run};

#undef BURIN_INLINE
#undef BURIN_UNROLL
#undef BURIN_UNROLL_SOME
