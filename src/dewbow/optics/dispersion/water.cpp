// SPDX-License-Identifier: Apache-2.0

// Water by temperature and salinity.

#include <fmt/format.h>

#include "dewbow/base/error.h"
#include "dewbow/optics/dispersion/forms.h"
#include "dewbow/optics/dispersion/formula.h"

namespace dewbow::dispersion {
namespace {

constexpr double kFreezing_K = 273.15;
/// Liquid at one atmosphere; the release itself holds from −12 °C to 500 °C and up to 1060 kg/m³.
constexpr double kColdest_C = 0.0, kHottest_C = 100.0;
constexpr double kColdestAtDensity_C = -12.0, kHottestAtDensity_C = 500.0;
constexpr double kDensest_kg_m3 = 1060.0;
/// Of the measurements of sea water.
constexpr double kHottestSea_C = 30.0, kSaltiest_g_kg = 35.0;

/// Density of air-free water at 101325 Pa, kg/m³; t in °C, 0 to 100. Error: 0.006 kg/m³, 2e-6 in n.
///                                                        [G. S. Kell, J. Chem. Eng. Data 20, 97
///                                                        (1975)]
double density_at_one_atmosphere(double t) {
    return (999.83952 +
            t * (16.945176 + t * (-7.9870401e-3 +
                                  t * (-46.170461e-6 + t * (105.56302e-9 - t * 280.54253e-12))))) /
           (1.0 + 16.879850e-3 * t);
}

/// (n² − 1) / (n² + 2) = ρ (a0 + a1 ρ + a2 T + a3 T l + a4/l + a5/(l − l_uv) + a6/(l − l_ir) + a7
/// ρ²) with ρ in 1000 kg/m³, T in 273.15 K, l = λ² in (0.589 µm)².              [IAPWS R9-97, eq.
/// 1]
struct Water {
    double scale = 0.0, constant = 0.0, linear = 0.0;  ///< ρ; what does not depend on l; of l

    Water(double temperature_C, double density_kg_m3) {
        const double T = (temperature_C + kFreezing_K) / 273.15, rho = density_kg_m3 / 1000.0;
        scale = rho;
        constant =
            0.244257733 + 9.74634476e-3 * rho - 3.73234996e-3 * T - 1.66626219e-2 * rho * rho;
        linear = 2.68678472e-4 * T;
    }
    template <class V>
    V index(V lambda_um) const {
        constexpr double kUltraviolet = 0.229202 * 0.229202, kInfrared = 5.432937 * 5.432937;
        const V l = lambda_um * lambda_um / (0.589 * 0.589);
        const V a = scale * (constant + linear * l + 1.58920570e-3 / l +
                             2.45934259e-3 / (l - kUltraviolet) + 0.900704920 / (l - kInfrared));
        return square_root((1.0 + 2.0 * a) / (1.0 - a));
    }
    bool is_constant() const { return false; }
};

/// What sea salt adds to the index: ((n1 + n2 t + n3 t²) + n6 / λ) S, from 400 to 700 nm; t in °C,
/// S in g/kg, λ in nm. The fit is of an index against air, which is 2e-6 less than against vacuum;
/// its error is 1e-5 at S = 35, and beyond 700 nm it goes on as 1/λ.
///                                  [X. Quan and E. S. Fry, Appl. Opt. 34, 3477 (1995), eq. 3,
///                                  table 1]
struct SeaWater {
    Water pure;
    double flat = 0.0, per_um = 0.0;

    SeaWater(double t, double salinity)
        : pure(t, density_at_one_atmosphere(t)),
          flat((1.779e-4 + t * (-1.05e-6 + t * 1.6e-8)) * salinity),
          per_um(0.01155e-3 * salinity) {}
    template <class V>
    V index(V lambda_um) const {
        return pure.index(lambda_um) + (flat + per_um / lambda_um);
    }
    bool is_constant() const { return false; }
};

void check_temperature(double t, double coldest, double hottest) {
    if (t >= coldest && t <= hottest) return;
    throw InputError(fmt::format("water of {} °C; expected {} to {} °C", t, coldest, hottest));
}

}  // namespace

DispersionPtr make_water(const DispersionData& data) {
    const double t = data.coefficients[0];
    const bool has_density = data.coefficients.size() > 1;
    check_temperature(t, has_density ? kColdestAtDensity_C : kColdest_C,
                      has_density ? kHottestAtDensity_C : kHottest_C);
    const double density = has_density ? data.coefficients[1] : density_at_one_atmosphere(t);
    if (!(density > 0.0 && density <= kDensest_kg_m3))
        throw InputError(
            fmt::format("water of {} kg/m³; expected above 0 to {}", density, kDensest_kg_m3));
    return checked(data.form, Water(t, density), data.range.value_or(DataRange{200.0, 1100.0}));
}

DispersionPtr make_sea_water(const DispersionData& data) {
    const double t = data.coefficients[0], salinity = data.coefficients[1];
    check_temperature(t, kColdest_C, kHottestSea_C);
    if (!(salinity >= 0.0 && salinity <= kSaltiest_g_kg))
        throw InputError(
            fmt::format("sea water of {} g/kg salt; expected 0 to {}", salinity, kSaltiest_g_kg));
    return checked(data.form, SeaWater(t, salinity), data.range.value_or(DataRange{200.0, 1100.0}));
}

}  // namespace dewbow::dispersion
