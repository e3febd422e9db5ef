// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Before a function whose loops vectorise: compiled for AVX2 too, the dynamic linker picks by the processor.
/// Not under the sanitizers, whose instrumented code can't run as early as the picking happens.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define BURIN_TARGET_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define BURIN_TARGET_CLONES
#endif
