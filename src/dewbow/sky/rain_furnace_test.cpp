// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "dewbow/sky/rain_law.h"
#include "dewbow/sky/rain_region.h"
#include "dewbow/sky/test_drops.h"

namespace dewbow {
namespace {

using namespace unit;
using std::numbers::pi;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr double kLambda_nm = 550.0;

double albedo_of(const DropCloud& cloud) {
    double albedo;
    cloud.albedo_lanes({&kLambda_nm, 1}, {&albedo, 1});
    return albedo;
}

const DropCloudPtr& drops() {
    static const DropCloudPtr made = make_drop_cloud(test_drops(1e-3));
    return made;
}

/// What comes along `view` out of light of radiance 1 from everywhere, behind the rain too: the law
/// with a sun of irradiance 1 sr⁻¹ × dω in each of the sphere's parts, by midpoints.
double in_uniform_light(const DropCloud& cloud, const ConvexRegion& region, Vec3 eye, Vec3 view) {
    constexpr int kPolar = 20000, kAround = 4;
    const double albedo = albedo_of(cloud);
    double extinction;
    cloud.extinction_lanes({&kLambda_nm, 1}, {&extinction, 1});
    const auto inside = region.cut({eye}, {view}, kInfinity);
    const auto [t, b] = tangents_of(view);
    double sum = rain_law::rain_transmittance(extinction * (inside->end - inside->begin));
    std::vector<LengthPiece> pieces;
    for (int i = 0; i < kPolar; ++i) {
        const double theta = (i + 0.5) * pi / kPolar;
        Intensities phase;
        cloud.phase_lanes(std::cos(theta), 0, {&kLambda_nm, 1}, {&phase, 1});
        const double irradiance = std::sin(theta) * (pi / kPolar) * (2.0 * pi / kAround);
        for (int k = 0; k < kAround; ++k) {
            const double azimuth = (k + 0.5) * 2.0 * pi / kAround;
            // Light that goes on along −view after it has been turned by θ came from here.
            const Vec3 sun = std::cos(theta) * view +
                             std::sin(theta) * (std::cos(azimuth) * t + std::sin(azimuth) * b);
            pieces.clear();
            region.lengths_towards({eye}, {view}, *inside, {sun}, pieces);
            for (const LengthPiece& p : pieces) {
                const bool dims = p.length < kInfinity;
                const double depth =
                    extinction * (p.begin - inside->begin + (dims ? p.length : 0.0));
                const double piece = rain_law::rain_piece(
                    depth, extinction * (1.0 + (dims ? p.slope : 0.0)), p.end - p.begin);
                sum += rain_law::rain_light(irradiance, albedo, phase.unpolarised(), extinction,
                                            piece);
            }
        }
    }
    return sum;
}

/// Floats in the table, and midpoints at the bow's edge: as of the phase function's integral.
constexpr double kTable = 2e-4;

// Rain without end that is lit everywhere: as much comes as is lost, and one sees the light.
TEST(RainFurnace, EndlessRainIsInvisible) {
    const DropCloudPtr cloud = drops();
    const double seen =
        in_uniform_light(*cloud, ConvexRegion::everywhere(), {0, 0, 0}, normalised({1, 2, 3}));
    EXPECT_NEAR(seen / albedo_of(*cloud), 1.0, kTable);
    EXPECT_GT(albedo_of(*cloud), 0.999);  // water is clear, and rays after many turns are few
}

// A thin layer loses the depth τ and gives back ϖ τ.
TEST(RainFurnace, AThinLayerGivesBackWhatTheTableSays) {
    const DropCloudPtr cloud = drops();
    const double albedo = albedo_of(*cloud), top_m = 0.01;  // τ = 1e-5
    const double seen = in_uniform_light(*cloud, ConvexRegion::layer(0.0 * m, top_m * m), {0, 5, 0},
                                         normalised({1, -2, 3}));
    const double tau = 1e-3 * top_m * std::sqrt(14.0) / 2.0;
    // Light along the layer is dimmed by its depth: τ ln τ of all.
    EXPECT_NEAR((seen - std::exp(-tau)) / tau / albedo, 1.0, kTable - tau * std::log(tau));
}

// A thick layer gives back less: its own light has been dimmed, and is not scattered again.
TEST(RainFurnace, SingleScatteringOfAThickLayerIsTheIntegralOverSuns) {
    const DropCloudPtr cloud = drops();
    const double top_m = 1000.0;  // τ = 1 straight down
    const double seen =
        in_uniform_light(*cloud, ConvexRegion::layer(0.0 * m, top_m * m), {0, 2000, 0}, {0, -1, 0});
    // Straight down the azimuth does not matter: ∫ e^(−τ) e^(−(τ or 1 − τ)/|µ|) dτ for each sun.
    constexpr int kPolar = 20000;
    double expected = std::exp(-1.0);
    for (int i = 0; i < kPolar; ++i) {
        const double theta = (i + 0.5) * pi / kPolar, mu = std::cos(theta);
        Intensities phase;
        cloud->phase_lanes(mu, 0, {&kLambda_nm, 1}, {&phase, 1});
        // θ below 90°: the sun is beneath the layer.
        const double k = 1.0 / std::abs(mu);
        const double slab = mu < 0.0 ? (1.0 - std::exp(-(1.0 + k))) / (1.0 + k)
                                     : (std::exp(-1.0) - std::exp(-k)) / (k - 1.0);
        expected += 2.0 * pi * std::sin(theta) * (pi / kPolar) * albedo_of(*cloud) *
                    phase.unpolarised() * slab;
    }
    EXPECT_NEAR(seen, expected, 1e-6);  // the same midpoints, and 1 − k that comes near 0
}

}  // namespace
}  // namespace dewbow
