// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/phase_function.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewbow {

namespace {

class HenyeyGreenstein : public PhaseFunction {
public:
    explicit HenyeyGreenstein(double g) : g_(g) {}

    void eval_lanes(double cosine, std::span<const double>, std::span<double> out) const override {
        // 1 + g² − 2 g cos θ, without the cancellation at g and cos θ near 1.
        const double d = (1.0 - g_) * (1.0 - g_) + 2.0 * g_ * (1.0 - cosine);
        const double p = (1.0 - g_) * (1.0 + g_) / (4.0 * std::numbers::pi * d * std::sqrt(d));
        std::fill(out.begin(), out.end(), p);
    }

private:
    double g_;
};

}  // namespace

PhaseFunctionPtr henyey_greenstein(double g) { return std::make_shared<HenyeyGreenstein>(g); }

}  // namespace dewbow
