// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/riccati_bessel.h"

#include <algorithm>
#include <cmath>

namespace dewbow {
namespace {

/// Where a downward recurrence may start with 0: what is wrong there has shrunk to 1e-18 at
/// n = max(N, |z|).
int start_of_ratios(double modulus, int N) {
    return int(std::max(double(N), modulus) + 8.0 * std::cbrt(modulus) + 16.0);
}

double reciprocal(double a) { return 1.0 / a; }
double product(double a, double b) { return a * b; }
/// These two without the care for overflow that std::complex takes.
std::complex<double> reciprocal(std::complex<double> a) { return std::conj(a) / std::norm(a); }
std::complex<double> product(std::complex<double> a, std::complex<double> b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
double size(double a) { return std::abs(a); }
double size(std::complex<double> a) { return std::abs(a.real()) + std::abs(a.imag()); }

/// 1/z with twice the digits: the rounding of a plain 1/z, the same in every step of a recurrence,
/// would shift the phase by |z| / 1e16.
template <class T>
struct Inverse {
    T value, rest;
    explicit Inverse(T z) : value(reciprocal(z)), rest(value * residual(z)) {}
    T times(double a) const { return a * value + a * rest; }

private:
    /// 1 − z · value, exact but for the last rounding.
    double residual(double z) const { return std::fma(-z, value, 1.0); }
    std::complex<double> residual(std::complex<double> z) const {
        const double re = std::fma(-z.real(), value.real(), 1.0);
        const double im = z.real() * value.imag();
        const double im_rest = std::fma(z.real(), value.imag(), -im);
        return {std::fma(z.imag(), value.imag(), re),
                -std::fma(z.imag(), value.real(), im) - im_rest};
    }
};

}  // namespace

int term_count(double x) { return int(x + 6.0 * std::cbrt(x) + 8.0); }

template <class T>
std::vector<T> psi_ratios(T z, int N) {
    std::vector<T> ratios(std::size_t(N) + 1);
    const Inverse<T> inverse(z);
    // ψ_n but for a common factor, which is taken back before it is too great to square.
    constexpr double kGreat = 1e100;
    T after{}, wave{1.0};
    for (int n = start_of_ratios(std::abs(z), N); n >= 1; --n) {
        const T before = product(inverse.times(2.0 * n + 1.0), wave) - after;
        if (n <= N) ratios[std::size_t(n)] = product(wave, reciprocal(before));
        after = wave;
        wave = before;
        if (size(wave) > kGreat) {
            after *= 1.0 / kGreat;
            wave *= 1.0 / kGreat;
        }
    }
    return ratios;
}
template std::vector<double> psi_ratios(double, int);
template std::vector<std::complex<double>> psi_ratios(std::complex<double>, int);

template <class T>
std::vector<T> logarithmic_derivatives(T z, int N) {
    std::vector<T> derivatives = psi_ratios(z, N + 1);
    const Inverse<T> inverse(z);
    for (int n = 0; n <= N; ++n)
        derivatives[std::size_t(n)] = inverse.times(n + 1.0) - derivatives[std::size_t(n) + 1];
    derivatives.pop_back();
    return derivatives;
}
template std::vector<double> logarithmic_derivatives(double, int);
template std::vector<std::complex<double>> logarithmic_derivatives(std::complex<double>, int);

RiccatiBessel riccati_bessel(double x, int N) {
    const std::size_t size = std::size_t(N) + 1;
    const std::vector<double> ratios = psi_ratios(x, N + 1);
    RiccatiBessel waves;
    waves.psi.resize(size);
    waves.chi.resize(size + 1);
    waves.chi[0] = std::cos(x);
    waves.chi[1] = std::cos(x) / x + std::sin(x);
    for (std::size_t n = 1; n < size; ++n)
        waves.chi[n + 1] = (2.0 * double(n) + 1.0) / x * waves.chi[n] - waves.chi[n - 1];
    for (std::size_t n = 0; n < size; ++n)
        waves.psi[n] = 1.0 / (waves.chi[n + 1] - ratios[n + 1] * waves.chi[n]);
    waves.chi.pop_back();
    return waves;
}

std::vector<std::complex<double>> outgoing_derivatives(double x, const RiccatiBessel& waves) {
    std::vector<std::complex<double>> derivatives(waves.psi.size());
    // ψ_{−1} = cos x = χ_0, χ_{−1} = −sin x = −ψ_0.
    double psi_before = waves.chi[0], chi_before = -waves.psi[0];
    for (std::size_t n = 0; n < waves.psi.size(); ++n) {
        const double psi = waves.psi[n], chi = waves.chi[n], norm = psi * psi + chi * chi;
        derivatives[n] = {(psi * psi_before + chi * chi_before) / norm - double(n) / x, 1.0 / norm};
        psi_before = psi;
        chi_before = chi;
    }
    return derivatives;
}

}  // namespace dewbow
