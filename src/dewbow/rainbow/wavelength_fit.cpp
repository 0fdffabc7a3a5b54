// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/wavelength_fit.h"

#include <cmath>
#include <numbers>

namespace dewbow {

WavelengthFit::WavelengthFit(std::span<const Wavelength> wavelengths, std::size_t count,
                             std::size_t degree) {
    if (wavelengths.size() == 1) {
        nodes_ = {wavelengths[0]};
        weights_ = {1.0};
        return;
    }
    const double least = 1.0 / wavelengths.back().base_value(),
                 greatest = 1.0 / wavelengths.front().base_value();
    const double middle = 0.5 * (least + greatest), half = 0.5 * (greatest - least);
    std::vector<double> phases(count);
    for (std::size_t k = 0; k < count; ++k) {
        phases[k] = std::numbers::pi * (double(k) + 0.5) / double(count);
        nodes_.push_back(Wavelength::from_base(1.0 / (middle + half * std::cos(phases[k]))));
    }
    // Σ_k T_i(u_k) T_j(u_k) is count / 2 for i = j > 0, count for i = j = 0, else 0.
    //                                                   [Abramowitz & Stegun 1964, 22.17]
    for (const Wavelength lambda : wavelengths) {
        const double u = (1.0 / lambda.base_value() - middle) / half;
        const double phase = std::acos(std::fmax(-1.0, std::fmin(u, 1.0)));
        for (std::size_t k = 0; k < count; ++k) {
            double sum = 0.5;
            for (std::size_t j = 1; j <= degree; ++j)
                sum += std::cos(double(j) * phase) * std::cos(double(j) * phases[k]);
            weights_.push_back(2.0 * sum / double(count));
        }
    }
}

}  // namespace dewbow
