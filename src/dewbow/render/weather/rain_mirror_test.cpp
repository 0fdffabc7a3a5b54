// SPDX-License-Identifier: Apache-2.0
//
// The light of a sun and of its image in a lake, as rain sends it to a camera, against quadrature
// over the points of a ray that knows nothing of pieces, closed forms and matrices.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "dewbow/optics/catalogue.h"
#include "dewbow/render/path/path.h"
#include "dewbow/scene/rain_inside.h"
#include "dewbow/sky/drop_cloud.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSamples = 64;
/// Lanes differ in extinction by less than a hundredth, so that one sample misses by a few
/// thousandths of what dims the light; the quadrature by 1e-5 of its steps.
constexpr double kAccuracy = 2e-3;

const DropCloudPtr& drops() {
    static const DropCloudPtr made = [] {
        DropCloudRequest request;
        request.model = "descartes";
        request.showers = {parse_drop_sizes("0.5mm")};
        request.optics = {make_dispersion(find_glass("water@20C").data),
                          make_dispersion(find_glass("air").data), 0.0};
        request.amount = RainExtinction{0.01};
        return make_drop_cloud(request);
    }();
    return made;
}

constexpr double kIrradiance = 2.0, kIndex = 1.4, kLake_m = 1.0;

/// A lake of index 1.4 in vacuum under a parallel sun, and rain in a region.
Scene lake_in_rain(Dir<World> to_sun, std::variant<ConvexRegion, MeshRegion> region) {
    Scene scene = make_empty_scene();
    Medium vacuum, water;
    vacuum.index = make_dispersion({"constant", {1.0}, IndexReference::vacuum});
    water.index = make_dispersion({"constant", {kIndex}, IndexReference::vacuum});
    scene.surroundings = std::make_shared<const Medium>(std::move(vacuum));
    const int material =
        scene.add({"water", Dielectric{std::make_shared<const Medium>(std::move(water))}, {}});
    const Affine level = translation({0, kLake_m, 0}) * rotation({1, 0, 0}, -90.0 * deg);
    scene.shapes.push_back({"lake", Plane{}, Transform<World, Object>(level), material});
    scene.lights.push_back(DistantLight{-to_sun, 0.0 * deg, make_constant(kIrradiance)});
    scene.rains.push_back({"shower", std::move(region), drops(), {}});
    return scene;
}

/// Per sr: the fields of light that goes along `in`, polarised level and across with these shares,
/// as drops send them along `out`.
double scattered(Vec3 in, Vec3 out, double level_share, double across_share, Intensities phase) {
    const Vec3 level = normalised(cross(in, {0, 1, 0})), across = cross(level, in);
    const Vec3 perpendicular = normalised(cross(in, out)), parallel = cross(perpendicular, in);
    const auto of = [&](Vec3 field) {
        return phase.perpendicular * std::pow(dot(field, perpendicular), 2) +
               phase.parallel * std::pow(dot(field, parallel), 2);
    };
    return 0.5 * (level_share * of(level) + across_share * of(across));
}

struct Expected {
    double direct, mirrored;
};

Expected by_quadrature(const Scene& scene, Vec3 eye, Vec3 view, double lambda_nm) {
    constexpr int kSteps = 4000;
    const Vec3 to_sun = -std::get<DistantLight>(scene.lights[0]).direction.v;
    const Vec3 image{to_sun.x, -to_sun.y, to_sun.z};
    const RainInside rain(scene.rains[0]);
    double extinction, albedo;
    drops()->extinction_lanes({&lambda_nm, 1}, {&extinction, 1});
    drops()->albedo_lanes({&lambda_nm, 1}, {&albedo, 1});
    Intensities direct_phase, mirrored_phase;
    drops()->phase_lanes(dot(view, to_sun), 0, {&lambda_nm, 1}, {&direct_phase, 1});
    drops()->phase_lanes(dot(view, image), 0, {&lambda_nm, 1}, {&mirrored_phase, 1});
    const double i = std::acos(to_sun.y), t = std::asin(std::sin(i) / kIndex);
    const double level = std::pow(std::sin(i - t) / std::sin(i + t), 2);
    const double across = std::pow(std::tan(i - t) / std::tan(i + t), 2);
    const double by_sun = kIrradiance * albedo * direct_phase.unpolarised();
    const double by_image =
        kIrradiance * albedo * scattered(-image, -view, level, across, mirrored_phase);
    std::vector<LineInterval> inside;
    rain.cut({eye}, {view}, kInfinity, inside);
    Expected sum{0.0, 0.0};
    for (const LineInterval& part : inside) {
        for (int step = 0; step < kSteps; ++step) {
            const double ds = (part.end - part.begin) / kSteps;
            const double s = part.begin + (step + 0.5) * ds;
            const Vec3 p = eye + view * s;
            const double to_eye = rain.length_inside({eye}, {view}, s);
            const double down = (p.y - kLake_m) / to_sun.y;
            const double from_sun = rain.length_inside({p}, {to_sun}, kInfinity);
            const double by_lake = rain.length_inside({p}, {image}, down) +
                                   rain.length_inside({p + image * down}, {to_sun}, kInfinity);
            sum.direct += by_sun * std::exp(-extinction * (to_eye + from_sun)) * extinction * ds;
            sum.mirrored += by_image * std::exp(-extinction * (to_eye + by_lake)) * extinction * ds;
        }
    }
    return sum;
}

/// Means over samples of what a ray brings home at the first lane of a packet.
double by_path(const Scene& scene, Vec3 eye, Vec3 view, double& lambda_nm) {
    const PreparedScene prepared(scene);
    const WavelengthPacket packet = sample_wavelengths(WavelengthSampling::visual, 4, 0.05);
    lambda_nm = packet.lambda_nm[0];
    double sum = 0.0;
    for (std::uint32_t k = 0; k < kSamples; ++k)
        sum += trace_sample(prepared, {eye, view, {}}, {}, packet, SampleKey(11, k)).radiance[0];
    return sum / kSamples;
}

TEST(RainMirror, ALakeAddsTheBowOfItsSun) {
    const Dir<World> to_sun{normalised({0.3, 0.4, 0.9})};
    const Transform<World, Object> place(translation({0, 30, -60}) *
                                         rotation({0, 1, 0}, 20.0 * deg));
    const Vec3 eye{2, 3, 0};
    double largest = 0.0, lambda_nm = 0.0;
    for (const ConvexRegion& region :
         {ConvexRegion::box(place, {30, 29, 40}), ConvexRegion::layer(0.0 * m, 80.0 * m)}) {
        for (const Vec3 aim :
             {Vec3{-0.2, 0.5, -0.8}, Vec3{0.1, 0.3, -1.0}, Vec3{-0.3, 0.9, -1.0}}) {
            const Vec3 view = normalised(aim);
            const Scene scene = lake_in_rain(to_sun, region);
            const double found = by_path(scene, eye, view, lambda_nm);
            const Expected expected = by_quadrature(scene, eye, view, lambda_nm);
            EXPECT_NEAR(found / (expected.direct + expected.mirrored), 1.0, kAccuracy);
            largest = std::max(largest, expected.mirrored / (expected.direct + expected.mirrored));
        }
    }
    EXPECT_GT(largest, 20.0 * kAccuracy);  // it is more than the tolerance hides
}

// A raft on the lake, where its light would come from, takes it away; and so does a dry lake bed.
TEST(RainMirror, WhereNoWaterIsThereIsNoSecondSun) {
    const Dir<World> to_sun{normalised({0.3, 0.4, 0.9})};
    const Vec3 eye{2, 3, 0}, view = normalised({0.1, 0.3, -1.0});
    Scene scene = lake_in_rain(to_sun, ConvexRegion::layer(0.0 * m, 80.0 * m));
    const int black = scene.add({"black", Black{}, {}});
    const Transform<World, Object> up(translation({0, kLake_m + 1e-3, 0}) *
                                      rotation({1, 0, 0}, -90.0 * deg));
    scene.shapes.push_back({"raft", Disc{5000.0 * m}, up, black});
    double lambda_nm;
    const double found = by_path(scene, eye, view, lambda_nm);
    const Expected expected = by_quadrature(scene, eye, view, lambda_nm);
    EXPECT_NEAR(found / expected.direct, 1.0, kAccuracy);
    EXPECT_GT(expected.mirrored / expected.direct, 2.0 * kAccuracy);
}

// In rain without end the sun is as bright as everywhere, and the sky behind it is gone.
TEST(RainMirror, EndlessRainIsLitAndHidesTheSky) {
    const Dir<World> to_sun{normalised({0.3, 0.4, 0.9})};
    Scene scene = lake_in_rain(to_sun, ConvexRegion::everywhere());
    scene.shapes.clear();
    scene.lights.push_back(UniformEnvironment{make_constant(0.0)});
    const Vec3 view = normalised({0.1, 0.3, -1.0});
    double lambda_nm;
    const double found = by_path(scene, {2, 3, 0}, view, lambda_nm);
    double albedo;
    drops()->albedo_lanes({&lambda_nm, 1}, {&albedo, 1});
    Intensities phase;
    drops()->phase_lanes(dot(view, to_sun.v), 0, {&lambda_nm, 1}, {&phase, 1});
    EXPECT_NEAR(found / (kIrradiance * albedo * phase.unpolarised()), 1.0, kAccuracy);
    std::get<UniformEnvironment>(scene.lights[1]).radiance = make_constant(5.0);
    // The sky lights the drops: uniform light of 5 is scattered to 5, but for what drops absorb.
    const double with_sky = by_path(scene, {2, 3, 0}, view, lambda_nm);
    EXPECT_NEAR((with_sky - found) / (5.0 * albedo), 1.0, 0.2);
}

}  // namespace
}  // namespace dewbow
