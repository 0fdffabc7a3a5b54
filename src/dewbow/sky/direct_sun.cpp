// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/direct_sun.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dewbow/base/error.h"
#include "dewbow/math/interpolation.h"
#include "dewbow/sky/air_optics.h"
#include "dewbow/spectrum/lanewise.h"

namespace dewbow {
namespace {

/// Molecules per m² of one Dobson unit.
constexpr double kDobson_per_m2 = 2.6867e20;

constexpr double kMostDepth = 5.0;  ///< of haze
/// −ln of the contrast that is just seen, 2 %.
const double kKoschmieder = -std::log(0.02);

/// Absorption cross section of a molecule of ozone, m², in bins of 10 nm from 360 nm.
constexpr double kFirstOzoneBin_nm = 365.0, kOzoneBin_nm = 10.0;
constexpr std::array<double, 48> kOzone_m2 = {
    1.18e-27,  2.182e-28, 2.818e-28, 6.636e-28, 1.527e-27, 2.763e-27, 5.52e-27,  8.451e-27,
    1.582e-26, 2.316e-26, 3.669e-26, 4.924e-26, 7.752e-26, 9.016e-26, 1.48e-25,  1.602e-25,
    2.139e-25, 2.755e-25, 3.091e-25, 3.5e-25,   4.266e-25, 4.672e-25, 4.398e-25, 4.701e-25,
    5.019e-25, 4.305e-25, 3.74e-25,  3.215e-25, 2.662e-25, 2.238e-25, 1.852e-25, 1.473e-25,
    1.209e-25, 9.423e-26, 7.455e-26, 6.566e-26, 5.105e-26, 4.15e-26,  4.228e-26, 3.237e-26,
    2.451e-26, 2.801e-26, 2.534e-26, 1.624e-26, 1.465e-26, 2.078e-26, 1.383e-26, 7.105e-27};

void check_range(double value, double least, double most, const char* what) {
    if (value >= least && value <= most) return;
    throw InputError(
        fmt::format("{} {:.6g} of a clear sky; expected {} to {}", what, value, least, most));
}

void check_altitude(Angle altitude) {
    if (altitude >= Angle{} && altitude <= 90.0 * unit::deg) return;
    throw InputError(fmt::format("the sun at {:.6g}°; expected 0° (the horizon) to 90°",
                                 altitude.to(unit::deg)));
}

/// m⁻¹ on the ground, of clean air.
double air_extinction_550nm(const ClearSky& sky) {
    return air_optics(sky, 550.0 * unit::nm).depth.air * air_density(0.0).air;
}

class DirectTransmittance final : public Lanewise<DirectTransmittance> {
public:
    DirectTransmittance(Angle altitude, const ClearSky& sky)
        : sky_(sky),
          mass_{relative_air_mass(altitude), relative_haze_mass(altitude),
                relative_ozone_mass(altitude)} {}

    double value_at(double lambda_nm) const {
        return std::exp(-dot(mass_, air_optics(sky_, lambda_nm * unit::nm).depth));
    }
    double max_value() const override { return 1.0; }

private:
    ClearSky sky_;
    AirParts mass_;
};

class Product final : public Lanewise<Product> {
public:
    Product(SpectrumPtr a, SpectrumPtr b) : a_(std::move(a)), b_(std::move(b)) {
        for (double nm = kLambdaMin_nm; nm <= kLambdaMax_nm; nm += 1.0)
            max_value_ = std::max(max_value_, value_at(nm));
    }
    double value_at(double lambda_nm) const {
        return (*a_)(lambda_nm * unit::nm) * (*b_)(lambda_nm * unit::nm);
    }
    double max_value() const override { return max_value_; }

private:
    SpectrumPtr a_, b_;
    double max_value_ = 0.0;
};

}  // namespace

double relative_air_mass(Angle altitude) {
    check_altitude(altitude);
    return 1.0 / (sin(altitude) + 0.50572 * std::pow(altitude.to(unit::deg) + 6.07995, -1.6364));
}

double relative_ozone_mass(Angle altitude) {
    check_altitude(altitude);
    constexpr double kHeight = 22.0 / 6370.0;
    const double s = sin(altitude);
    return (1.0 + kHeight) / std::sqrt(s * s + 2.0 * kHeight);
}

double relative_haze_mass(Angle altitude) {
    check_altitude(altitude);
    return air_mass_to_space(0.0, sin(altitude)).haze;
}

double rayleigh_depth(Wavelength lambda) {
    const double per_um2 = 1e6 / std::pow(lambda.to(unit::nm), 2);
    return 0.008569 * per_um2 * per_um2 * (1.0 + 0.0113 * per_um2 + 0.00013 * per_um2 * per_um2);
}

double ozone_depth(Wavelength lambda, double dobson) {
    return dobson * kDobson_per_m2 *
           interpolate_linear_regular(kFirstOzoneBin_nm, kOzoneBin_nm, kOzone_m2,
                                      lambda.to(unit::nm));
}

void validate(const ClearSky& sky) {
    check_range(sky.pressure_hPa, 100.0, 1100.0, "pressure");
    check_range(sky.aerosol_depth_500nm, 0.0, kMostDepth, "aerosol depth");
    check_range(sky.angstrom_exponent, -1.0, 4.0, "Ångström exponent");
    check_range(sky.ozone_dobson, 0.0, 700.0, "ozone column");
    check_range(sky.aerosol_albedo, 0.0, 1.0, "albedo of the aerosol");
    check_range(sky.aerosol_asymmetry, 0.0, 0.8, "asymmetry of the aerosol");
    check_range(sky.ground_albedo, 0.0, 1.0, "ground albedo");
    check_range(sky.eye_height_m, 0.0, 12e3, "height of the eye, in metres,");
}

double aerosol_depth_from_visibility(Length visibility, const ClearSky& sky) {
    const double clean_km = kKoschmieder / air_extinction_550nm(sky) * 1e-3;
    const double km = visibility.to(1000.0 * unit::m);
    if (!(km >= 1.0 && km <= clean_km))
        throw InputError(fmt::format(
            "visibility {:.6g} km of a clear sky; expected 1 km to {:.0f} km, that of clean air",
            km, clean_km));
    const double haze_per_m = kKoschmieder / (km * 1e3) - air_extinction_550nm(sky);
    const double depth = haze_per_m * kHazeScale_m * std::pow(550.0 / 500.0, sky.angstrom_exponent);
    if (depth > kMostDepth)
        throw InputError(
            fmt::format("visibility {:.6g} km makes haze of depth {:.3g}; expected at most {:.0f}",
                        km, depth, kMostDepth));
    return depth;
}

Length visibility_of(const ClearSky& sky) {
    const double haze = sky.aerosol_depth_500nm * std::pow(550.0 / 500.0, -sky.angstrom_exponent);
    return kKoschmieder / (air_extinction_550nm(sky) + haze / kHazeScale_m) * unit::m;
}

SpectrumPtr make_direct_transmittance(Angle altitude, const ClearSky& sky) {
    validate(sky);
    return std::make_shared<DirectTransmittance>(altitude, sky);
}

SpectrumPtr make_direct_sunlight(SpectrumPtr above, Angle altitude, const ClearSky& sky) {
    return std::make_shared<Product>(std::move(above), make_direct_transmittance(altitude, sky));
}

}  // namespace dewbow
