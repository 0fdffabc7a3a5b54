// SPDX-License-Identifier: Apache-2.0
#pragma once

// The wavelengths at which tables of rain are computed.

#include <algorithm>
#include <array>
#include <vector>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// 360 to 830 nm, every 5 nm. A primary bow moves by 0.06° from one to the next, a secondary by
/// 0.1°: a quarter of the sun's disc.
struct VisibleGrid {
    static constexpr double kFirst_nm = 360.0, kStep_nm = 5.0;
    static constexpr std::size_t kCount = 95;

    static std::vector<Wavelength> wavelengths() {
        std::vector<Wavelength> all;
        for (std::size_t j = 0; j < kCount; ++j)
            all.push_back((kFirst_nm + kStep_nm * double(j)) * unit::nm);
        return all;
    }

    struct Place {
        std::size_t cell;  ///< between the wavelengths of this number and the next
        double share;      ///< of the way from the one to the other
    };
    /// Outside the grid: its ends.
    static Place find(double lambda_nm) {
        const double at = std::clamp((lambda_nm - kFirst_nm) / kStep_nm, 0.0, double(kCount - 1));
        const std::size_t cell = std::min(static_cast<std::size_t>(at), kCount - 2);
        return {cell, at - double(cell)};
    }
};

/// A number for each wavelength of the grid, linear between them.
using VisibleValues = std::array<double, VisibleGrid::kCount>;
inline double interpolated(const VisibleValues& values, double lambda_nm) {
    const auto [cell, share] = VisibleGrid::find(lambda_nm);
    return values[cell] + share * (values[cell + 1] - values[cell]);
}

}  // namespace dewbow
