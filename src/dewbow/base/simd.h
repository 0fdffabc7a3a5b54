// SPDX-License-Identifier: Apache-2.0
#pragma once

// One function body, compiled for several instruction sets; the machine's best is chosen when the
// program starts. Without fused multiply-add (see -ffp-contract) each gives the same bits.
// Sanitizers run before the resolver that picks one is ready, so their builds take the plain one.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define DEWBOW_SIMD __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define DEWBOW_SIMD
#endif
