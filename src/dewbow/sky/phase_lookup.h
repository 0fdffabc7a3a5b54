// SPDX-License-Identifier: Apache-2.0
#pragma once

// A phase function as a table that is read a hundred million times.

#include <memory>
#include <span>
#include <vector>

#include "dewbow/rainbow/scattering.h"
#include "dewbow/sky/angle_index.h"
#include "dewbow/sky/visible_grid.h"

namespace dewbow {

/// Shares per sr by angle and wavelength, linear in both between the table's values; kept as
/// floats.
class PhaseLookup {
public:
    /// @param per_sr  [angle][wavelength of VisibleGrid], row-major.
    PhaseLookup(std::shared_ptr<const AngleIndex> angles, std::span<const Intensities> per_sr);

    /// @param cosine  of the scattering angle, 1 forward.   @param out  as long as `lambda_nm`.
    void eval_lanes(double cosine, std::span<const double> lambda_nm,
                    std::span<Intensities> out) const;
    /// For light without polarisation.
    void eval_lanes(double cosine, std::span<const double> lambda_nm, std::span<double> out) const;

private:
    struct Pair {
        float perpendicular, parallel;
    };
    template <class Put>
    void for_each_lane(double cosine, std::span<const double> lambda_nm, Put put) const;

    std::shared_ptr<const AngleIndex> angles_;
    std::vector<Pair> values_;
};

}  // namespace dewbow
