// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is smooth in the wavelength, from few wavelengths.

#include <span>
#include <vector>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// A polynomial in 1/λ through values at Chebyshev's points of a range of wavelengths, or the best
/// of a lower degree: then what is not smooth in the values counts for √((degree + 1) / count) of
/// itself only.
class WavelengthFit {
public:
    /// For values wanted at `wavelengths` (ascending). With one wavelength the only node is that.
    /// @param count  of nodes, above `degree`.
    WavelengthFit(std::span<const Wavelength> wavelengths, std::size_t count, std::size_t degree);

    std::span<const Wavelength> nodes() const { return nodes_; }
    /// What the values at the nodes count for in that at wavelength number w. [node]
    std::span<const double> weights(std::size_t w) const {
        return std::span(weights_).subspan(w * nodes_.size(), nodes_.size());
    }

private:
    std::vector<Wavelength> nodes_;
    std::vector<double> weights_;  ///< [wavelength][node]
};

}  // namespace dewbow
