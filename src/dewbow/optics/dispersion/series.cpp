// SPDX-License-Identifier: Apache-2.0

// Series in whole powers of x = λ², λ in µm, by Horner's rule.

#include <algorithm>
#include <array>

#include "dewbow/optics/dispersion/forms.h"
#include "dewbow/optics/dispersion/formula.h"

namespace dewbow::dispersion {
namespace {

/// n = A + B / x + C / x² + …                                                     [Cauchy 1836]
struct Cauchy {
    std::array<double, kMostCauchy> c{};

    template <class V>
    V index(V lambda_um) const {
        const V inverse_x = 1.0 / (lambda_um * lambda_um);
        V n = V{} + c[kMostCauchy - 1];
        for (std::size_t t = kMostCauchy - 1; t-- > 0;) n = n * inverse_x + c[t];
        return n;
    }
    bool is_constant() const {
        return std::all_of(c.begin() + 1, c.end(), [](double v) { return v == 0.0; });
    }
};

/// n² = Σ c x^power, power = −6 … 3.
struct PowerSeries {
    std::array<double, 4> rising{};   ///< of 1, x, x², x³
    std::array<double, 6> falling{};  ///< of 1/x, 1/x², …

    template <class V>
    V index(V lambda_um) const {
        const V x = lambda_um * lambda_um, inverse_x = 1.0 / x;
        V sum{};
        for (std::size_t t = falling.size(); t-- > 0;) sum = (sum + falling[t]) * inverse_x;
        return square_root(sum + (rising[0] + x * (rising[1] + x * (rising[2] + x * rising[3]))));
    }
    bool is_constant() const { return false; }
};

/// The first `rising` coefficients are of 1, x, …, the next `falling` of 1/x, 1/x², …
PowerSeries power_series(const Coefficients& c, std::size_t rising, std::size_t falling) {
    const Coefficients all = padded(c, std::max(rising + falling, c.size()));
    PowerSeries formula;
    std::copy_n(all.begin(), rising, formula.rising.begin());
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(rising), falling,
                formula.falling.begin());
    return formula;
}

}  // namespace

DispersionPtr make_cauchy(const DispersionData& data) {
    Cauchy formula;
    std::copy(data.coefficients.begin(), data.coefficients.end(), formula.c.begin());
    return checked(data, formula);
}

/// n² = a0 + a1 x + a2/x + a3/x² + a4/x³ + a5/x⁴ …       [Schott 1966; AGF formulas 1 and 10]
DispersionPtr make_schott(const DispersionData& data) {
    return checked(data, power_series(data.coefficients, 2, 6));
}
DispersionPtr make_agf_1(const DispersionData& data) {
    return checked(data, power_series(data.coefficients, 2, 4));
}
DispersionPtr make_agf_10(const DispersionData& data) { return make_schott(data); }

/// As formula 1, then a6 x² + a7 x³.                                              [AGF formula 12]
DispersionPtr make_agf_12(const DispersionData& data) {
    const Coefficients c = padded(data.coefficients, 8);
    PowerSeries formula = power_series(c, 2, 4);
    formula.rising[2] = c[6];
    formula.rising[3] = c[7];
    return checked(data, formula);
}

/// n² = a0 + a1 x + a2 x² + a3/x + a4/x² + … + a8/x⁶.                            [AGF formula 13]
DispersionPtr make_extended_3(const DispersionData& data) {
    return checked(data, power_series(data.coefficients, 3, 6));
}
DispersionPtr make_agf_13(const DispersionData& data) { return make_extended_3(data); }

}  // namespace dewbow::dispersion
