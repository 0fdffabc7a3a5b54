// SPDX-License-Identifier: Apache-2.0
// Compiled with -O3 -ffast-math, as those who time MIEV0 compile it (CMakeLists.txt).
#include "micro/wiscombe_mie.h"

#include <cmath>
#include <vector>

namespace dewbow::bench {
namespace {

using Complex = std::complex<double>;

/// Orders that are summed.                                       [Wiscombe 1980, p. 1508]
int wiscombe_terms(double x) {
    const double root = std::cbrt(x);
    if (x <= 8.0) return int(x + 4.0 * root + 1.0);
    return int(x + (x < 4200.0 ? 4.05 : 4.0) * root + 2.0);
}

/// A_n(z) = ψ_n'(z) / ψ_n(z) upwards, which is stable for real z at the orders that count.
std::vector<double> logarithmic_derivatives_up(double z, int terms) {
    std::vector<double> A(std::size_t(terms) + 1);
    A[0] = std::cos(z) / std::sin(z);
    for (int n = 1; n <= terms; ++n) {
        const double r = n / z;
        A[std::size_t(n)] = 1.0 / (r - A[std::size_t(n) - 1]) - r;
    }
    return A;
}

/// Sums over orders at all angles: S⁺ and S⁻, and for symmetric angles those of 180° − θ.
class AngularSums {
public:
    AngularSums(std::span<const double> mu, bool symmetric)
        : mu_(mu),
          count_(symmetric ? (mu.size() + 1) / 2 : mu.size()),
          pi_(count_, 1.0),
          before_(count_),
          plus_(count_),
          minus_(count_),
          plus_back_(symmetric ? count_ : 0),
          minus_back_(symmetric ? count_ : 0) {}

    void add(int n, Complex a, Complex b) {
        const double order = n, c = (2.0 * order + 1.0) / (order * (order + 1.0));
        const double step = (order + 1.0) / order;
        const Complex p = c * (a + b), m = c * (a - b);
        if (plus_back_.empty())
            add_all(order, step, p, m);
        else
            add_half(order, step, p, m, n % 2 ? 1.0 : -1.0);
    }

    void write(std::span<Complex> S1, std::span<Complex> S2) const {
        for (std::size_t i = 0; i < count_; ++i) {
            S1[i] = 0.5 * (plus_[i] + minus_[i]);
            S2[i] = 0.5 * (plus_[i] - minus_[i]);
        }
        for (std::size_t i = 0; i < plus_back_.size(); ++i) {
            const std::size_t mirrored = mu_.size() - 1 - i;
            S1[mirrored] = 0.5 * (plus_back_[i] + minus_back_[i]);
            S2[mirrored] = 0.5 * (plus_back_[i] - minus_back_[i]);
        }
    }

private:
    void add_all(double order, double step, Complex p, Complex m) {
        for (std::size_t i = 0; i < count_; ++i) {
            const double s = mu_[i] * pi_[i], t = s - before_[i], tau = order * t - before_[i];
            plus_[i] += p * (pi_[i] + tau);
            minus_[i] += m * (pi_[i] - tau);
            before_[i] = pi_[i];
            pi_[i] = s + step * t;
        }
    }
    void add_half(double order, double step, Complex p, Complex m, double sign) {
        const Complex p_back = sign * p, m_back = sign * m;
        for (std::size_t i = 0; i < count_; ++i) {
            const double s = mu_[i] * pi_[i], t = s - before_[i], tau = order * t - before_[i];
            plus_[i] += p * (pi_[i] + tau);
            minus_back_[i] += m_back * (pi_[i] + tau);
            minus_[i] += m * (pi_[i] - tau);
            plus_back_[i] += p_back * (pi_[i] - tau);
            before_[i] = pi_[i];
            pi_[i] = s + step * t;
        }
    }

    std::span<const double> mu_;
    std::size_t count_;
    std::vector<double> pi_, before_;
    std::vector<Complex> plus_, minus_, plus_back_, minus_back_;
};

}  // namespace

WiscombeResult wiscombe_mie(double x, double index, std::span<const double> mu, bool symmetric,
                            std::span<Complex> S1, std::span<Complex> S2) {
    const int terms = wiscombe_terms(x);
    const std::vector<double> A = logarithmic_derivatives_up(index * x, terms);
    AngularSums sums(mu, symmetric);
    double psi_before = std::sin(x), chi_before = std::cos(x);
    double psi = psi_before / x - chi_before, chi = chi_before / x + psi_before;
    Complex a_before{}, b_before{};
    WiscombeResult Q;
    for (int n = 1; n <= terms; ++n) {
        const double order = n, A_n = A[std::size_t(n)];
        const double electric = A_n / index + order / x, magnetic = index * A_n + order / x;
        const double an = electric * psi - psi_before, bn = magnetic * psi - psi_before;
        const Complex a = an / Complex(an, electric * chi - chi_before);
        const Complex b = bn / Complex(bn, magnetic * chi - chi_before);
        Q.extinction += (2.0 * order + 1.0) * (a.real() + b.real());
        Q.scattering += (2.0 * order + 1.0) * (std::norm(a) + std::norm(b));
        Q.asymmetry += (order - 1.0) * (order + 1.0) / order *
                           (a_before * std::conj(a) + b_before * std::conj(b)).real() +
                       (2.0 * order + 1.0) / (order * (order + 1.0)) * (a * std::conj(b)).real();
        sums.add(n, a, b);
        a_before = a;
        b_before = b;
        const double psi_next = (2.0 * order + 1.0) / x * psi - psi_before;
        const double chi_next = (2.0 * order + 1.0) / x * chi - chi_before;
        psi_before = psi;
        psi = psi_next;
        chi_before = chi;
        chi = chi_next;
    }
    sums.write(S1, S2);
    Q.asymmetry *= 2.0 / Q.scattering;
    Q.extinction *= 2.0 / (x * x);
    Q.scattering *= 2.0 / (x * x);
    return Q;
}

}  // namespace dewbow::bench
