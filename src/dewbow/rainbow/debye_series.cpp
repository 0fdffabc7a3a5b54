// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/debye_series.h"

#include <fmt/format.h>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "dewbow/rainbow/mie/riccati_bessel.h"

namespace dewbow {
namespace {

/// ψ_n, and ζ_n = ψ_n − iχ_n that runs outwards, with their derivatives.
struct RadialWave {
    double psi, psi_slope;
    std::complex<double> zeta, zeta_slope;
};

RadialWave radial_wave(const RiccatiBessel& waves, std::size_t n, double z) {
    // f_n' = f_{n−1} − n f_n / z.                              [Bohren & Huffman 1983, §4.8]
    const double rate = double(n) / z;
    const auto slope = [&](const std::vector<double>& f) { return f[n - 1] - rate * f[n]; };
    const double psi_slope = slope(waves.psi);
    return {waves.psi[n], psi_slope, {waves.psi[n], -waves.chi[n]}, {psi_slope, -slope(waves.chi)}};
}

std::complex<double> power(std::complex<double> base, int exponent) {
    std::complex<double> result = 1.0;
    for (; exponent > 0; exponent >>= 1, base *= base) {
        if (exponent & 1) result *= base;
    }
    return result;
}

void check_range(RelativeIndex index, double x) {
    if (!(x >= kSmallestSize && x <= kLargestDebyeSize)) {
        throw InputError(
            fmt::format("size parameter {} is outside the Debye series' range {} to {}", x,
                        kSmallestSize, kLargestDebyeSize));
    }
    if (!(index.value >= 1.0 && index.value * x <= kLargestInnerSize)) {
        throw InputError(fmt::format("index {} of a drop: the Debye series expects 1 to {}",
                                     index.value, kLargestInnerSize / x));
    }
}

}  // namespace

// With x for the wave outside, y inside, bars for complex conjugates and (α, β) = (m, 1) for TM
// waves, (1, m) for TE, continuity of the tangential fields gives
//
//   Δ = α ζ_x' ζ̄_y − β ζ_x ζ̄_y',          T_21 T_12 = −4m / Δ² (Wronskian ζ' ζ̄ − ζ ζ̄' = 2i),
//   R_22 = −(α ζ̄_x' ζ̄_y − β ζ̄_x ζ̄_y') / Δ,    R_11 = −(α ζ_x' ζ_y − β ζ_x ζ_y') / Δ.
//
// For waves that pass the drop by, n > x, R_22 tends to 1, and for n > y R_11 too: 1 − R_22 and
// 1 − R_11 are therefore written with ψ = ½ (ζ + ζ̄), without a difference of nearly equal numbers.
DebyeSeries::DebyeSeries(RelativeIndex index, double size_parameter) {
    check_range(index, size_parameter);
    const double m = index.value, inner_size = m * size_parameter;
    const int count = term_count(size_parameter);
    const RiccatiBessel outer = riccati_bessel(size_parameter, count);
    const RiccatiBessel inner = riccati_bessel(inner_size, count);
    tm_.reserve(std::size_t(count));
    te_.reserve(std::size_t(count));
    for (std::size_t n = 1; n <= std::size_t(count); ++n) {
        const RadialWave x = radial_wave(outer, n, size_parameter);
        const RadialWave y = radial_wave(inner, n, inner_size);
        const auto wave = [&](double alpha, double beta) {
            const Complex inwards = std::conj(y.zeta), inwards_slope = std::conj(y.zeta_slope);
            const Complex outwards = beta * x.zeta, outwards_slope = alpha * x.zeta_slope;
            const Complex delta = outwards_slope * inwards - outwards * inwards_slope;
            // Not by operator/, which guards against overflow: |Δ| is 1e65 at most, at x = 0.001.
            const Complex inverse = std::conj(delta) * (1.0 / std::norm(delta));
            return Wave{
                (alpha * x.psi_slope * inwards - beta * x.psi * inwards_slope) * inverse,
                2.0 * m * inverse * inverse,
                (outwards * y.zeta_slope - outwards_slope * y.zeta) * inverse,
                2.0 * (outwards_slope * y.psi - outwards * y.psi_slope) * inverse,
            };
        };
        tm_.push_back(wave(m, 1.0));
        te_.push_back(wave(1.0, m));
    }
}

template <class Term>
PartialWaves DebyeSeries::collect(Term term) const {
    PartialWaves waves;
    for (const Wave& wave : tm_) waves.a.push_back(term(wave));
    for (const Wave& wave : te_) waves.b.push_back(term(wave));
    return waves;
}

PartialWaves DebyeSeries::order(int p) const {
    DEWBOW_CHECK(p >= 0, "orders of light count chords");
    if (p == 0) return collect([](const Wave& wave) { return wave.outside; });
    return collect([p](const Wave& wave) { return wave.through * power(wave.inside, p - 1); });
}

PartialWaves DebyeSeries::beyond(int p) const {
    DEWBOW_CHECK(p >= 0, "orders of light count chords");
    return collect(
        [p](const Wave& wave) { return wave.through * power(wave.inside, p) / wave.leak; });
}

PartialWaves DebyeSeries::all() const {
    return collect([](const Wave& wave) { return wave.outside + wave.through / wave.leak; });
}

}  // namespace dewbow
