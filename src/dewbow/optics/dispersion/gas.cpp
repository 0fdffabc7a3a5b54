// SPDX-License-Identifier: Apache-2.0

// Gases, air among them.

#include <fmt/format.h>

#include <array>

#include "dewbow/base/error.h"
#include "dewbow/optics/dispersion/forms.h"
#include "dewbow/optics/dispersion/formula.h"

namespace dewbow {
namespace dispersion {
namespace {

/// n − 1 = C1 + Σ B / (C − 1/λ²).             [Ciddor 1996, eq. 1; refractiveindex.info formula 6]
struct Gas {
    double offset = 0.0;  ///< C1
    std::array<double, kMostGasTerms> B{}, C{};
    std::size_t terms = 0;

    void add_pairs(const Coefficients& c, std::size_t first) {
        for (std::size_t i = first; i < c.size(); i += 2) {
            B[terms] = c[i];
            C[terms++] = c[i + 1];
        }
    }
    template <class V>
    V index(V lambda_um) const {
        const V inverse_x = 1.0 / (lambda_um * lambda_um);
        V sum = V{} + offset;
        for (std::size_t t = 0; t < terms; ++t) sum += B[t] / (C[t] - inverse_x);
        return 1.0 + sum;
    }
    bool is_constant() const { return false; }
};

}  // namespace

DispersionPtr make_gas(const DispersionData& data) {
    const Coefficients& c = data.coefficients;
    if (c.size() % 2 != 0)
        throw InputError(
            fmt::format("{}: {} coefficients; expected pairs B, C", data.form, c.size()));
    Gas formula;
    formula.add_pairs(c, 0);
    return checked(data, formula);
}

DispersionPtr make_rii_6(const DispersionData& data) {
    const Coefficients c = padded(data.coefficients, data.coefficients.size() | 1);
    Gas formula;
    formula.offset = c[0];
    formula.add_pairs(c, 1);
    return checked(data, formula);
}

}  // namespace dispersion

namespace {

// Ciddor's dispersion of standard air (15 °C, 101325 Pa, dry, 450 ppm CO2), in µm⁻²  [Ciddor 1996,
// eq. 1]
constexpr double kCiddorB1 = 0.05792105, kCiddorC1 = 238.0185;
constexpr double kCiddorB2 = 0.00167917, kCiddorC2 = 57.362;

/// Compressibility of dry air, Z = pV/(nRT).                 [Ciddor 1996, appendix A, x_w = 0]
constexpr double compressibility(double temperature_K, double pressure_Pa) {
    const double t = temperature_K - 273.15, p_T = pressure_Pa / temperature_K;
    return 1.0 - p_T * (1.58123e-6 - 2.9331e-8 * t + 1.1043e-10 * t * t) + 1.83e-11 * p_T * p_T;
}

/// Density at 20 °C over that at 15 °C, ρ ∝ p / (Z T); n − 1 goes with it.   [Ciddor 1996, eq. 5]
constexpr double kDensityRatio =
    288.15 * compressibility(288.15, 101325.0) / (293.15 * compressibility(293.15, 101325.0));

}  // namespace

DispersionPtr air() {
    static const DispersionPtr standard = dispersion::make_gas(
        {"gas",
         {kDensityRatio * kCiddorB1, kCiddorC1, kDensityRatio * kCiddorB2, kCiddorC2},
         IndexReference::vacuum,
         DataRange{230.0, 1690.0}});
    return standard;
}

}  // namespace dewbow
