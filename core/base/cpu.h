// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin::base {

/// Threads that this process may run on at once: the size of its affinity mask (taskset, cpusets, farm slots), at
/// least 1.
[[nodiscard]] int AvailableThreads();

/// Whether this processor runs AVX2 code.
[[nodiscard]] bool HasAvx2();

}  // namespace burin::base
