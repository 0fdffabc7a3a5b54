// SPDX-License-Identifier: Apache-2.0

// Formulas of refractiveindex.info with exponents that are coefficients, and its odd ones; their
// numbers are those of its page "Dispersion formulas" (2014-06-29). x = λ², λ in µm.

#include <algorithm>
#include <array>

#include "dewbow/optics/dispersion/forms.h"
#include "dewbow/optics/dispersion/formula.h"

namespace dewbow::dispersion {
namespace {

/// Σ c λ^p. Terms whose coefficient is 0 do not exist.
struct Powers {
    std::array<double, kMostPowers> c{}, p{};
    std::size_t terms = 0;

    void add(double coefficient, double exponent) {
        if (coefficient == 0.0) return;
        c[terms] = coefficient;
        p[terms++] = exponent;
    }
    /// Pairs from `first` on.
    static Powers from(const Coefficients& coefficients, std::size_t first) {
        Powers powers;
        const Coefficients all = padded(coefficients, std::max(coefficients.size() | 1, first));
        for (std::size_t i = first; i + 1 < all.size(); i += 2) powers.add(all[i], all[i + 1]);
        return powers;
    }
    template <class V>
    V sum(V lambda_um) const {
        V total{};
        for (std::size_t t = 0; t < terms; ++t) total += c[t] * power(lambda_um, p[t]);
        return total;
    }
};

/// n² = C1 + Σ C λ^C'.                                                                 [formula 3]
struct SquarePolynomial {
    double constant = 0.0;
    Powers powers;

    template <class V>
    V index(V lambda_um) const {
        return square_root(constant + powers.sum(lambda_um));
    }
    bool is_constant() const { return powers.terms == 0; }
};

/// n = C1 + Σ C λ^C'; the paper's Conrady, a + b/λ + c/λ², is [a, b, −1, c, −2].       [formula 5]
struct Polynomial {
    double constant = 0.0;
    Powers powers;

    template <class V>
    V index(V lambda_um) const {
        return constant + powers.sum(lambda_um);
    }
    bool is_constant() const { return powers.terms == 0; }
};

/// C λ^p / (x − q).
struct Fraction {
    double c = 0.0, p = 0.0, q = 0.0;

    template <class V>
    V at(V lambda_um) const {
        if (c == 0.0) return V{};
        return c * power(lambda_um, p) / (lambda_um * lambda_um - q);
    }
};

/// n² = C1 + C2 λ^C3 / (x − C4^C5) + C6 λ^C7 / (x − C8^C9) + Σ C λ^C'.                 [formula 4]
struct Mixed {
    double constant = 0.0;
    Fraction first, second;
    Powers powers;

    template <class V>
    V index(V lambda_um) const {
        return square_root(constant + first.at(lambda_um) + second.at(lambda_um) +
                           powers.sum(lambda_um));
    }
    bool is_constant() const { return false; }
};

/// (n² − 1) / (n² + 2) = C1 + C2 x / (x − C3) + C4 x.                                  [formula 8]
struct Retro {
    double C1 = 0.0, C2 = 0.0, C3 = 0.0, C4 = 0.0;

    template <class V>
    V index(V lambda_um) const {
        const V x = lambda_um * lambda_um;
        const V a = C1 + C2 * x / (x - C3) + C4 * x;
        return square_root((1.0 + 2.0 * a) / (1.0 - a));
    }
    bool is_constant() const { return false; }
};

/// n² = C1 + C2 / (x − C3) + C4 (λ − C5) / ((λ − C5)² + C6).                           [formula 9]
struct Exotic {
    double C1 = 0.0, C2 = 0.0, C3 = 0.0, C4 = 0.0, C5 = 0.0, C6 = 0.0;

    template <class V>
    V index(V lambda_um) const {
        const V x = lambda_um * lambda_um, d = lambda_um - C5;
        return square_root(C1 + C2 / (x - C3) + C4 * d / (d * d + C6));
    }
    bool is_constant() const { return false; }
};

}  // namespace

DispersionPtr make_rii_3(const DispersionData& data) {
    return checked(data,
                   SquarePolynomial{data.coefficients[0], Powers::from(data.coefficients, 1)});
}

DispersionPtr make_rii_5(const DispersionData& data) {
    return checked(data, Polynomial{data.coefficients[0], Powers::from(data.coefficients, 1)});
}

DispersionPtr make_rii_4(const DispersionData& data) {
    const Coefficients c =
        padded(data.coefficients, std::max<std::size_t>(9, data.coefficients.size()));
    return checked(data, Mixed{c[0],
                               {c[1], c[2], std::pow(c[3], c[4])},
                               {c[5], c[6], std::pow(c[7], c[8])},
                               Powers::from(c, 9)});
}

DispersionPtr make_rii_8(const DispersionData& data) {
    const Coefficients c = padded(data.coefficients, 4);
    return checked(data, Retro{c[0], c[1], c[2], c[3]});
}

DispersionPtr make_rii_9(const DispersionData& data) {
    const Coefficients c = padded(data.coefficients, 6);
    return checked(data, Exotic{c[0], c[1], c[2], c[3], c[4], c[5]});
}

}  // namespace dewbow::dispersion
