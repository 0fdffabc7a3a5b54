// SPDX-License-Identifier: Apache-2.0

// A slab of drops in sunlight: what the renderer makes of it against photons that are counted one
// by one (slab_of_photons.h), for light that is scattered once, twice and any number of times.

#include <gtest/gtest.h>

#include <map>

#include "../analytic/statistics.h"
#include "dewbow/math/quadrature.h"
#include "rain_slab.h"

namespace dewbow {
namespace {

using namespace kit;

/// Of one ring of one comparison: all of this file together stay below 1e-4.
constexpr double kFalseAlarm = 1e-6;
/// An error of this share of a ring's light, or of the light of all rings that are seen from the
/// sun's side, is found with probability 0.99, or the test calls itself too weak.
constexpr double kDetectable = 0.4, kDetectableTogether = 0.15;
constexpr std::size_t kReplicates = 32;
constexpr double kSunAltitude_deg = 40.0;
constexpr std::uint64_t kOtherSeed = 1000;
constexpr int kAll = RainSettings::kAllOrders;

/// The bright inside, the primary bow, the dark band with the secondary, the outside; and from
/// below, where it is bright around the sun.
const std::vector<Ring> kRings = {
    {0, 20}, {20, 39}, {39, 42.5}, {43.5, 55}, {55, 110}, {140, 160, false}, {160, 178, false},
};

/// How many rays and photons, and so how fine.
struct Effort {
    double factor;  ///< samples, over those of the quick test
    std::size_t rays() const { return std::size_t(1000 * factor); }
    std::size_t photons(double optical_depth) const {
        const double quick = optical_depth < 1.0 ? 80e3 : optical_depth < 2.0 ? 40e3 : 15e3;
        return std::size_t(quick * factor);
    }
    double detectable(double quick) const { return quick / std::sqrt(factor); }
};
constexpr Effort kQuick{1.0}, kLong{100.0};

RingValues all_on_lit_face(const RingValues& values) {
    std::vector<double> sums(kReplicates);
    for (std::size_t r = 0; r < kRings.size(); ++r)
        for (std::size_t j = 0; j < kReplicates; ++j)
            if (kRings[r].lit_face) sums[j] += values[r][j];
    return {sums};
}

double compare_ring(const char* what, const char* where, const std::vector<double>& rendered,
                    const std::vector<double>& counted, double detectable) {
    const WelchTest test = welch(rendered, counted);
    const double light = mean_of(counted).mean;
    EXPECT_LT(test.detectable(kFalseAlarm) / light, detectable) << "too few samples";
    std::printf("    %s, %s: %.4g, difference %+.4f, detectable %.4f, chance %.2g\n", what, where,
                light, test.difference / light, test.detectable(kFalseAlarm) / light, test.chance);
    return test.chance;
}

/// Least chance of all rings, and of those together; prints them.
double compare(const char* what, const RingValues& rendered, const RingValues& counted,
               const Effort& effort) {
    double least =
        compare_ring(what, "lit face", all_on_lit_face(rendered)[0], all_on_lit_face(counted)[0],
                     effort.detectable(kDetectableTogether));
    for (std::size_t r = 0; r < kRings.size(); ++r) {
        char where[40];
        std::snprintf(where, sizeof where, "%g to %g deg", kRings[r].inner_deg,
                      kRings[r].outer_deg);
        least = std::min(least, compare_ring(what, where, rendered[r], counted[r],
                                             effort.detectable(kDetectable)));
    }
    return least;
}

const DropCloudPtr& drops(double optical_depth) {
    static std::map<double, DropCloudPtr> clouds;
    DropCloudPtr& cloud = clouds[optical_depth];
    if (!cloud) cloud = drops_of_slab(optical_depth, "0.5mm", "descartes");
    return cloud;
}

CountedRings photons_of(double optical_depth, const Effort& effort) {
    const ScatteringAngles angles = angles_of(*drops(optical_depth));
    const PhotonSlab slab{optical_depth, albedo_of(*drops(optical_depth)), &angles,
                          sunlight_from(kSunAltitude_deg), kSunRadius.to(unit::rad)};
    return counted_rings(slab, kRings, kReplicates, effort.photons(optical_depth), 0);
}
template <class Walk = walk::CameraWalk>
RingValues rendered(double optical_depth, int orders, const Effort& effort) {
    const Vec3 sunlight = sunlight_from(kSunAltitude_deg);
    return rendered_rings<Walk>(slab_scene(drops(optical_depth), sunlight, orders), sunlight,
                                kRings, kReplicates, effort.rays(), kOtherSeed);
}

// ---- photons ------------------------------------------------------------------------------------

// Light that is scattered once by a slab is known in closed form:
//     L = ϖ p E / (1 + μ/μ0) (1 − e^(−τ (1/μ + 1/μ0)))                   [Chandrasekhar 1950, §52]
TEST(SlabOfPhotons, ScatteredOnceIsTheClosedForm) {
    constexpr double kAlbedo = 0.9, kDepth = 1.0, kG = 0.3;
    const auto phase = [](double c) {
        return (1.0 - kG * kG) / (4.0 * kPi * std::pow(1.0 + kG * kG - 2.0 * kG * c, 1.5));
    };
    const ScatteringAngles angles(phase);
    EXPECT_NEAR(angles.integral(), 1.0, 1e-6);
    const Vec3 sunlight = sunlight_from(kSunAltitude_deg);
    const RingValues counted =
        of_orders(counted_rings({kDepth, kAlbedo, &angles, sunlight, 0.0}, kRings, kReplicates,
                                kQuick.photons(kDepth), 7),
                  0, 1);
    const double mu0 = -sunlight.y;
    const QuadratureRule rule = gauss_legendre(64);
    for (std::size_t r = 0; r < kRings.size(); ++r) {
        if (!kRings[r].lit_face) continue;
        // Midpoints all around: the horizon cuts rings.
        constexpr int kAround = 2000;
        double light = 0.0;
        for (int i = 0; i < kAround; ++i) {
            const double azimuth = 2.0 * kPi * (i + 0.5) / kAround;
            light += integrate(rule, Ring::cosine(kRings[r].outer_deg),
                               Ring::cosine(kRings[r].inner_deg),
                               [&](double c) {
                                   const double mu = -turned(sunlight, c, azimuth).y;
                                   if (mu <= 0.0) return 0.0;
                                   return kAlbedo * phase(-c) * mu0 * mu / (mu + mu0) *
                                          -std::expm1(-kDepth * (1.0 / mu + 1.0 / mu0));
                               }) *
                     2.0 * kPi / kAround;
        }
        const MeanOfFew found = mean_of(counted[r]);
        const double t = (found.mean - light) / std::sqrt(found.variance_of_mean);
        EXPECT_GT(two_sided_chance(t, found.degrees), kFalseAlarm)
            << kRings[r].inner_deg << " deg: " << found.mean << " for " << light;
    }
}

// ---- the renderer -------------------------------------------------------------------------------

/// The law is the first order of what photons do, and paths that drops turn are the others.
void expect_photons(double optical_depth, const Effort& effort) {
    const CountedRings counted = photons_of(optical_depth, effort);
    EXPECT_GT(compare("once", rendered(optical_depth, 1, effort), of_orders(counted, 0, 1), effort),
              kFalseAlarm);
    EXPECT_GT(compare("twice at most", rendered(optical_depth, 2, effort), of_orders(counted, 0, 2),
                      effort),
              kFalseAlarm);
    EXPECT_GT(compare("any number of times", rendered(optical_depth, kAll, effort),
                      of_orders(counted, 0, kPhotonOrders), effort),
              kFalseAlarm);
}

class RainSlab : public ::testing::TestWithParam<double> {};
class LongRainSlab : public ::testing::TestWithParam<double> {};
TEST_P(RainSlab, OrdersAreThoseOfPhotons) { expect_photons(GetParam(), kQuick); }
/// About ten minutes on 2 cores.
TEST_P(LongRainSlab, OrdersAreThoseOfPhotons) { expect_photons(GetParam(), kLong); }
std::string name_of(const ::testing::TestParamInfo<double>& depth) {
    return depth.param < 1.0 ? "Tenth" : depth.param < 2.0 ? "One" : "Five";
}
INSTANTIATE_TEST_SUITE_P(OpticalDepths, RainSlab, ::testing::Values(0.1, 1.0, 5.0), &name_of);
INSTANTIATE_TEST_SUITE_P(LongOpticalDepths, LongRainSlab, ::testing::Values(0.1, 1.0, 5.0),
                         &name_of);

// ---- planted bugs ------------------------------------------------------------------------------

/// Rain near the eye is forgotten: two of ten metres, straight down.
class ForgetsTheNearest : public walk::CameraWalk {
public:
    using CameraWalk::CameraWalk;

private:
    void on_flight(const walk::SharedPath& path, const Hit& hit) override {
        walk::SharedPath further = path;
        further.ray.origin = path.ray.origin + path.ray.direction * 3.0;
        CameraWalk::on_flight(further, hit);
    }
};
/// The sun shines on drops that the camera sees, and on no others.
class ForgetsHigherOrders : public walk::CameraWalk {
public:
    using CameraWalk::CameraWalk;

private:
    void on_flight(const walk::SharedPath& path, const Hit& hit) override {
        if (path.drops == 0) CameraWalk::on_flight(path, hit);
    }
};
/// What a drop's path runs into is counted, though the drop knew it already.
class CountsLightTwice : public walk::CameraWalk {
public:
    using CameraWalk::CameraWalk;

private:
    void on_leaving(const walk::SharedPath& path) override {
        walk::SharedPath unknown = path;
        unknown.last.drop = false;
        CameraWalk::on_leaving(unknown);
    }
};

TEST(RainSlabCatches, RainThatIsForgottenNearTheEye) {
    EXPECT_LT(compare("planted", rendered<ForgetsTheNearest>(1.0, 1, kQuick),
                      of_orders(photons_of(1.0, kQuick), 0, 1), kQuick),
              kFalseAlarm);
}
TEST(RainSlabCatches, HigherOrdersThatAreForgotten) {
    EXPECT_LT(compare("planted", rendered<ForgetsHigherOrders>(0.1, 2, kQuick),
                      of_orders(photons_of(0.1, kQuick), 0, 2), kQuick),
              kFalseAlarm);
}

// ---- furnace -----------------------------------------------------------------------------------

// In even light drops that absorb nothing are invisible, with all orders: alone, over a white
// floor, in two rains and where the rain is uneven. So nothing is counted twice or missed, of the
// sky, of surfaces in rain, and of drops that surfaces light.

/// Water absorbs a little: 4e-5 at a drop in the visible, at about 10 drops.
constexpr double kAbsorbed = 1e-3;
/// Two-sided 1e-6.
constexpr double kSigmas = 4.9;
/// An error of this share of the light is found with probability 0.99; uneven rain is noisier.
constexpr double kDetectableFurnace = 0.05, kDetectableUneven = 0.15;
constexpr std::size_t kFurnaceSamples = 30000;

Scene furnace(bool floor, bool uneven) {
    Scene scene = slab_scene(drops(1.0), {0, -1, 0}, kAll);
    scene.lights = {UniformEnvironment{make_constant(1.0)}};
    scene.rains.push_back({"other", ConvexRegion::layer(4.0 * m, 14.0 * m), drops(0.1), {}});
    if (uneven) {
        scene.rains.front().chaos.emplace();
        scene.rains.front().chaos->base_frequency = 0.3;
    }
    if (floor) add(scene, Plane{}, diffuse(1.0), rotation({1, 0, 0}, -90.0 * deg));
    return scene;
}

template <class Walk = walk::CameraWalk>
MeanSums light_in(const Scene& scene) {
    const PreparedScene prepared(scene);
    constexpr int kPacket = 8;
    const WavelengthPacket lanes = among_others(kSlabLambda_nm, kPacket, 4);
    constexpr std::size_t kChunks = 32;
    std::vector<MeanSums> parts(kChunks);
    in_chunks(kFurnaceSamples, kChunks, [&](std::size_t chunk, std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            const SampleKey key = independent_key(3, i);
            const auto u = test_numbers(key, 0);
            const Vec3 along = sample_uniform_sphere<World>(u[0], u[1]).v;
            const PixelSample sample =
                Walk(prepared, nullptr, lanes, key, {}).run({{0.0, 7.0, 0.0}, along, {}});
            double mean = 0.0;
            for (std::size_t k = 0; k < kPacket; ++k) mean += sample.radiance[k] / kPacket;
            parts[chunk].add(mean - 1.0);
        }
    });
    MeanSums all;
    for (const MeanSums& part : parts) all.add(part);
    std::printf("    mean %+.4f, error %.4f\n", all.mean(), all.standard_error());
    return all;
}

TEST(RainFurnace, DropsThatAbsorbNothingAreInvisible) {
    for (const bool floor : {false, true})
        for (const bool uneven : {false, true}) {
            const MeanSums light = light_in(furnace(floor, uneven));
            EXPECT_LT(std::abs(light.mean()), kSigmas * light.standard_error() + kAbsorbed);
            EXPECT_LT((kSigmas + kPower99) * light.standard_error() + kAbsorbed,
                      uneven ? kDetectableUneven : kDetectableFurnace);
        }
}
TEST(RainFurnace, CatchesLightThatIsCountedTwice) {
    const MeanSums light = light_in<CountsLightTwice>(furnace(false, false));
    EXPECT_GT(std::abs(light.mean()), kSigmas * light.standard_error() + kAbsorbed);
}

}  // namespace
}  // namespace dewbow
