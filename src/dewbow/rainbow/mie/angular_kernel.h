// SPDX-License-Identifier: Apache-2.0
#pragma once

// The inner loop of angular_sum: where a Mie calculation spends its time.

#include <span>
#include <string_view>

namespace dewbow {

/// Angles whose sums are formed at once.
inline constexpr int kBlockAngles = 48;

/// Complex factors of π_n + τ_n and of π_n − τ_n, of equal length: real and imaginary part of
/// order n at [2n − 2] and [2n − 1].
struct WaveFactors {
    std::span<const double> plus, minus;
};

/// Σ_n factor × (π_n ± τ_n) at the angles of a block, real and imaginary parts.
struct BlockSums {
    alignas(64) double plus[2][kBlockAngles], minus[2][kBlockAngles];
};

/// Sums of several spheres, which share π_n and τ_n, at up to kBlockAngles angles of cosine
/// 1 − epsilon.
///
/// Per order, sphere and angle 4 fused multiply-adds, and 7 operations per order and angle for π_n
/// and τ_n. The first of sum_block_variants that the processor has is chosen at run time.
/// Only here may the compiler fuse multiplications with additions (CMakeLists.txt): the last bits
/// depend on the instruction set, though not on how many angles or spheres go together.
void sum_block(std::span<const WaveFactors> spheres, std::span<const double> epsilon,
               std::span<BlockSums> sums);

/// sum_block for one instruction set.
struct SumBlockVariant {
    std::string_view name;
    bool (*is_supported)();
    void (*sum_block)(std::span<const WaveFactors> spheres, std::span<const double> epsilon,
                      std::span<BlockSums> sums);
};
/// From the fastest to the one that runs everywhere.
std::span<const SumBlockVariant> sum_block_variants();

}  // namespace dewbow
