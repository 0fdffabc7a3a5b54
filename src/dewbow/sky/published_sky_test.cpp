// SPDX-License-Identifier: Apache-2.0

// Luminances of clear skies as others have measured them.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/sky/air_optics.h"
#include "dewbow/sky/clear_sky.h"
#include "dewbow/sky/sunlight.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kDegree = std::numbers::pi / 180.0;

/// Azimuth from the sun.
Dir<World> towards(double altitude_deg, double azimuth_deg) {
    const double h = altitude_deg * kDegree, a = azimuth_deg * kDegree;
    return {{std::cos(h) * std::sin(a), std::sin(h), -std::cos(h) * std::cos(a)}};
}

double illuminance(const Spectrum& irradiance) {
    return kLuminousEfficacy * xyz_from_spectrum(irradiance)[1];
}

ClearSkyDomePtr sky_of_haze(double depth_500nm, double sun_deg) {
    ClearSky sky;
    sky.aerosol_depth_500nm = depth_500nm;
    return make_clear_sky_dome(sky, towards(sun_deg, 0), make_sunlight_above());
}

TEST(PublishedSky, LightsTheGroundAsIesClearSky) {
    // Skylight on level ground, 0.8 + 15.5 √(sin h) klx for clear skies.      [Gillette, Pierpoint
    // & Treado, J. IES 13, 385 (1984); IES Lighting Handbook, Daylighting]. A mean of clear days.
    constexpr double kClearDays = 0.12;
    for (const double h : {10.0, 30.0, 60.0}) {
        const double klx = 1e-3 * illuminance(*sky_of_haze(0.1, h)->diffuse_irradiance());
        EXPECT_NEAR(klx / (0.8 + 15.5 * std::sqrt(std::sin(h * kDegree))), 1.0, kClearDays) << h;
    }
}

TEST(PublishedSky, HasTheZenithOfSanFrancisco) {
    // (1.376 T − 1.81) tan h + 0.38 kcd m⁻², from three years of measurements, h to 60°. [Karayel,
    // Navvab, Ne'eman & Selkowitz, Energy and Buildings 6, 283 (1984)]. T, Linke's turbidity, of
    // haze and 1.5 cm of water: 3.91 e^0.689 τ_550 + 0.376 ln w + 2.2.  [Ineichen, Solar Energy 82,
    // 1095 (2008), at sea level]
    constexpr double kSpreadOfDays = 0.25;
    const struct {
        double depth, sun_deg;
    } rows[] = {{0.05, 20}, {0.05, 60}, {0.1, 40}, {0.2, 20}, {0.2, 60}};
    for (const auto& row : rows) {
        const double tau_550 = row.depth * std::pow(1.1, -1.3);
        const double turbidity =
            3.91 * std::exp(0.689) * tau_550 + 0.376 * std::log(1.5) + 2.0 + 0.54 - 0.5 + 0.16;
        const double measured =
            1e3 * ((1.376 * turbidity - 1.81) * std::tan(row.sun_deg * kDegree) + 0.38);
        EXPECT_NEAR(sky_of_haze(row.depth, row.sun_deg)->luminance(towards(90, 0)) / measured, 1.0,
                    kSpreadOfDays)
            << row.depth << " " << row.sun_deg;
    }
}

TEST(PublishedSky, IsDistributedAsCieStandardClearSky) {
    // L(γ, χ) / L_zenith = φ(γ) f(χ) / (φ(90°) f(90° − h)), φ = 1 − e^(−0.32 / sin γ),
    // f = 0.91 + 10 e^(−3χ) + 0.45 cos² χ.    [Kittler 1967; CIE 22 (1973); ISO 15469, type 12].
    // φ is that of a sky of depth 0.32, so haze makes up to that at 550 nm. Sideways and away from
    // the sun; towards it the standard is flatter: it has no aureole narrower than 1/3 radian.
    constexpr double kAbove10 = 0.3, kHorizon = 0.4;
    ClearSky sky;
    const AirParts clean = air_optics(sky, 550.0 * nm).depth;
    sky.aerosol_depth_500nm = (0.32 - clean.air - clean.ozone) * std::pow(1.1, 1.3);
    const auto scattering = [](double chi) {
        return 0.91 + 10.0 * std::exp(-3.0 * chi) + 0.45 * std::cos(chi) * std::cos(chi);
    };
    for (const double h : {20.0, 60.0}) {
        const ClearSkyDomePtr dome = make_clear_sky_dome(sky, towards(h, 0), make_sunlight_above());
        const double zenith = dome->luminance(towards(90, 0));
        for (const double gamma : {1.0, 5.0, 10.0, 30.0, 60.0})
            for (const double azimuth : {90.0, 135.0, 180.0}) {
                const double chi = std::acos(dot(towards(gamma, azimuth), towards(h, 0)));
                const double standard = (1.0 - std::exp(-0.32 / std::sin(gamma * kDegree))) /
                                        (1.0 - std::exp(-0.32)) * scattering(chi) /
                                        scattering((90.0 - h) * kDegree);
                EXPECT_NEAR(dome->luminance(towards(gamma, azimuth)) / zenith / standard, 1.0,
                            gamma < 10.0 ? kHorizon : kAbove10)
                    << h << " " << gamma << " " << azimuth;
            }
    }
}

}  // namespace
}  // namespace dewbow
