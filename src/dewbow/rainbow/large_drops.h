// SPDX-License-Identifier: Apache-2.0
#pragma once

// Large drops of many sizes, spheres or flattened: the sum of orders, corrected by Mie theory.

#include <span>
#include <vector>

#include "dewbow/rainbow/cloud_scattering.h"
#include "dewbow/rainbow/composition.h"
#include "dewbow/rainbow/mie_correction.h"

namespace dewbow {

/// Drops that turn an order's bow by about the same shift.
struct ShiftedDrops {
    FringeAverage fringes;        ///< at a reference wavelength
    Angle at_least, at_greatest;  ///< shift at the least and greatest index
};

class LargeDrops {
public:
    /// All arguments are kept by reference. Throws InputError as Mie theory and Composition do.
    LargeDrops(const Cloud& cloud, std::span<const Wavelength> wavelengths,
               std::span<const Angle> angles, const Orders& orders,
               std::span<const AngleRange> exact);
    DropSums sums(std::size_t wavelength) const;
    const MieCorrection& correction() const { return correction_; }

private:
    void add_shifted(Wavelength lambda, std::span<Intensities> sum) const;

    const Cloud& cloud_;
    std::span<const Wavelength> wavelengths_;
    std::span<const Angle> angles_;
    RelativeIndex least_, greatest_;
    CompositionFamily compositions_;
    SummedOrders orders_;
    MieCorrection correction_;
    std::vector<std::vector<ShiftedDrops>> shifted_;  ///< by order; empty for spheres
};

}  // namespace dewbow
