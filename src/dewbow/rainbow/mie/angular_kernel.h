// SPDX-License-Identifier: Apache-2.0
#pragma once

// The inner loop of angular_sum: where a Mie calculation spends its time.

#include <span>
#include <string_view>

namespace dewbow {

/// Angles whose sums are formed at once.
inline constexpr int kBlockAngles = 48;

/// c_n (a_n + b_n) and c_n (a_n − b_n) of a sphere, of equal length: real and imaginary part of
/// order n at [2n − 2] and [2n − 1].
struct WaveFactors {
    std::span<const double> plus, minus;
};

/// S_1 + S_2 and S_1 − S_2 at the angles of a block, real and imaginary parts.
struct BlockSums {
    alignas(64) double plus[2][kBlockAngles], minus[2][kBlockAngles];
};

/// Amplitudes of several spheres, which share π_n and τ_n, at up to kBlockAngles angles θ of cosine
/// 1 − epsilon into `forward`, and at 180° − θ into `backward`; one of them may be empty.
///
/// Forward Σ_n c_n (a_n ± b_n) (π_n ± τ_n), backward Σ_n (−1)^{n+1} c_n (a_n ± b_n) (π_n ∓ τ_n).
/// Per order, sphere and direction 4 fused multiply-adds, and 7 operations per order and angle for
/// π_n and τ_n. The first of sum_block_variants that the processor has is chosen at run time.
/// Only here may the compiler fuse multiplications with additions (CMakeLists.txt): the last bits
/// depend on the instruction set, though not on how many angles or spheres go together.
void sum_block(std::span<const WaveFactors> spheres, std::span<const double> epsilon,
               std::span<BlockSums> forward, std::span<BlockSums> backward);

/// sum_block for one instruction set.
struct SumBlockVariant {
    std::string_view name;
    bool (*is_supported)();
    void (*sum_block)(std::span<const WaveFactors> spheres, std::span<const double> epsilon,
                      std::span<BlockSums> forward, std::span<BlockSums> backward);
};
/// From the fastest to the one that runs everywhere.
std::span<const SumBlockVariant> sum_block_variants();

}  // namespace dewbow
