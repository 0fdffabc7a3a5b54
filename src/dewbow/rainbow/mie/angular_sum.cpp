// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/angular_sum.h"

#include <cmath>
#include <numbers>

namespace dewbow {
namespace {

/// π − the double next to it.
constexpr double kPiRest = 1.2246467991473532e-16;

/// By how much the angle, counted from the nearer end, is off the axis: 1 − |cos θ|, with all its
/// digits.
double off_axis(double theta, bool backward) {
    const double half = 0.5 * (backward ? (std::numbers::pi - theta) + kPiRest : theta);
    return 2.0 * std::sin(half) * std::sin(half);
}

Amplitudes amplitudes_at(const PartialWaves& waves, Angle theta) {
    const bool backward = theta.to(unit::rad) > 0.5 * std::numbers::pi;
    const double epsilon = off_axis(theta.to(unit::rad), backward);
    // π_n and τ_n by the recurrence in differences d_n = π_n − π_{n−1}: with 1 − μ instead of μ
    // nothing is lost near the axis. Backwards, π_n(−μ) = (−1)^{n+1} π_n(μ), τ_n(−μ) = (−1)^n
    // τ_n(μ).
    double pi = 1.0, before = 0.0, difference = 1.0, sign = 1.0;
    std::complex<double> plus{}, minus{};
    for (std::size_t i = 0; i < waves.a.size(); ++i) {
        const double n = double(i) + 1.0, c = (2.0 * n + 1.0) / (n * (n + 1.0)) * sign;
        const double t = difference - epsilon * pi, tau = n * t - before;
        const std::complex<double> a = waves.a[i], b = backward ? -waves.b[i] : waves.b[i];
        plus += c * (a + b) * (pi + tau);
        minus += c * (a - b) * (pi - tau);
        difference = t + t / n - epsilon * pi;
        before = pi;
        pi += difference;
        if (backward) sign = -sign;
    }
    const std::complex<double> s1 = 0.5 * (plus + minus), s2 = 0.5 * (plus - minus);
    return {s1, backward ? -s2 : s2};
}

}  // namespace

void angular_sum(std::span<const PartialWaves> spheres, std::span<const Angle> theta,
                 std::span<Amplitudes> out) {
    for (std::size_t s = 0; s < spheres.size(); ++s)
        for (std::size_t i = 0; i < theta.size(); ++i)
            out[s * theta.size() + i] = amplitudes_at(spheres[s], theta[i]);
}

}  // namespace dewbow
