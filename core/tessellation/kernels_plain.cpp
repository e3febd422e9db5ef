// SPDX-License-Identifier: Apache-2.0
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <type_traits>

#include "core/tessellation/kernels.h"
#include "core/tessellation/net.h"
#include "core/tessellation/surjections.h"

namespace burin::tessellation {
namespace {

void LeaveKernel() {}

#include "core/tessellation/kernels.inl"

}  // namespace

const Kernels& PlainKernels() { return kKernels; }

bool IsShortNormal(const Lanes& value) {
  const Floats rounded = Rounded(value);
  const Floats squares = SquaredLengths(rounded, rounded, rounded, rounded);
  return !(squares[0] >= kShortNormal * kShortNormal);
}

}  // namespace burin::tessellation
