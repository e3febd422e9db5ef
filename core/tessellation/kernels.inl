// SPDX-License-Identifier: Apache-2.0
// Included by kernels_plain.cpp and kernels_avx2.cpp, inside a namespace of theirs, after everything that it needs:
// with AVX2 on, no inline function of another header may be compiled here, or the linker could keep that copy for all.

using Floats = float __attribute__((vector_size(16)));
using UnalignedFloats = float __attribute__((vector_size(16), aligned(4), may_alias));
using Pair = float __attribute__((vector_size(8)));
using UnalignedPair = float __attribute__((vector_size(8), aligned(4), may_alias));
using Indices = int __attribute__((vector_size(16)));

#define BURIN_INLINE [[gnu::always_inline]] static inline

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

template <int kDegree>
static void StepDegree(Lanes* differences, std::uint32_t count, Lanes* out, std::ptrdiff_t stride) {
  Lanes d[kDegree + 1];
  for (int k = 0; k <= kDegree; ++k) d[k] = differences[k];
  for (std::uint32_t i = 0; i < count; ++i) {
    for (int k = 0; k < kDegree; ++k) d[k] += d[k + 1];
    *out = d[0];
    out += stride;
  }
  for (int k = 0; k <= kDegree; ++k) differences[k] = d[k];
}

static void Step(Lanes* differences, int degree, std::uint32_t count, Lanes* out, std::ptrdiff_t stride) {
  switch (degree) {
    case 0:
      return StepDegree<0>(differences, count, out, stride);
    case 1:
      return StepDegree<1>(differences, count, out, stride);
    case 2:
      return StepDegree<2>(differences, count, out, stride);
    case 3:
      return StepDegree<3>(differences, count, out, stride);
    case 4:
      return StepDegree<4>(differences, count, out, stride);
    case 5:
      return StepDegree<5>(differences, count, out, stride);
    case 6:
      return StepDegree<6>(differences, count, out, stride);
    case 7:
      return StepDegree<7>(differences, count, out, stride);
    case 8:
      return StepDegree<8>(differences, count, out, stride);
    case 9:
      return StepDegree<9>(differences, count, out, stride);
    case 10:
      return StepDegree<10>(differences, count, out, stride);
    case 11:
      return StepDegree<11>(differences, count, out, stride);
    case 12:
      return StepDegree<12>(differences, count, out, stride);
    case 13:
      return StepDegree<13>(differences, count, out, stride);
    default:
      __builtin_unreachable();
  }
}

static void Combine(const Lanes* rows, int stride, const double* weights, int row_count, int width, Lanes* sums) {
  for (int k = 0; k < width; ++k) {
    Lanes sum = rows[k] * weights[0];
    for (int j = 1; j < row_count; ++j) sum += rows[j * stride + k] * weights[j];
    sums[k] = sum;
  }
}

static void StoreValuesXy(const Lanes* values, std::uint32_t count, float* out) {
  for (std::uint32_t i = 0; i < count; ++i) StorePair(Rounded(values[i]), out + std::size_t{2} * i);
}

static void StoreValuesXyzw(const Lanes* values, std::uint32_t count, float* out) {
  for (std::uint32_t i = 0; i < count; ++i) StoreOver(Rounded(values[i]), out + std::size_t{4} * i);
}

static void StoreValuesXyz(const Lanes* values, std::uint32_t count, float* out) {
  if (count == 0) return;
  for (std::uint32_t i = 0; i + 1 < count; ++i, out += 3) StoreOver(Rounded(values[i]), out);
  StoreXyz(Rounded(values[count - 1]), out);
}

static void StoreProjected(const Lanes* values, std::uint32_t count, float* out) {
  for (std::uint32_t i = 0; i < count; ++i, out += 3) StoreXyz(Rounded(values[i] / values[i][3]), out);
}

static bool StoreUnits(const Lanes* values, std::uint32_t count, double scale, float* out) {
  constexpr float kLeast = kShortNormal * kShortNormal;
  Indices is_short{};
  for (std::uint32_t i = 0; i < count; i += 4, out += 12) {
    const std::uint32_t last = count - 1 - i;
    const Floats a = Rounded(values[i] * scale), b = Rounded(values[i + (last < 1 ? last : 1)] * scale),
                 c = Rounded(values[i + (last < 2 ? last : 2)] * scale),
                 d = Rounded(values[i + (last < 3 ? last : 3)] * scale);
    const Floats squares = SquaredLengths(a, b, c, d);
    is_short |= ~(squares >= kLeast);
    const Floats inverse = 1.0f / SquareRoots(squares);
    const Floats ua = a * inverse[0], ub = b * inverse[1], uc = c * inverse[2], ud = d * inverse[3];
    if (last >= 3) {
      StoreOver(ua, out);
      StoreOver(ub, out + 3);
      StoreOver(uc, out + 6);
      StoreXyz(ud, out + 9);
    } else {
      StoreXyz(ua, out);
      if (last > 0) StoreXyz(ub, out + 3);
      if (last > 1) StoreXyz(uc, out + 6);
    }
  }
  return (is_short[0] | is_short[1] | is_short[2] | is_short[3]) != 0;
}

static void StoreLine(const double* parameters, std::uint32_t count, const double* from, const double* to, float* out) {
  const double across[2] = {to[0] - from[0], to[1] - from[1]};
  for (std::uint32_t i = 0; i < count; ++i) {
    out[2 * i] = static_cast<float>(from[0] + parameters[i] * across[0]);
    out[2 * i + 1] = static_cast<float>(from[1] + parameters[i] * across[1]);
  }
}

static constexpr Kernels kKernels{Combine,         Step,           StoreValuesXy, StoreValuesXyz,
                                  StoreValuesXyzw, StoreProjected, StoreUnits,    StoreLine};

#undef BURIN_INLINE
