// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/sky_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/math/sampling.h"
#include "dewbow/render/infinite_light.h"
#include "dewbow/sky/overcast.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;

/// 1000 cd m⁻² everywhere but for a glow around one direction; nothing below the horizon.
class GlowingDome final : public SkyDome {
public:
    void radiance_lanes(Dir<World> direction, std::span<const double>,
                        std::span<double> out) const override {
        for (double& value : out)
            value = luminance(direction) / (kLuminousEfficacy * cie_y_integral());
    }
    double luminance(Dir<World> direction) const override {
        if (direction.v.y < 0.0) return 0.0;
        return 1000.0 + 50'000.0 * std::exp(40.0 * (dot(direction.v, towards_) - 1.0));
    }
    /// ∫ over the sphere, of the glow in closed form: it has died off before the horizon.
    static double integral() {
        return 2.0 * kPi * 1000.0 + 50'000.0 * 2.0 * kPi / 40.0 * (1.0 - std::exp(-80.0));
    }

private:
    Vec3 towards_ = normalised({0.3, 0.8, -0.6});
};

TEST(SkyMap, SamplesByLuminanceWithTheDensityThatItStates) {
    const auto sky = std::make_shared<GlowingDome>();
    const SkyMap map(sky);
    constexpr double kMidpoints = 0.01;  // of 128 rows, against the closed form
    EXPECT_NEAR(map.mean_brightness() * kLuminousEfficacy * cie_y_integral() * 4.0 * kPi /
                    GlowingDome::integral(),
                1.0, kMidpoints);
    constexpr int kSide = 64;
    double integral = 0.0, square = 0.0;
    for (int i = 0; i < kSide; ++i) {
        for (int k = 0; k < kSide; ++k) {
            const std::array<double, 2> u{(i + 0.5) / kSide, (k + 0.5) / kSide};
            const auto sample = map.sample(u);
            ASSERT_TRUE(sample);
            EXPECT_NEAR(map.pdf(sample->direction) / sample->pdf, 1.0, 1e-9);
            const auto place = map.place_of(sample->direction);
            EXPECT_NEAR(place[0], u[0], 1e-6);
            EXPECT_NEAR(place[1], u[1], 1e-6);
            const double estimate = sky->luminance({sample->direction}) / sample->pdf;
            integral += estimate / (kSide * kSide);
            square += estimate * estimate / (kSide * kSide);
        }
    }
    EXPECT_NEAR(integral / GlowingDome::integral(), 1.0, 2e-3);
    // Nearly in proportion: even sampling has a relative deviation of 1.9.
    EXPECT_LT(std::sqrt(square - integral * integral) / integral, 0.15);
}

TEST(SkyMap, LeavesNothingOutBelowTheHorizon) {
    const SkyMap map(make_overcast_dome(30.0 * unit::deg, 0.2));
    for (const double y : {-0.99, -0.5, -0.01, 0.01, 0.5, 0.99})
        EXPECT_GT(map.pdf({std::sqrt(1.0 - y * y), y, 0.0}), 0.0) << y;
    const SkyMap black(make_overcast_dome(30.0 * unit::deg, 0.0));
    EXPECT_GT(black.pdf({0.8, -0.6, 0.0}), 0.0);
    EXPECT_LT(black.pdf({0.8, -0.6, 0.0}), 0.02 * black.pdf({0.8, 0.6, 0.0}));
}

TEST(InfiniteLight, OfASkyIsItsRadiance) {
    const SkyDomePtr sky = make_overcast_dome(30.0 * unit::deg);
    const InfiniteLight light{Light(sky)};
    const Vec3 direction{0.6, 0.48, -0.64};
    EXPECT_TRUE(light.shows(direction));
    EXPECT_FALSE(light.parallel());
    const auto packet = sample_wavelengths(WavelengthSampling::visual, 8, 0.3);
    const LaneSet lanes = LaneSet::all(packet);
    RgbLightLanes rgb;
    LaneValues radiance;
    light.radiance(direction, lanes, rgb, radiance);
    std::array<double, 8> expected{};
    sky->radiance_lanes({direction}, lanes.lambdas(), expected);
    for (int k = 0; k < 8; ++k) EXPECT_EQ(radiance[k], expected[std::size_t(k)]);
    EXPECT_NEAR(light.brightness(direction) * kLuminousEfficacy * cie_y_integral(),
                sky->luminance({direction}), 1e-6);
    // π times the mean radiance: the sky is brighter overhead than at its edge.
    const double mean = (10'800.0 * 9.0 / (7.0 * kPi) * 2.0 / 3.0 + 0.2 / kPi * 10'800.0) / 2.0;
    EXPECT_NEAR(light.irradiance() * kLuminousEfficacy * cie_y_integral() / (kPi * mean), 1.0,
                0.01);
}

}  // namespace
}  // namespace dewbow
