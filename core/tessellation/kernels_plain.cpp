// SPDX-License-Identifier: Apache-2.0
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "core/tessellation/kernels.h"

namespace burin::tessellation {
namespace {

#include "core/tessellation/kernels.inl"

}  // namespace

const Kernels& PlainKernels() { return kKernels; }

bool IsShortNormal(const Lanes& value, double scale) {
  const Floats rounded = Rounded(value * scale);
  const Floats squares = SquaredLengths(rounded, rounded, rounded, rounded);
  return !(squares[0] >= kShortNormal * kShortNormal);
}

}  // namespace burin::tessellation
