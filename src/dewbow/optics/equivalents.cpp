// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/equivalents.h"

#include <algorithm>
#include <cmath>

namespace dewbow {
namespace {

constexpr double kSodium_nm = 589.2938;                            ///< D
constexpr double kFireViolet_nm = 430.774, kFireRed_nm = 686.719;  ///< G and B
constexpr double kPovViolet_nm = 380.0, kPovRed_nm = 730.0;

/// 1/λ² in µm⁻².
double w(double lambda_nm) { return 1e6 / (lambda_nm * lambda_nm); }

double spread(const IndexInAir& n) { return n(kAirF_nm) - n(kAirC_nm); }
double abbe(const IndexInAir& n) { return (n(kAird_nm) - 1.0) / spread(n); }
double gltf(const IndexInAir& n) { return 20.0 / abbe(n); }
double fire(const IndexInAir& n) { return n(kFireViolet_nm) - n(kFireRed_nm); }
double pov_ratio(const IndexInAir& n) { return n(kPovViolet_nm) / n(kPovRed_nm); }
double cauchy_b(const IndexInAir& n) { return spread(n) / (w(kAirF_nm) - w(kAirC_nm)); }

double b_of_spread(double, double value) { return value / (w(kAirF_nm) - w(kAirC_nm)); }
double b_of_abbe(double n_d, double value) { return b_of_spread(n_d, (n_d - 1.0) / value); }
double b_of_gltf(double n_d, double value) { return b_of_abbe(n_d, 20.0 / value); }
double b_of_fire(double, double value) { return value / (w(kFireViolet_nm) - w(kFireRed_nm)); }
double b_of_cauchy(double, double value) { return value; }

/// From p (n_d + B (w_D − w_d) − 1) = B (w_F − w_C).
double b_of_power(double n_d, double p) {
    return p * (n_d - 1.0) / (w(kAirF_nm) - w(kAirC_nm) - p * (w(kSodium_nm) - w(kAird_nm)));
}

/// From n_d + B (w_v − w_d) = r (n_d + B (w_r − w_d)).
double b_of_pov_ratio(double n_d, double r) {
    const double violet = w(kPovViolet_nm) - w(kAird_nm), red = w(kPovRed_nm) - w(kAird_nm);
    return n_d * (r - 1.0) / (violet - r * red);
}

}  // namespace

double dispersive_power(const IndexInAir& n) { return spread(n) / (n(kSodium_nm) - 1.0); }

IndexInAir two_terms(double n_d, double b_um2) {
    return [=](double lambda_nm) { return n_d + b_um2 * (w(lambda_nm) - w(kAird_nm)); };
}

IndexInAir index_in_air(const DispersionPtr& dispersion) {
    return [dispersion](double lambda_air_nm) {
        const Wavelength lambda = vacuum_wavelength(lambda_air_nm);
        return (*dispersion)(lambda).value / (*air())(lambda).value;
    };
}

const std::vector<DispersionUnit>& dispersion_units() {
    static const std::vector<DispersionUnit> units{
        {"abbe", "V_d = (n_d − 1)/(n_F − n_C): glass makers, OpenPBR, MDL", abbe, b_of_abbe},
        {"gltf", "20/V_d: glTF KHR_materials_dispersion", gltf, b_of_gltf},
        {"w", "(n_F − n_C)/(n_D − 1): Musgrave 1989, eq. 2", dispersive_power, b_of_power},
        {"pov_ray", "n at 380 nm over n at 730 nm: POV-Ray's dispersion", pov_ratio,
         b_of_pov_ratio},
        {"cauchy_b", "B of n = A + B/λ² in µm²: LuxCore, whose ior is A", cauchy_b, b_of_cauchy},
        {"spread", "n_F − n_C", spread, b_of_spread},
        {"fire", "n_G − n_B: gemmologists", fire, b_of_fire},
    };
    return units;
}

double partial_dispersion(const IndexInAir& n, double x_air_nm, double y_air_nm) {
    return (n(x_air_nm) - n(y_air_nm)) / spread(n);
}

double worst_difference(const IndexInAir& n, const IndexInAir& of_glass) {
    double worst = 0.0;
    for (double l = 400.0; l <= 700.0; l += 1.0)
        worst = std::max(worst, std::abs(n(l) - of_glass(l)));
    return worst;
}

}  // namespace dewbow
