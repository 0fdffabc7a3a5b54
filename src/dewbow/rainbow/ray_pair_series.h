// SPDX-License-Identifier: Apache-2.0
#pragma once

// The functions of ray_pair.h for any index of water, by interpolation.

#include <array>
#include <cstddef>

#include "dewbow/optics/refraction.h"
#include "dewbow/rainbow/ray_pair.h"

namespace dewbow {

/// Indices that are covered: water in air, in the visible and beyond.
inline constexpr double kLowestBowIndex = 1.30, kHighestBowIndex = 1.36;

/// Chebyshev series, for pairs in σ = √((grazing - D) / span), which is 0 at the grazing end and 1
/// at the bow, and beyond in √(D - least): all functions are smooth in these, once P_next and
/// Q_next are multiplied by σ³.
class RayPairSeries {
public:
    /// Throws InputError for n outside kLowestBowIndex to kHighestBowIndex, p outside 2 to 7.
    /// Cost: 1 µs; the first of an order 4 ms.
    RayPairSeries(RelativeIndex n, int p);

    const BowGeometry& geometry() const { return geometry_; }
    /// The least D that is covered, far on the dark side: Ai² is below 1e-8 of its peak there for
    /// x from 100 (p = 2) or 5000 (p = 7) on.
    double darkest() const;
    /// σ of a deviation D <= grazing().
    double sigma(double deviation) const;

    /// ray_pair() for D from darkest() to below grazing(), lone_pair() from there to `most`.
    /// Error: 1e-7 of each function's largest; of ζ and η 1e-12.   Cost: 0.5 µs.
    RayPair<double> at(double deviation) const;

    /// The same for `count` deviations, at most kBlock, that all have two rays, or one.
    /// Cost: 0.05 µs each.
    static constexpr std::size_t kBlock = 64;
    using Block = std::array<double, kBlock>;
    RayPair<Block> pairs(const Block& deviations, std::size_t count) const;
    RayPair<Block> lone(const Block& deviations, std::size_t count) const;

    static constexpr int kTerms = 24;
    static constexpr int kFunctions = RayPair<double>::kCount + 3;  ///< and those of LoneRay
    using Series = std::array<std::array<double, kTerms>, kFunctions>;

private:
    BowGeometry geometry_;
    Series series_;
};

}  // namespace dewbow
