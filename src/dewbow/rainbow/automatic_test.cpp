// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/automatic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/scattering_table.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kPi = std::numbers::pi;

DispersionPtr constant(double n) {
    return make_dispersion({"constant", {n}, IndexReference::vacuum});
}

std::vector<Angle> angles(double from_deg, double to_deg, double step_deg) {
    std::vector<Angle> result;
    const int count = int(std::lround((to_deg - from_deg) / step_deg));
    for (int k = 0; k <= count; ++k)
        result.push_back((from_deg + (to_deg - from_deg) * k / count) * deg);
    return result;
}

TableRequest request_of(const std::string& sizes, std::vector<Angle> at, Angle disc) {
    TableRequest request;
    request.sizes = parse_drop_sizes(sizes);
    request.optics = {constant(1.333), vacuum(), 0.0};
    request.wavelengths = {589.29 * nm};
    request.angles = std::move(at);
    request.disc.radius = disc;
    return request;
}

struct Peak {
    Angle angle;
    double intensity = 0.0;  ///< (|S_1|² + |S_2|²) / 2x²
    double polarisation = 0.0;
};
Peak peak_between(const ScatteringTable& table, double from_deg, double to_deg) {
    Peak peak;
    for (std::size_t a = 0; a < table.angles.size(); ++a) {
        const double theta = table.angles[a].to(deg);
        const Intensities& P = table.at(a, 0);
        const double intensity = P.unpolarised() * table.efficiencies[0].scattering / 4.0;
        if (theta < from_deg || theta > to_deg || intensity <= peak.intensity) continue;
        peak = {table.angles[a], intensity,
                (P.perpendicular - P.parallel) / (P.perpendicular + P.parallel)};
    }
    return peak;
}

TEST(Automatic, HasTheReferenceValuesOfHalfMillimetreDrops) {
    // Full Mie, n = 1.333, λ = 589.29 nm, a = 0.5 mm ± 10 % by 81 radii, the sun's disc.
    /// Of the peak: its own sampling of radii.
    constexpr double kIntensity = 0.006, kAngle = 0.03, kPolarisation = 0.003;
    const ScatteringTable table = make_scattering_table(
        request_of("normal:mean=0.5mm,width=10%", angles(120.0, 145.0, 0.02), kSunRadius));
    const Peak primary = peak_between(table, 137.0, 145.0);
    EXPECT_NEAR(primary.angle.to(deg), 138.22, kAngle);
    EXPECT_NEAR(primary.intensity, 0.545, kIntensity * 0.545);
    EXPECT_NEAR(primary.polarisation, 0.908, kPolarisation);
    const Peak secondary = peak_between(table, 120.0, 131.0);
    EXPECT_NEAR(secondary.angle.to(deg), 128.58, kAngle);
    EXPECT_NEAR(secondary.intensity, 0.0836, kIntensity * 0.545);
    EXPECT_NEAR(secondary.polarisation, 0.750, kPolarisation);
    double band = 0.0;
    int count = 0;
    for (std::size_t a = 0; a < table.angles.size(); ++a) {
        const double theta = table.angles[a].to(deg);
        if (theta < 131.0 || theta > 136.5) continue;
        band += table.at(a, 0).unpolarised() * table.efficiencies[0].scattering / 4.0;
        ++count;
    }
    EXPECT_NEAR(band / count, 0.0061, kIntensity * 0.545);
}

}  // namespace
}  // namespace dewbow
