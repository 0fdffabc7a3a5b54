// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/dispersion/continuation.h"

#include <algorithm>
#include <cmath>

namespace dewbow::dispersion {
namespace {

/// The walk outwards: no formula is asked about what lies beyond, and a step is fine enough for any
/// resonance that shapes an index.
constexpr double kShortest_nm = 100.0, kLongest_nm = 20000.0, kStep = 1.005;
/// How much steeper, or flatter, than at the edge of its data a formula may become. Glasses whose
/// data end at 390 nm are 1.5 times as steep at 360 nm, rutile (data from 430 nm) 1.9 times; zinc
/// selenide (540 nm) passes 2.5 at 472 nm, on its way to the resonance at 391 nm.
constexpr double kSteepest = 2.5;
/// How much of n − 1 at the edge must be left.
constexpr double kLeastShare = 0.5;
/// Relative step of the derivative: error 1e-8 of it from curvature, 1e-10 from rounding.
constexpr double kDerivativeStep = 1e-4;

double inverse_square_um(double lambda_nm) { return 1e6 / (lambda_nm * lambda_nm); }

double slope_at(const std::function<double(double)>& index, double lambda_nm) {
    const double above = lambda_nm * (1.0 + kDerivativeStep);
    const double below = lambda_nm * (1.0 - kDerivativeStep);
    return (index(below) - index(above)) / (inverse_square_um(below) - inverse_square_um(above));
}

}  // namespace

Continuation::End Continuation::trusted_end(const std::function<double(double)>& index,
                                            double edge_nm, double step_factor, double limit_nm) {
    const auto end_at = [&](double lambda_nm) {
        return End{lambda_nm, inverse_square_um(lambda_nm), index(lambda_nm),
                   slope_at(index, lambda_nm)};
    };
    End end = end_at(edge_nm);
    const double steepness = std::abs(end.slope), sign = end.slope < 0.0 ? -1.0 : 1.0;
    const double least_n = 1.0 + kLeastShare * std::max(end.n - 1.0, 0.0);
    const bool outwards = step_factor > 1.0;
    for (;;) {
        const double next_nm = end.lambda_nm * step_factor;
        if (outwards ? next_nm > limit_nm : next_nm < limit_nm) return end;
        const End next = end_at(next_nm);
        const double secant = (next.n - end.n) / (next.w - end.w);
        const auto behaves = [&](double slope) {  // false for a NaN
            return sign * slope >= steepness / kSteepest && sign * slope <= steepness * kSteepest;
        };
        if (!(next.n > least_n && behaves(secant) && behaves(next.slope))) return end;
        end = next;
    }
}

Continuation::Continuation(const std::function<double(double)>& index, DataRange data)
    : shortest_(trusted_end(index, data.min_nm, 1.0 / kStep, kShortest_nm)),
      longest_(trusted_end(index, data.max_nm, kStep, kLongest_nm)) {}

double Continuation::at(double lambda_nm) const {
    const End& end = lambda_nm < shortest_.lambda_nm ? shortest_ : longest_;
    const double change = end.slope * (inverse_square_um(lambda_nm) - end.w);
    if (change >= 0.0) return end.n + change;
    const double above_one = end.n - 1.0;
    return above_one > 0.0 ? 1.0 + above_one * std::exp(change / above_one) : end.n;
}

}  // namespace dewbow::dispersion
