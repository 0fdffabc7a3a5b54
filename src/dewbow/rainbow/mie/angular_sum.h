// SPDX-License-Identifier: Apache-2.0
#pragma once

// From partial waves to amplitudes by angle.

#include <span>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/rainbow/mie/angular_kernel.h"
#include "dewbow/rainbow/mie/folded_angles.h"
#include "dewbow/rainbow/mie/partial_waves.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// Sums over partial waves at angles 0 to 180° in any order. An object holds buffers: one for each
/// thread.
class AngularSum {
public:
    explicit AngularSum(std::span<const Angle> theta);

    /// S_1 = Σ c_n (a_n π_n + b_n τ_n), S_2 = Σ c_n (a_n τ_n + b_n π_n), c_n = (2n+1) / (n(n+1)),
    /// of several spheres into `out`: [sphere][angle], row-major. Spheres of one call share π_n,
    /// τ_n.
    ///                                                          [Bohren & Huffman 1983, eq. 4.74]
    void sum(std::span<const PartialWaves> spheres, std::span<Amplitudes> out);

private:
    struct Factors {
        std::vector<double> plus, minus;
        void assign(const PartialWaves& waves);
        operator WaveFactors() const { return {plus, minus}; }
    };
    void sum(std::span<const FoldedAngle> block);
    void write(std::span<const FoldedAngle> block, std::span<Amplitudes> out) const;

    std::size_t angles_;
    std::vector<FoldedAngle> folded_;
    std::vector<Factors> buffers_;
    std::vector<WaveFactors> factors_;           ///< [sphere]
    std::vector<BlockSums> forward_, backward_;  ///< [sphere] of one block, or empty
};

/// The same in one call.
void angular_sum(std::span<const PartialWaves> spheres, std::span<const Angle> theta,
                 std::span<Amplitudes> out);

}  // namespace dewbow
