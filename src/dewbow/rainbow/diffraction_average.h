// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light diffracted around drops of different sizes.

#include <memory>
#include <span>
#include <vector>

namespace dewbow {

/// Light diffracted around drops, and what it makes with light that is reflected at grazing
/// incidence beside it: their difference of phase is that at the edge of the drop, and averages
/// over sizes do not wash it out. By s = sin θ; the table serves a whole spectrum, as that of
/// FringeAverage does.
class DiffractionAverage {
public:
    DiffractionAverage(std::span<const double> sizes, std::span<const double> shares);
    struct Value {
        double diffracted;  ///< Σ w x⁴ (J_1(u) / u)², u = x s
        double cross;       ///< Σ w x³ J_1(u) sin(u) / u, times −r_j
    };
    Value at(double s) const;
    DiffractionAverage rescaled(double ratio) const;

private:
    Value far(double s) const;  ///< after fringes are washed out, for scale 1
    std::shared_ptr<const std::vector<Value>> nodes_;
    double step_ = 0.0, mean_size_ = 0.0, mean_power_ = 0.0;  ///< Σ w x, Σ w x^{3/2}
    double scale_ = 1.0;
};

}  // namespace dewbow
