// SPDX-License-Identifier: Apache-2.0

// Rain in the path tracer, against plain quadrature of its law (rain_kit.h).

#include <gtest/gtest.h>

#include "rain_kit.h"

namespace dewbow {
namespace {

using namespace kit;

/// Two-sided 1e-7 for one z; ten tests: 1e-6 for all of this file.
constexpr double kSigmas = 5.33;
/// Midpoints in steps of a thousandth of a region, whose faces lie anywhere between them.
constexpr double kQuadrature = 3e-3;
/// Of sums of closed forms against each other.
constexpr double kRounding = 1e-11;
/// Where the drops' extinction differs a little from lane to lane, they share a distance that fits
/// their sum.
constexpr double kLanesDiffer = 1e-5;
constexpr double kAltitude = 20.0;

/// Of the second of four lanes from 400 nm on.
constexpr double kLambda_nm = 517.5;

/// One sample of a ray, at these lanes.
std::array<double, 4> one_sample(const Scene& scene, const Ray& ray, std::size_t i = 0) {
    const PreparedScene prepared(scene);
    const PixelSample sample =
        trace_sample(prepared, ray, MediaStack{}, among_others(400.0, 4, 0), independent_key(3, i));
    std::array<double, 4> radiance;
    for (std::size_t k = 0; k < 4; ++k) radiance[k] = sample.radiance[k];
    return radiance;
}

/// Before the viewer, from 100 to 200 m, with the sun behind him.
Rain shower(double per_m) { return rain_in_box(drops(per_m), {0, 0, -150}, {500, 120, 50}); }
/// Behind it, further up and to 400 m.
Rain fog(double per_m) { return rain_in_box(drops(per_m), {0, 50, -300}, {500, 120, 100}); }

// Sunlight comes from above and behind: a part of it through the first rain, and another over it.
TEST(Rain, SunlightIsTheQuadratureOfTheLaw) {
    Scene scene = sunny_scene(kAltitude);
    scene.rains = {shower(4e-3), fog(4e-3)};
    const RainQuadrature law{scene, towards_sun(kAltitude), 0.2};
    for (const double angle : {5.0, 30.0, 42.0, 46.0, 51.0}) {
        const Ray ray = ray_above_antisolar(kAltitude, angle);
        const auto seen = one_sample(scene, ray);
        EXPECT_NEAR(seen[1] / law.sunlight(ray, 600.0, 800.0, kLambda_nm), 1.0, kQuadrature)
            << angle;
    }
}

// Nothing shadows: each sample is the same, wherever it takes its point.
TEST(Rain, MakesNoNoiseWhereNothingShadows) {
    Scene scene = sunny_scene(kAltitude);
    scene.rains = {shower(4e-3), fog(4e-3)};
    const Ray ray = ray_above_antisolar(kAltitude, 42.0);
    const auto first = one_sample(scene, ray);
    for (std::size_t i = 1; i < 20; ++i) {
        const auto again = one_sample(scene, ray, i);
        for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(again[k] / first[k], 1.0, kLanesDiffer);
        EXPECT_NEAR((again[0] + again[1] + again[2] + again[3]) /
                        (first[0] + first[1] + first[2] + first[3]),
                    1.0, kRounding);
    }
}

// At the antisolar point of a layer light comes back by the way that it went: what is sent is half
// of what 2τ would stop.
TEST(Rain, TheAntisolarPointOfALayer) {
    constexpr double kThick_m = 10.0;
    const Ray ray = ray_above_antisolar(kAltitude, 0.0);
    for (const double depth : {0.1, 1.0, 5.0}) {
        Scene scene = sunny_scene(kAltitude);
        const DropCloudPtr cloud = drops(depth * -ray.direction.y / kThick_m);
        scene.rains = {{"layer", ConvexRegion::layer(-30.0 * m, -20.0 * m), cloud, std::nullopt}};
        double per_m, albedo;
        Intensities phase;
        cloud->extinction_lanes({&kLambda_nm, 1}, {&per_m, 1});
        cloud->albedo_lanes({&kLambda_nm, 1}, {&albedo, 1});
        cloud->phase_lanes(-1.0, cloud->disc_of({kSunDisc, 0.0}), {&kLambda_nm, 1}, {&phase, 1});
        const double tau = per_m * kThick_m / -ray.direction.y;
        const double sent =
            kSunIrradiance * albedo * phase.unpolarised() * 0.5 * -std::expm1(-2.0 * tau);
        EXPECT_NEAR(one_sample(scene, ray)[1] / sent, 1.0, kLanesDiffer) << depth;
    }
}

TEST(Rain, TwoIdenticalRainsAreOneTwiceAsDense) {
    Scene two = sunny_scene(kAltitude), dense = two;
    two.rains = {shower(4e-3), shower(4e-3)};
    dense.rains = {shower(8e-3)};
    for (const double angle : {30.0, 42.0, 51.0}) {
        const Ray ray = ray_above_antisolar(kAltitude, angle);
        const auto a = one_sample(two, ray), b = one_sample(dense, ray);
        for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(a[k] / b[k], 1.0, kRounding);
    }
}

// What is seen of the first rain is the same whatever lies behind it, and the fog adds to it what
// comes through.
TEST(Rain, FogBehindABowDoesNotEraseIt) {
    Scene alone = sunny_scene(kAltitude), both = alone, behind = alone;
    // Sunlight comes to the fog over the rain, which dims it on its way to the eye alone.
    const Rain rain = rain_in_box(drops(4e-3), {0, 0, -150}, {500, 200, 50});
    const Rain far_fog = rain_in_box(drops(8e-3), {0, 0, -1500}, {2000, 900, 100});
    alone.rains = {rain}, both.rains = {rain, far_fog}, behind.rains = {far_fog};
    double per_m;
    rain.drops->extinction_lanes({&kLambda_nm, 1}, {&per_m, 1});
    for (const double angle : {35.0, 41.8, 51.4}) {
        const Ray ray = ray_above_antisolar(kAltitude, angle);
        const double way = 100.0 / -ray.direction.z;
        const auto a = one_sample(alone, ray), b = one_sample(both, ray),
                   f = one_sample(behind, ray);
        EXPECT_NEAR((b[1] - a[1]) / (f[1] * std::exp(-per_m * way)), 1.0, kLanesDiffer) << angle;
    }
}

// A wall that glows behind the rain: dimmed by extinction, and nothing else is taken from it. (The
// drops scatter a little of the wall's own light, too, if they scatter at all.)
TEST(Rain, DarkensWhatIsBehindByExtinctionAlone) {
    // Of one sample: it is 1 % on average.
    constexpr double kWall = 0.01, kOwnLight = 0.1;
    Scene dark = empty_scene(0), sunny = sunny_scene(kAltitude), without_wall = sunny;
    for (Scene* scene : {&dark, &sunny}) {
        add(*scene, Rectangle{4000.0 * m, 4000.0 * m}, lamp(kWall), translation({0, 0, -900}));
        scene->rains = {shower(4e-3)};
    }
    without_wall.rains = {shower(4e-3)};
    double per_m;
    sunny.rains[0].drops->extinction_lanes({&kLambda_nm, 1}, {&per_m, 1});
    for (const double angle : {30.0, 42.0, 46.0}) {
        const Ray ray = ray_above_antisolar(kAltitude, angle);
        const double through = kWall * std::exp(-per_m * 100.0 / -ray.direction.z);
        EXPECT_NEAR(one_sample(dark, ray)[1] / through, 1.0, kRounding) << angle;
        const double bow = one_sample(without_wall, ray)[1];
        EXPECT_GT(bow, 0.0);
        const double seen = one_sample(sunny, ray)[1] / (through + bow);
        EXPECT_GE(seen, 1.0 - kRounding) << angle;
        EXPECT_LT(seen, 1.0 + kOwnLight) << angle;
    }
}

// A lawn five metres away, and rain that begins at ten: the lawn is as it is without rain. With
// rain between them the bow lies upon it.
TEST(Rain, NoBowOnTheLawnWithoutRainThere) {
    Scene dry = sunny_scene(kAltitude), soil = dry;
    const Affine level = translation({0, -1.7, 0}) * rotation({1, 0, 0}, -90.0 * deg);
    add(dry, Rectangle{40.0 * m, 40.0 * m}, diffuse(0.3), level);
    add(soil, Rectangle{40.0 * m, 40.0 * m}, {"soil", Black{}}, level);
    Scene beyond = dry;
    beyond.rains = {rain_in_box(drops(8e-3), {0, 0, -110}, {100, 50, 100})};
    const double level_way = std::sqrt(1.0 - 0.34 * 0.34);
    const Ray ray{{0, 0, 0}, {std::sin(0.6) * level_way, -0.34, -std::cos(0.6) * level_way}, {}};
    const auto a = one_sample(dry, ray), b = one_sample(beyond, ray);
    EXPECT_GT(a[0], 0.0);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(a[k], b[k]);
    EXPECT_EQ(one_sample(soil, ray)[0], 0.0);
    soil.rains = {rain_in_box(drops(8e-3), {0, 0, -3}, {10, 1.6, 2})};
    EXPECT_GT(one_sample(soil, ray)[0], 0.0);
}

TEST(Rain, ShowsItsBowInAMirrorToo) {
    Scene scene = sunny_scene(kAltitude);
    scene.rains = {shower(4e-3)};
    for (const double angle : {30.0, 42.0, 51.0}) {
        const Ray ray = ray_above_antisolar(kAltitude, angle);
        const auto direct = one_sample(scene, ray);
        Scene mirrored = scene;
        add(mirrored, Disc{0.1 * m}, {"mirror", Mirror{make_constant(1.0)}},
            looking_at({0, 0, 0}, Vec3{0, 1, 0} + ray.direction, {1, 0, 0}));
        // From above, onto the mirror at the origin.
        const auto seen = one_sample(mirrored, {{0, 1, 0}, {0, -1, 0}, {}});
        for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(seen[k] / direct[k], 1.0, kLanesDiffer);
    }
}

// A body fills the near half of the rain's region. Rays go on behind it, or back from it to
// nothing.
TEST(Rain, IsNotInsideBodies) {
    constexpr double kWall = 0.01;
    Scene scene = empty_scene(2);
    add(scene, Rectangle{4000.0 * m, 4000.0 * m}, lamp(kWall), translation({0, 0, -900}));
    add(scene, Box{2000.0 * m, 2000.0 * m, 60.0 * m}, dielectric(plain(1.5)),
        translation({0, 0, -120}));
    scene.rains = {shower(4e-3)};
    double per_m;
    scene.rains[0].drops->extinction_lanes({&kLambda_nm, 1}, {&per_m, 1});
    double most = 0.0;
    for (std::size_t i = 0; i < 8; ++i)
        most = std::max(most, one_sample(scene, {{0, 0, 0}, {0, 0, -1}, {}}, i)[1]);
    EXPECT_NEAR(most / (kWall * std::exp(-per_m * 50.0)), 1.0, kRounding);
}

/// A wall that keeps sunlight from what lies below a slanting plane.
constexpr double kHill_m = 200.0, kHillAt_m = 100.0;
void add_hill(Scene& scene) {
    add(scene, Rectangle{5000.0 * m, kHill_m * m}, {"hill", Black{}},
        translation({0, 0.5 * kHill_m, kHillAt_m}));
}
bool over_the_hill(Vec3 p) {
    const Vec3 sun = towards_sun(kAltitude);
    const double height = p.y + (kHillAt_m - p.z) / sun.z * sun.y;
    return height > kHill_m || height < 0.0;
}

TEST(Rain, AHillsShadowCutsTheBow) {
    Scene scene = sunny_scene(kAltitude);
    add_hill(scene);
    scene.rains = {shower(4e-3)};
    // It leaves the shadow at z = −170 m, in the midst of the rain.
    const Ray ray{{0, 0, 0}, normalised({0.2, 0.6, -1.0}), {}};
    const RainQuadrature law{scene, towards_sun(kAltitude), 0.1, over_the_hill};
    const RainQuadrature unshadowed{scene, towards_sun(kAltitude), 0.1};
    const double share = law.sunlight(ray, 400.0, 600.0, kLambda_nm) /
                         unshadowed.sunlight(ray, 400.0, 600.0, kLambda_nm);
    EXPECT_GT(share, 0.2);
    EXPECT_LT(share, 0.8);
    const MeanSums sums = rain_difference(
        scene, ray, 40000, [&](double lambda) { return law.sunlight(ray, 400.0, 600.0, lambda); });
    EXPECT_LT(std::abs(sums.mean()), kSigmas * sums.standard_error() + kQuadrature);
    EXPECT_LT((kSigmas + kPower99) * sums.standard_error(), 0.1);
}

// Uneven rain: its density is asked at random points, on both ways of the light.
TEST(Rain, OfUnevenDensityIsTheQuadratureOfTheLaw) {
    Scene scene = sunny_scene(kAltitude);
    Chaos sheets;
    sheets.octaves = 3, sheets.base_frequency = 0.02, sheets.bias = -0.5, sheets.gain = 2.0;
    scene.rains = {shower(8e-3), fog(4e-3)};
    scene.rains[0].chaos = sheets;
    const RainQuadrature law{scene, towards_sun(kAltitude), 1.0};
    const Ray ray = ray_above_antisolar(kAltitude, 42.0);
    const MeanSums sums = rain_difference(
        scene, ray, 20000, [&](double lambda) { return law.sunlight(ray, 600.0, 800.0, lambda); });
    EXPECT_LT(std::abs(sums.mean()), kSigmas * sums.standard_error() + kQuadrature);
    EXPECT_LT((kSigmas + kPower99) * sums.standard_error(), 0.05);
    std::printf("    mean %+.4f +- %.4f\n", sums.mean(), sums.standard_error());
}

// A lamp in the rain, near the ray: most of its light comes from where they are closest.
TEST(Rain, LampsShineOnIt) {
    constexpr double kIntensity = 5.0;
    const Vec3 lamp{0.5, 0.2, -6.0};
    Scene scene = empty_scene(16);
    scene.rains = {rain_in_box(drops(8e-3), {0, 0, -50}, {30, 30, 49})};
    scene.lights.push_back(PointLight{{lamp}, make_constant(kIntensity)});
    const DropCloud& cloud = *scene.rains[0].drops;
    const auto expected = [&](double lambda_nm) {
        double per_m, albedo;
        cloud.extinction_lanes({&lambda_nm, 1}, {&per_m, 1});
        cloud.albedo_lanes({&lambda_nm, 1}, {&albedo, 1});
        // Equal steps of the angle under which the lamp sees the ray.
        const double aside = std::hypot(lamp.x, lamp.y);
        const double first = std::atan((1.0 + lamp.z) / aside);
        const double last = std::atan((99.0 + lamp.z) / aside);
        constexpr int kSteps = 20000;
        double sum = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const double angle = first + (i + 0.5) * (last - first) / kSteps;
            const double s = aside * std::tan(angle) - lamp.z, r = aside / std::cos(angle);
            Intensities phase;
            cloud.phase_lanes(-std::sin(angle), 0, {&lambda_nm, 1}, {&phase, 1});
            sum += phase.unpolarised() * std::exp(-per_m * (s - 1.0 + r));
        }
        return kIntensity * per_m * albedo * sum * (last - first) / kSteps / aside;
    };
    const MeanSums sums = rain_difference(scene, {{0, 0, 0}, {0, 0, -1}, {}}, 60000, expected);
    EXPECT_LT(std::abs(sums.mean()), kSigmas * sums.standard_error());
    EXPECT_LT((kSigmas + kPower99) * sums.standard_error(), 0.1);
    std::printf("    mean %+.4f +- %.4f\n", sums.mean(), sums.standard_error());
}

/// Light of radiance 1 from everywhere is as good as nothing changed by thin rain that swallows
/// nothing: what is lost on the ray comes from elsewhere, but for light that meets two drops.
TEST(Rain, ThinRainInUniformLightIsNotSeen) {
    Scene scene = furnace_scene();
    scene.rains = {rain_in_box(drops(4e-3), {0, 0, -5}, {3, 3, 2})};
    scene.rains.push_back(scene.rains[0]);
    for (const bool uneven : {false, true}) {
        if (uneven) scene.rains[1].chaos = Chaos{};
        const MeanSums sums =
            rain_difference(scene, {{0, 0, 0}, {0, 0, -1}, {}}, 20000, [](double) { return 1.0; });
        // 4 m of 0.008 m⁻¹: 3.2 % are scattered, and of these at most 3.2 % once more.
        EXPECT_LT(sums.mean(), kSigmas * sums.standard_error());
        EXPECT_GT(sums.mean(), -0.032 * 0.032 - kSigmas * sums.standard_error());
        EXPECT_LT((kSigmas + kPower99) * sums.standard_error(), 0.003);
        std::printf("    mean %+.5f +- %.5f\n", sums.mean(), sums.standard_error());
    }
}

}  // namespace
}  // namespace dewbow
