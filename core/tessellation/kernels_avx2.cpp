// SPDX-License-Identifier: Apache-2.0
#include <type_traits>

#include "core/tessellation/kernels.h"
#include "core/tessellation/net.h"
#include "core/tessellation/surjections.h"

#if defined(__x86_64__) && defined(__GNUC__)

#include <immintrin.h>

#if !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2")
#endif

namespace burin::tessellation {
namespace {

void LeaveKernel() { _mm256_zeroupper(); }

#include "core/tessellation/kernels.inl"

}  // namespace
}  // namespace burin::tessellation

#if !defined(__clang__)
#pragma GCC pop_options
#endif

namespace burin::tessellation {

const Kernels& Avx2Kernels() { return kKernels; }

}  // namespace burin::tessellation

#else

namespace burin::tessellation {

const Kernels& Avx2Kernels() { return PlainKernels(); }

}  // namespace burin::tessellation

#endif
