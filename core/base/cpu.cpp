// SPDX-License-Identifier: Apache-2.0
#include "core/base/cpu.h"

#include <sched.h>

#include <cerrno>
#include <thread>

namespace burin::base {
namespace {

// sched_getaffinity refuses (EINVAL) a mask smaller than the kernel's, which has one bit per possible processor.
int CountAffinity() {
  for (int processors = 1024; processors <= 1 << 20; processors *= 2) {
    cpu_set_t* mask = CPU_ALLOC(processors);
    if (mask == nullptr) return 0;
    const std::size_t bytes = CPU_ALLOC_SIZE(processors);
    CPU_ZERO_S(bytes, mask);
    const int status = sched_getaffinity(0, bytes, mask);
    const int failure = errno;
    const int count = status == 0 ? CPU_COUNT_S(bytes, mask) : 0;
    CPU_FREE(mask);
    if (status == 0) return count;
    if (failure != EINVAL) return 0;
  }
  return 0;
}

}  // namespace

int AvailableThreads() {
  if (const int count = CountAffinity(); count > 0) return count;
  const unsigned hardware = std::thread::hardware_concurrency();
  return hardware > 0 ? static_cast<int>(hardware) : 1;
}

bool HasAvx2() {
#if defined(__x86_64__)
  static const bool has = __builtin_cpu_supports("avx2") != 0;
  return has;
#else
  return false;
#endif
}

}  // namespace burin::base
