// SPDX-License-Identifier: Apache-2.0

// The classic formulas of few constants that hold in and near the visible. λ in µm.

#include <algorithm>
#include <array>

#include "dewbow/optics/dispersion/forms.h"
#include "dewbow/optics/dispersion/formula.h"

namespace dewbow::dispersion {
namespace {

/// n = A + B L + C L² + D x + E x² + F x³, x = λ², L = 1 / (x − 0.028 µm²).
///                                       [Herzberger 1959; AGF formula 3; refractiveindex.info 7]
struct Herzberger {
    std::array<double, 6> c{};

    template <class V>
    V index(V lambda_um) const {
        const V x = lambda_um * lambda_um, L = 1.0 / (x - 0.028);
        return c[0] + L * (c[1] + L * c[2]) + x * (c[3] + x * (c[4] + x * c[5]));
    }
    bool is_constant() const { return false; }
};

/// n = n0 + A / λ + B / λ^3.5.                                       [Conrady 1929; AGF formula 5]
struct Conrady {
    double n0 = 0.0, A = 0.0, B = 0.0;

    template <class V>
    V index(V l) const {
        return n0 + A / l + B / (l * l * l * square_root(l));
    }
    bool is_constant() const { return false; }
};

/// n = n0 + b / (λ − c)^p.                      [Hartmann 1898, p about 1.2; Musgrave 1989: n0 = 1,
///                                               p = 1, and his b / (c − λ) has the other sign]
struct Hartmann {
    double n0 = 0.0, b = 0.0, c = 0.0, p = 1.0;

    template <class V>
    V index(V l) const {
        return n0 + b / power(l - c, p);
    }
    bool is_constant() const { return false; }
};

}  // namespace

DispersionPtr make_herzberger(const DispersionData& data) {
    Herzberger formula;
    std::copy_n(padded(data.coefficients, 6).begin(), 6, formula.c.begin());
    return checked(data, formula);
}
DispersionPtr make_agf_3(const DispersionData& data) { return make_herzberger(data); }

DispersionPtr make_conrady(const DispersionData& data) {
    const Coefficients c = padded(data.coefficients, 3);
    return checked(data, Conrady{c[0], c[1], c[2]});
}
DispersionPtr make_agf_5(const DispersionData& data) { return make_conrady(data); }

DispersionPtr make_hartmann(const DispersionData& data) {
    const Coefficients& c = data.coefficients;
    return checked(data, Hartmann{c[0], c[1], c[2], c.size() > 3 ? c[3] : 1.0});
}

}  // namespace dewbow::dispersion
