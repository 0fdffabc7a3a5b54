// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/air_optics.h"

#include <cmath>
#include <numbers>

namespace dewbow {

AirOptics air_optics(const ClearSky& sky, Wavelength lambda) {
    constexpr double kStandardPressure_hPa = 1013.25;
    AirOptics optics;
    optics.depth.air = rayleigh_depth(lambda) * sky.pressure_hPa / kStandardPressure_hPa;
    optics.depth.haze =
        sky.aerosol_depth_500nm * std::pow(lambda.to(500.0 * unit::nm), -sky.angstrom_exponent);
    optics.depth.ozone = ozone_depth(lambda, sky.ozone_dobson);
    optics.haze_scattering = optics.depth.haze * sky.aerosol_albedo;
    return optics;
}

double air_phase(double cosine) {
    constexpr double g = kAirAnisotropy;
    return 3.0 * (1.0 + 3.0 * g + (1.0 - g) * cosine * cosine) /
           (16.0 * std::numbers::pi * (1.0 + 2.0 * g));
}

double haze_phase(double cosine, double asymmetry) {
    const double g = asymmetry, base = 1.0 + g * g - 2.0 * g * cosine;
    return (1.0 - g * g) / (4.0 * std::numbers::pi * base * std::sqrt(base));
}

}  // namespace dewbow
