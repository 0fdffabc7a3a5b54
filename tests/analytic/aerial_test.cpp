// SPDX-License-Identifier: Apache-2.0

// Aerial perspective in the path tracer, with air whose light is known in closed form.

#include <gtest/gtest.h>

#include "rain_kit.h"

namespace dewbow {
namespace {

using namespace kit;

/// Of sums of closed forms.
constexpr double kRounding = 1e-12;
/// Two-sided 1e-7.
constexpr double kSigmas = 5.33;

/// The same everywhere: T = e^(−σ s) and an airlight J (1 − T).
class EvenAir final : public Aerial {
public:
    static constexpr double kJ = 2.0, kPerMetreAt500 = 1e-3;
    static double sigma(double lambda_nm) { return kPerMetreAt500 * 500.0 / lambda_nm; }
    void eval_lanes(double, Dir<World>, double distance_m, std::span<const double> lambda_nm,
                    std::span<double> transmittance, std::span<double> airlight) const override {
        for (std::size_t k = 0; k < lambda_nm.size(); ++k) {
            const double t = std::exp(-sigma(lambda_nm[k]) * distance_m);
            transmittance[k] *= t;
            airlight[k] = kJ * (1.0 - t);
        }
    }
};

Scene airy_scene() {
    Scene scene = empty_scene(16);
    scene.aerial = std::make_shared<EvenAir>();
    return scene;
}

const Ray kAhead{{0, 0, 0}, {0, 0, -1}, {}};

struct LanesSeen {
    std::array<double, 4> lambda_nm, radiance;
};
LanesSeen see(const Scene& scene, const Ray& ray) {
    const PreparedScene prepared(scene);
    const WavelengthPacket packet = among_others(400.0, 4, 0);
    const PixelSample sample =
        trace_sample(prepared, ray, MediaStack{}, packet, independent_key(3, 0));
    LanesSeen seen{};
    for (std::size_t k = 0; k < 4; ++k)
        seen.lambda_nm[k] = packet.lambda_nm[k], seen.radiance[k] = sample.radiance[k];
    return seen;
}

TEST(AerialPerspective, VeilsWhatIsFar) {
    constexpr double kWall = 5.0, kDistance = 700.0;
    Scene scene = airy_scene();
    add(scene, Rectangle{400.0 * m, 400.0 * m}, lamp(kWall), translation({0, 0, -kDistance}));
    const LanesSeen seen = see(scene, kAhead);
    for (std::size_t k = 0; k < 4; ++k) {
        const double t = std::exp(-EvenAir::sigma(seen.lambda_nm[k]) * kDistance);
        EXPECT_NEAR(seen.radiance[k] / (kWall * t + EvenAir::kJ * (1.0 - t)), 1.0, kRounding);
    }
}

// A sky holds the light of its air.
TEST(AerialPerspective, AddsNothingToTheSkyAndTakesNothingFromTheSun) {
    Scene scene = airy_scene();
    scene.lights.push_back(UniformEnvironment{make_constant(3.0)});
    for (const double value : see(scene, kAhead).radiance) EXPECT_DOUBLE_EQ(value, 3.0);

    Scene sunny = airy_scene();
    sunny.lights.push_back(DistantLight{{{0, 0, -1}}, Angle{}, make_constant(kPi)});
    add(sunny, Rectangle{400.0 * m, 400.0 * m}, diffuse(0.5), translation({0, 0, -200.0}));
    const LanesSeen seen = see(sunny, kAhead);
    for (std::size_t k = 0; k < 4; ++k) {
        const double t = std::exp(-EvenAir::sigma(seen.lambda_nm[k]) * 200.0);
        EXPECT_NEAR(seen.radiance[k] / (0.5 * t + EvenAir::kJ * (1.0 - t)), 1.0, kRounding);
    }
}

TEST(AerialPerspective, DimsTheLightOfLamps) {
    constexpr double kLamp = 300.0, kWall = 200.0;  // m from the wall, and from the eye to it
    Scene scene = airy_scene();
    scene.lights.push_back(PointLight{{{0, 0, kLamp - kWall}}, make_constant(1e6)});
    add(scene, Rectangle{400.0 * m, 400.0 * m}, diffuse(0.5), translation({0, 0, -kWall}));
    const LanesSeen seen = see(scene, kAhead);
    for (std::size_t k = 0; k < 4; ++k) {
        const double sigma = EvenAir::sigma(seen.lambda_nm[k]);
        const double t = std::exp(-sigma * kWall);
        const double wall = 0.5 / kPi * 1e6 / (kLamp * kLamp) * std::exp(-sigma * kLamp);
        EXPECT_NEAR(seen.radiance[k] / (wall * t + EvenAir::kJ * (1.0 - t)), 1.0, kRounding);
    }
}

// Rain from 200 to 500 m dims the air's light that comes from behind its drops, and no other.
TEST(AerialPerspective, OfTheAirBeforeRainIsNotDimmedByIt) {
    constexpr double kBegin = 200.0, kEnd = 500.0, kWall = 900.0;
    Scene scene = airy_scene();
    scene.rains = {rain_in_box(drops(4e-3), {0, 0, -350}, {500, 500, 150})};
    add(scene, Rectangle{4000.0 * m, 4000.0 * m}, diffuse(0.0), translation({0, 0, -kWall}));
    const auto expected = [&](double lambda_nm) {
        const double s = EvenAir::sigma(lambda_nm);
        const double a = RainQuadrature::extinction(scene.rains[0], lambda_nm);
        const double before = 1.0 - std::exp(-s * kBegin);
        const double in =
            s / (s + a) * std::exp(-s * kBegin) * (1.0 - std::exp(-(s + a) * (kEnd - kBegin)));
        const double behind =
            std::exp(-a * (kEnd - kBegin)) * (std::exp(-s * kEnd) - std::exp(-s * kWall));
        return EvenAir::kJ * (before + in + behind);
    };
    const MeanSums sums = rain_difference(scene, kAhead, 4000, expected);
    EXPECT_LT(std::abs(sums.mean()), kSigmas * sums.standard_error());
    EXPECT_LT(sums.standard_error(), 2e-3);  // without that part the mean is off by 0.2
}

// The sky behind rain: dimmed, but for what its air sends from before the rain.
TEST(AerialPerspective, OfASkyBehindRainStandsBeforeIt) {
    constexpr double kBegin = 200.0, kEnd = 500.0;
    Scene scene = airy_scene();
    scene.lights.push_back(UniformEnvironment{make_constant(EvenAir::kJ)});
    scene.rains = {rain_in_box(drops(4e-3), {0, 0, -350}, {0.2, 0.2, 150})};
    // What the drops scatter themselves: all that they stop, in even light, dimmed by air alone.
    const auto expected = [&](double lambda_nm) {
        const double s = EvenAir::sigma(lambda_nm);
        const double a = RainQuadrature::extinction(scene.rains[0], lambda_nm);
        const double stopped = 1.0 - std::exp(-a * (kEnd - kBegin));
        const double lit =
            a / (s + a) * std::exp(-s * kBegin) * (1.0 - std::exp(-(s + a) * (kEnd - kBegin)));
        const double air = stopped - lit;  // ∫ (1 − e^(−s r)) dP
        double albedo;
        scene.rains[0].drops->albedo_lanes({&lambda_nm, 1}, {&albedo, 1});
        return EvenAir::kJ * (1.0 - stopped + air + albedo * lit);
    };
    const MeanSums sums = rain_difference(scene, kAhead, 4000, expected);
    // Skylight reaches the drops through the narrow rain dimmed by a little.
    constexpr double kNarrow = 5e-3;
    EXPECT_LT(std::abs(sums.mean()), kSigmas * sums.standard_error() + kNarrow);
}

}  // namespace
}  // namespace dewbow
