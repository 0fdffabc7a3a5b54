// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the models `airy` and `uniform_airy` have in common: single bows, summed.

#include <memory>
#include <span>
#include <string_view>

#include "dewbow/optics/refraction.h"
#include "dewbow/rainbow/models.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// Size parameters x that the models take.
inline constexpr double kSmallestBowSize = 10.0, kLargestBowSize = 50'000.0;
/// Throws InputError outside.
void check_bow_size(double size_parameter);

/// The light of one order of drops of one index, with its phase.
class BowPattern {
public:
    virtual ~BowPattern() = default;
    /// Adds S_1 and S_2 to sums[drop][angle], for any angles in any order. NaN where the pattern
    /// does not hold. The light of a drop that is no sphere is turned by angle_without_shift,
    /// without losing any.
    virtual void add_amplitudes(std::span<const Drop> drops, std::span<const Angle> theta,
                                std::span<Amplitudes> sums) const = 0;
};

/// The coherent sum of bows. Its efficiencies are those of the rays of its orders (order_flux),
/// which waves spread over other angles but do not change; with other orders left out, extinction
/// and scattering are the same number.
class BowModel : public AmplitudeModel {
public:
    /// Orders as asked for; none: `all`. Throws InputError for one that is not among 2 to 7.
    BowModel(const Orders& asked, const Orders& all);

    void amplitudes(ComplexIndex index, const Drop& drop, std::span<const Angle> theta,
                    std::span<Amplitudes> out) const final;
    void intensities(ComplexIndex index, std::span<const Drop> drops, std::span<const Angle> theta,
                     std::span<Intensities> out) const final;
    Efficiencies efficiencies(ComplexIndex index, const Drop& drop) const final;

private:
    virtual std::unique_ptr<BowPattern> make_pattern(RelativeIndex n, int p) const = 0;
    /// Throws InputError for an index that is not real, and for sizes outside the limits.
    std::vector<std::unique_ptr<BowPattern>> patterns(ComplexIndex index,
                                                      std::span<const Drop> drops) const;
    Orders orders_;
};

}  // namespace dewbow
