// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/partial_waves.h"

#include <fmt/format.h>

#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/mie/riccati_bessel.h"

namespace dewbow {
namespace {

using Complex = std::complex<double>;

void check_size(double x) {
    if (!(x >= kSmallestSize && x <= kLargestSize))
        throw InputError(fmt::format("size parameter {} is outside Mie theory's range {} to {}", x,
                                     kSmallestSize, kLargestSize));
}

void check_index(ComplexIndex index, double x) {
    if (!(index.n > 0.0 && std::isfinite(index.n) && index.k >= 0.0 && std::isfinite(index.k)))
        throw InputError(
            fmt::format("index {} + {}i of a drop: expected a real part above 0 and an "
                        "imaginary part (absorption) of 0 or more",
                        index.n, index.k));
    if (!(std::abs(index.value()) * x <= kLargestInnerSize))
        throw InputError(
            fmt::format("index {} + {}i at size parameter {}: |index| times size is "
                        "above {}, too large to compute",
                        index.n, index.k, x, kLargestInnerSize));
}

double imaginary(double) { return 0.0; }
double imaginary(Complex a) { return a.imag(); }
/// Re(a b*)
double real_product(double a, double b) { return a * b; }
double real_product(Complex a, Complex b) { return a.real() * b.real() + a.imag() * b.imag(); }

/// N / (N − iM) for one order; ψ and χ of it and of the next one.
struct Wave {
    double psi, psi_next, chi, chi_next;
    template <class T>
    Complex amplitude(T G) const {
        const T N = G * psi + psi_next, M = G * chi + chi_next;
        // |N − iM|² = |N|² + |M|² − 2 Im(N M*), and Im(N M*) = Im G.
        const double N2 = real_product(N, N), M2 = real_product(M, M), absorbed = -imaginary(G);
        const double norm = N2 + M2 + 2.0 * absorbed;
        return {(N2 + absorbed) / norm, real_product(N, M) / norm};
    }
};

/// `amplitudes(n, wave)` gives the pair a_n, b_n.
template <class AmplitudesOfOrder>
PartialWaves waves_outside(double x, const AmplitudesOfOrder& amplitudes) {
    const std::size_t N = std::size_t(term_count(x));
    const RiccatiBessel outside = riccati_bessel(x, int(N) + 1);
    PartialWaves waves;
    waves.a.resize(N);
    waves.b.resize(N);
    for (std::size_t n = 1; n <= N; ++n) {
        const Wave wave{outside.psi[n], outside.psi[n + 1], outside.chi[n], outside.chi[n + 1]};
        const auto [a, b] = amplitudes(n, wave);
        waves.a[n - 1] = a;
        waves.b[n - 1] = b;
    }
    return waves;
}

/// T is double for indices without absorption, where nothing complex is needed.
template <class T>
PartialWaves waves_of(T m, double x) {
    const std::vector<T> ratios = psi_ratios(m * x, term_count(x) + 1);
    const T inverse = 1.0 / m, electric = (inverse * inverse - 1.0) / x;
    return waves_outside(x, [&](std::size_t n, const Wave& wave) {
        const T r = ratios[n + 1];
        return std::pair(wave.amplitude((double(n) + 1.0) * electric - inverse * r),
                         wave.amplitude(-m * r));
    });
}

}  // namespace

PartialWaves mie_waves(ComplexIndex index, double x) {
    check_size(x);
    check_index(index, x);
    return index.is_real() ? waves_of(index.n, x) : waves_of(index.value(), x);
}

PartialWaves conductor_waves(double x) {
    check_size(x);
    return waves_outside(x, [x](std::size_t n, const Wave& wave) {
        const Complex xi{wave.psi, -wave.chi};
        return std::pair(wave.amplitude(-(double(n) + 1.0) / x), wave.psi / xi);
    });
}

Efficiencies efficiencies_of(const PartialWaves& waves, double x) {
    double extinction = 0.0, scattering = 0.0, asymmetry = 0.0;
    for (std::size_t i = 0; i < waves.a.size(); ++i) {
        const double n = double(i) + 1.0;
        const Complex a = waves.a[i], b = waves.b[i];
        extinction += (2.0 * n + 1.0) * (a.real() + b.real());
        scattering += (2.0 * n + 1.0) * (std::norm(a) + std::norm(b));
        asymmetry += (2.0 * n + 1.0) / (n * (n + 1.0)) * real_product(a, b);
        if (i + 1 < waves.a.size())
            asymmetry += n * (n + 2.0) / (n + 1.0) *
                         (real_product(a, waves.a[i + 1]) + real_product(b, waves.b[i + 1]));
    }
    const double scale = 2.0 / (x * x);
    return {scale * extinction, scale * scattering, 2.0 * asymmetry / scattering};
}

double backscatter_efficiency(const PartialWaves& waves, double x) {
    Complex sum{};
    double sign = 1.0;
    for (std::size_t i = 0; i < waves.a.size(); ++i, sign = -sign)
        sum += sign * (2.0 * double(i) + 3.0) * (waves.a[i] - waves.b[i]);
    return std::norm(sum) / (x * x);
}

}  // namespace dewbow
