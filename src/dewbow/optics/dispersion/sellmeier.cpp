// SPDX-License-Identifier: Apache-2.0

// Formulas with resonances: n² is a sum of terms that have a pole each. x = λ², λ in µm.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "dewbow/base/error.h"
#include "dewbow/optics/dispersion/forms.h"
#include "dewbow/optics/dispersion/formula.h"

namespace dewbow::dispersion {
namespace {

/// n² = 1 + a + Σ B x / (x − C).                                              [Sellmeier 1871]
struct Sellmeier {
    double offset = 0.0;  ///< a
    std::array<double, kMostResonances> B{}, C{};
    std::size_t terms = 0;

    void add(double strength, double squared_resonance) {
        B[terms] = strength;
        C[terms++] = squared_resonance;
    }
    template <class V>
    V index(V lambda_um) const {
        const V x = lambda_um * lambda_um;
        V n2 = V{} + (1.0 + offset);
        for (std::size_t t = 0; t < terms; ++t) n2 += B[t] * x / (x - C[t]);
        return square_root(n2);
    }
    bool is_constant() const { return false; }
};

/// A resonance among the wavelengths that are seen could lie between two that are checked.
void refuse_visible_resonance(const DispersionData& data, double C) {
    const double lambda_nm = C > 0.0 ? 1e3 * std::sqrt(C) : 0.0;
    const DataRange range = range_of(data);
    const double from_nm = std::max(range.min_nm, kLambdaMin_nm);
    const double to_nm = std::min(range.max_nm, kLambdaMax_nm);
    if (lambda_nm < from_nm || lambda_nm > to_nm) return;
    throw InputError(
        fmt::format("{}: C = {} µm² puts a resonance at {:.1f} nm; expected none in {} to {} nm",
                    data.form, C, lambda_nm, from_nm, to_nm));
}

DispersionPtr checked_sellmeier(const DispersionData& data, const Sellmeier& formula) {
    for (std::size_t t = 0; t < formula.terms; ++t)
        if (formula.B[t] != 0.0) refuse_visible_resonance(data, formula.C[t]);
    return checked(data, formula);
}

/// n² = A + B / (x − C) − D x.                              [Handbook of Optics 1; AGF formula 7]
struct Handbook1 {
    double A = 0.0, B = 0.0, C = 0.0, D = 0.0;

    template <class V>
    V index(V lambda_um) const {
        const V x = lambda_um * lambda_um;
        return square_root(A + B / (x - C) - D * x);
    }
    bool is_constant() const { return false; }
};

/// n² = A + B x / (x − C) − D x.                            [Handbook of Optics 2; AGF formula 8]
struct Handbook2 {
    double A = 0.0, B = 0.0, C = 0.0, D = 0.0;

    template <class V>
    V index(V lambda_um) const {
        const V x = lambda_um * lambda_um;
        return square_root(A + B * x / (x - C) - D * x);
    }
    bool is_constant() const { return false; }
};

/// n² = 1 + A + B1 x / (x − λ1²) + B2 / (x − λ2²).                     [Sellmeier 2; AGF formula 4]
struct Sellmeier2 {
    double A = 0.0, B1 = 0.0, x1 = 0.0, B2 = 0.0, x2 = 0.0;

    template <class V>
    V index(V lambda_um) const {
        const V x = lambda_um * lambda_um;
        return square_root(1.0 + A + B1 * x / (x - x1) + B2 / (x - x2));
    }
    bool is_constant() const { return false; }
};

/// What refractiveindex.info's formulas 1 and 2 begin with: the offset, then pairs.
Coefficients offset_and_pairs(const DispersionData& data) {
    return padded(data.coefficients, data.coefficients.size() | 1);
}

}  // namespace

DispersionPtr make_sellmeier(const DispersionData& data) {
    const Coefficients& c = data.coefficients;
    if (c.size() % 2 != 0)
        throw InputError(
            fmt::format("{}: {} coefficients; expected pairs B, C", data.form, c.size()));
    Sellmeier formula;
    for (std::size_t i = 0; i < c.size(); i += 2) formula.add(c[i], c[i + 1]);
    return checked_sellmeier(data, formula);
}

template <int pairs>
DispersionPtr make_agf_sellmeier(const DispersionData& data) {
    const Coefficients c = padded(data.coefficients, 2 * pairs);
    Sellmeier formula;
    for (std::size_t i = 0; i < c.size(); i += 2) formula.add(c[i], c[i + 1]);
    return checked_sellmeier(data, formula);
}
template DispersionPtr make_agf_sellmeier<3>(const DispersionData&);
template DispersionPtr make_agf_sellmeier<4>(const DispersionData&);
template DispersionPtr make_agf_sellmeier<5>(const DispersionData&);

DispersionPtr make_handbook_1(const DispersionData& data) {
    const Coefficients& c = data.coefficients;
    return checked(data, Handbook1{c[0], c[1], c[2], c[3]});
}

DispersionPtr make_agf_4(const DispersionData& data) {
    const Coefficients c = padded(data.coefficients, 5);
    return checked(data, Sellmeier2{c[0], c[1], c[2] * c[2], c[3], c[4] * c[4]});
}

DispersionPtr make_agf_7(const DispersionData& data) {
    const Coefficients c = padded(data.coefficients, 4);
    return checked(data, Handbook1{c[0], c[1], c[2], c[3]});
}

DispersionPtr make_agf_8(const DispersionData& data) {
    const Coefficients c = padded(data.coefficients, 4);
    return checked(data, Handbook2{c[0], c[1], c[2], c[3]});
}

/// n² = A + B x / (x − C) + D x / (x − E).                                            [Sellmeier 4]
DispersionPtr make_agf_9(const DispersionData& data) {
    const Coefficients c = padded(data.coefficients, 5);
    Sellmeier formula;
    formula.offset = c[0] - 1.0;
    formula.add(c[1], c[2]);
    formula.add(c[3], c[4]);
    return checked_sellmeier(data, formula);
}

/// n² = 1 + C1 + Σ C x / (x − C'²): resonances as wavelengths.
DispersionPtr make_rii_1(const DispersionData& data) {
    const Coefficients c = offset_and_pairs(data);
    Sellmeier formula;
    formula.offset = c[0];
    for (std::size_t i = 1; i < c.size(); i += 2) formula.add(c[i], c[i + 1] * c[i + 1]);
    return checked_sellmeier(data, formula);
}

/// n² = 1 + C1 + Σ C x / (x − C'): resonances as squares.
DispersionPtr make_rii_2(const DispersionData& data) {
    const Coefficients c = offset_and_pairs(data);
    Sellmeier formula;
    formula.offset = c[0];
    for (std::size_t i = 1; i < c.size(); i += 2) formula.add(c[i], c[i + 1]);
    return checked_sellmeier(data, formula);
}

}  // namespace dewbow::dispersion
