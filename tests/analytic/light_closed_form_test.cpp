// SPDX-License-Identifier: Apache-2.0

// Light on a diffuse wall: E ρ / π, with the irradiance E of each kind of light in closed form.

#include <gtest/gtest.h>

#include "dewbow/render/punctual_light.h"
#include "scene_kit.h"
#include "statistics.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr double kReflectance = 0.7;
/// Light without extent leaves nothing to chance, where it is alone: rounding.
constexpr double kExact = 1e-7;
/// Two-sided 1e-8 for one z: below 1e-6 for all of this file.
constexpr double kSigmas = 5.73;
/// An error of this share of what is expected is found with probability 0.99.
constexpr double kDetectable = 0.02;

/// A wall in y = 0 that faces up.
Scene wall_scene(double side = 200.0) {
    Scene scene = empty_scene();
    scene.render.max_depth = 64;
    scene.render.roulette_depth = 64;
    add(scene, Rectangle{side * m, side * m}, diffuse(kReflectance),
        rotation({1, 0, 0}, -90.0 * deg));
    return scene;
}

/// From the side and above to the origin, from so near that nothing stands between.
const Vec3 kLook = normalised({0.8, -0.5, 0.3});
const Ray kRay{-0.02 * kLook, kLook, {}};

MeanSums radiance(const Scene& scene, std::size_t samples, int packet = 1, const Ray& ray = kRay) {
    const PreparedScene prepared(scene);
    const MediaStack start = media_at(ray.origin, scene, prepared.media, prepared.accelerator);
    constexpr std::size_t kChunks = 64;
    std::vector<MeanSums> parts(kChunks);
    in_chunks(samples, kChunks, [&](std::size_t chunk, std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            const SampleKey key = independent_key(5, i);
            const PixelSample sample =
                trace_sample(prepared, ray, start, packet_of(key, packet), key);
            double mean = 0.0;
            for (int k = 0; k < packet; ++k)
                mean += sample.radiance[std::size_t(k)] / double(packet);
            parts[chunk].add(mean);
        }
    });
    MeanSums all;
    for (const MeanSums& part : parts) all.add(part);
    return all;
}

void expect_exactly(const Scene& scene, double irradiance) {
    const double expected = irradiance * kReflectance / kPi;
    const MeanSums found = radiance(scene, 100);
    EXPECT_NEAR(found.mean() / expected, 1.0, kExact);
    EXPECT_LT(found.standard_error(), kExact * expected);
}

/// `expected` radiance on average.
void expect_mean(const Scene& scene, double expected, std::size_t samples = 200000, int packet = 1,
                 const Ray& ray = kRay) {
    const MeanSums found = radiance(scene, samples, packet, ray);
    const double error = found.standard_error();
    EXPECT_NEAR(found.mean() / expected, 1.0, kSigmas * error / expected + kExact)
        << "z = " << (found.mean() - expected) / error;
    EXPECT_LT((kSigmas + kPower99) * error, kDetectable * expected) << "too few samples";
}

TEST(LightClosedForm, PointLightFallsWithTheSquare) {
    for (const double height : {0.5, 1.0, 7.0}) {
        Scene scene = wall_scene();
        scene.lights.push_back(PointLight{{{0, height, 0}}, make_constant(3.0)});
        expect_exactly(scene, 3.0 / (height * height));
    }
    Scene aside = wall_scene();
    aside.lights.push_back(PointLight{{{3, 4, 0}}, make_constant(2.0)});
    expect_exactly(aside, 2.0 / 25.0 * (4.0 / 5.0));
}

TEST(LightClosedForm, SpotFallsOffBetweenItsAngles) {
    for (const double angle_deg : {0.0, 10.0, 22.0, 27.0, 29.9, 31.0}) {
        Scene scene = wall_scene();
        const double angle = angle_deg * kPi / 180.0;
        // The light hangs over the place; its axis is turned away from it.
        scene.lights.push_back(SpotLight{{{0, 2, 0}},
                                         {{std::sin(angle), -std::cos(angle), 0}},
                                         20.0 * deg,
                                         30.0 * deg,
                                         make_constant(5.0)});
        const double inner = std::cos(20.0 * kPi / 180.0), outer = std::cos(30.0 * kPi / 180.0);
        const double inside = std::clamp((std::cos(angle) - outer) / (inner - outer), 0.0, 1.0);
        if (inside > 0.0)
            expect_exactly(scene, 5.0 / 4.0 * inside * inside);
        else
            EXPECT_EQ(radiance(scene, 100).mean(), 0.0);
    }
}

/// I(θ, φ) cos / d², with the intensity of the web between its rows by hand.
TEST(LightClosedForm, ProfileShinesAsItsWeb) {
    // Falls to nothing at 60°; at φ = 90° it is twice as bright as at 0°, 180° and 270°.
    PhotometricTable table{{0, 30, 60}, {0, 90, 180, 270, 360}, {}};
    for (const double factor : {1.0, 2.0, 1.0, 1.0, 1.0})
        for (const double cd : {400.0, 100.0, 0.0}) table.intensity_cd.push_back(factor * cd);
    const auto web = std::make_shared<const PhotometricWeb>(table);
    const auto scene_of = [&](Vec3 position, const Affine& turn) {
        Scene scene = wall_scene();
        scene.lights.push_back(
            ProfileLight{{position}, Transform<World, Object>(turn), web, make_constant(0.01)});
        return scene;
    };
    const double h = 2.0;
    for (const double theta_deg : {0.0, 10.0, 30.0, 45.0, 59.0}) {
        SCOPED_TRACE(theta_deg);
        const double theta = theta_deg * kPi / 180.0, d = h / std::cos(theta);
        const double cd =
            theta_deg < 30.0 ? 400.0 - 10.0 * theta_deg : 100.0 * (60.0 - theta_deg) / 30.0;
        const double e = 0.01 * cd * std::cos(theta) / (d * d);
        const double aside = h * std::tan(theta);
        // φ = 0 is +x, so that the lamp stands on the other side of what it shines on.
        expect_exactly(scene_of({-aside, h, 0}, {}), e);
        // φ = 90° is −z; there is nothing to tell directions apart at nadir.
        if (theta_deg > 0.0) expect_exactly(scene_of({0, h, aside}, {}), 2.0 * e);
        // Turned by 45° about the vertical, halfway between 0° and 90°.
        if (theta_deg > 0.0)
            expect_exactly(scene_of({-aside, h, 0}, rotation({0, 1, 0}, -45.0 * deg)), 1.5 * e);
    }
    const Scene beyond = scene_of({2.0 * h, h, 0}, {});
    EXPECT_EQ(radiance(beyond, 100).mean(), 0.0);
}

/// E cos θ within the cylinder, nothing outside and nothing behind.
TEST(LightClosedForm, BeamIsAsBrightEverywhere) {
    for (const double angle_deg : {0.0, 40.0, 75.0}) {
        const double angle = angle_deg * kPi / 180.0;
        const Vec3 direction{std::sin(angle), -std::cos(angle), 0};
        const auto scene_of = [&](double distance, Vec3 aside) {
            Scene scene = wall_scene();
            scene.lights.push_back(BeamLight{
                {-distance * direction + aside}, {direction}, 0.01 * m, make_constant(4.0)});
            return scene;
        };
        for (const double distance : {0.5, 50.0})
            expect_exactly(scene_of(distance, {0, 0, 0.0099}), 4.0 * std::cos(angle));
        EXPECT_EQ(radiance(scene_of(0.5, {0, 0, 0.0101}), 100).mean(), 0.0);
        EXPECT_EQ(radiance(scene_of(-0.5, {}), 100).mean(), 0.0);
    }
}

/// A plate, however it is turned, takes E π r² of a beam that falls on it wholly.
TEST(LightClosedForm, BeamBringsItsPowerThroughAnyPlate) {
    constexpr int kSide = 4000;
    constexpr double kMidpoints = 2e-3;  // cells on the rim: some 1 / kSide of its length
    const double radius = 0.3, irradiance = 5.0;
    const Beam beam({{{0, 3, 0}}, {{0, -1, 0}}, radius * m, make_constant(irradiance)});
    for (const double angle_deg : {0.0, 30.0, 70.0}) {
        const double angle = angle_deg * kPi / 180.0;
        const Vec3 along{std::cos(angle), std::sin(angle), 0};
        const Receiver facing{{}, {-std::sin(angle), std::cos(angle), 0}};
        double power = 0.0;
        for (int i = 0; i < kSide * 2; ++i)
            for (int k = 0; k < kSide / 10; ++k) {
                const double a = 2.0 * ((i + 0.5) / (2 * kSide) - 0.5);
                const double b = 0.7 * ((k + 0.5) / (kSide / 10) - 0.5);
                const auto arrival = beam.arrival(along * a + Vec3{0, 0, b});
                if (!arrival) continue;
                power += irradiance * arrival->factor * dot(arrival->direction, facing.normal);
            }
        power *= 2.0 / (2 * kSide) * 0.7 / (kSide / 10);
        EXPECT_NEAR(power / (irradiance * kPi * radius * radius), 1.0, kMidpoints) << angle_deg;
    }
}

TEST(LightClosedForm, ParallelLightFallsWithTheCosine) {
    for (const double angle_deg : {0.0, 45.0, 80.0}) {
        Scene scene = wall_scene();
        const double angle = angle_deg * kPi / 180.0;
        scene.lights.push_back(
            DistantLight{{{std::sin(angle), -std::cos(angle), 0}}, 0.0 * deg, make_constant(4.0)});
        expect_exactly(scene, 4.0 * std::cos(angle));
    }
}

/// The irradiance that a distant light states is that of a surface which faces it, also where its
/// disc is large.
TEST(LightClosedForm, DistantDiscKeepsItsIrradiance) {
    for (const double radius_deg : {0.2666, 5.0, 30.0}) {
        Scene scene = wall_scene();
        scene.lights.push_back(DistantLight{{{0, -1, 0}}, radius_deg * deg, make_constant(4.0)});
        SCOPED_TRACE(radius_deg);
        expect_mean(scene, 4.0 * kReflectance / kPi, 100000);
        // From aside: the whole disc is above the horizon, so it is the cosine to its centre.
        Scene aside = wall_scene();
        aside.lights.push_back(
            DistantLight{{normalised({1, -1, 0})}, radius_deg * deg, make_constant(4.0)});
        expect_mean(aside, 4.0 * std::sqrt(0.5) * kReflectance / kPi, 200000);
    }
}

TEST(LightClosedForm, EvenSky) {
    Scene scene = wall_scene();
    scene.lights.push_back(UniformEnvironment{make_constant(2.0)});
    expect_mean(scene, 2.0 * kReflectance, 500000);
}

/// E = π L (r / d)² cos θ, while the whole sphere is above the horizon.
TEST(LightClosedForm, Sphere) {
    for (const Vec3 centre : {Vec3{0, 3, 0}, Vec3{2, 2, 1}, Vec3{0.0, 1.05, 0.0}}) {
        Scene scene = wall_scene();
        add(scene, Sphere{1.0 * m}, lamp(2.0), translation(centre));
        const double d2 = dot(centre, centre);
        const double e = kPi * 2.0 / d2 * centre.y / std::sqrt(d2);
        expect_mean(scene, e * kReflectance / kPi, 300000);
    }
}

/// The same as an ellipsoid that is a sphere, as a mesh, and blown up from another radius.
TEST(LightClosedForm, SphereInOtherWords) {
    const Vec3 centre{1, 3, 0};
    const double d2 = dot(centre, centre);
    const double e = kPi * 2.0 / d2 * centre.y / std::sqrt(d2);
    Scene scaled = wall_scene();
    add(scaled, Sphere{0.25 * m}, lamp(2.0), translation(centre) * scaling({4, 4, 4}));
    expect_mean(scaled, e * kReflectance / kPi);
    // 1e-8 from a sphere: the sampling of ellipsoids.
    Scene ellipsoid = wall_scene();
    add(ellipsoid, Sphere{0.25 * m}, lamp(2.0), translation(centre) * scaling({4, 4 + 4e-8, 4}));
    expect_mean(ellipsoid, e * kReflectance / kPi, 2000000);
    // 20480 triangles: its area falls short of the sphere's by 1.5e-4.
    Scene faceted = wall_scene();
    add(faceted, sphere_mesh(1.0, 5), lamp(2.0), translation(centre));
    expect_mean(faceted, e * kReflectance / kPi, 1500000);
}

/// E = π L r² / (r² + h²) under the middle of a disc.
TEST(LightClosedForm, Disc) {
    Scene scene = wall_scene();
    add(scene, Disc{1.5 * m}, lamp(2.0), translation({0, 2, 0}) * rotation({1, 0, 0}, 90.0 * deg));
    expect_mean(scene, kPi * 2.0 * 2.25 / (2.25 + 4.0) * kReflectance / kPi);
    // Its back is dark.
    Scene turned = wall_scene();
    add(turned, Disc{1.5 * m}, lamp(2.0),
        translation({0, 2, 0}) * rotation({1, 0, 0}, -90.0 * deg));
    EXPECT_EQ(radiance(turned, 1000).mean(), 0.0);
    // But for one that shines both ways.
    Scene both = wall_scene();
    add(both, Disc{1.5 * m}, lamp(2.0, true),
        translation({0, 2, 0}) * rotation({1, 0, 0}, -90.0 * deg));
    expect_mean(both, kPi * 2.0 * 2.25 / (2.25 + 4.0) * kReflectance / kPi);
}

/// Above a corner: E = L/2 [a/√(1+a²) atan(b/√(1+a²)) + b/√(1+b²) atan(a/√(1+b²))], four times.
/// [Howell, factor of a differential area and a parallel rectangle]
TEST(LightClosedForm, Rectangle) {
    const double height = 1.5, a = 0.5 / height, b = 1.0 / height;
    const double corner = 0.5 * (a / std::hypot(1.0, a) * std::atan(b / std::hypot(1.0, a)) +
                                 b / std::hypot(1.0, b) * std::atan(a / std::hypot(1.0, b)));
    const double expected = 2.0 * 4.0 * corner * kReflectance / kPi;
    Scene scene = wall_scene();
    add(scene, Rectangle{1.0 * m, 2.0 * m}, lamp(2.0),
        translation({0, height, 0}) * rotation({1, 0, 0}, 90.0 * deg));
    expect_mean(scene, expected);
    // A box whose lower face is that rectangle: its other faces cannot be seen.
    Scene box = wall_scene();
    add(box, Box{1.0 * m, 0.5 * m, 2.0 * m}, lamp(2.0), translation({0, height + 0.25, 0}));
    expect_mean(box, expected, 600000);
}

/// All of them together: the choice among lights has no say in the mean.
TEST(LightClosedForm, ManyLightsAddUp) {
    Scene scene = wall_scene();
    scene.lights.push_back(PointLight{{{3, 4, 0}}, make_constant(20.0)});
    scene.lights.push_back(DistantLight{{{0, -1, 0}}, 0.0 * deg, make_constant(1.0)});
    scene.lights.push_back(DistantLight{{normalised({1, -1, 0})}, 2.0 * deg, make_constant(1.0)});
    add(scene, Sphere{0.5 * m}, lamp(10.0), translation({0, 2, 2}));
    add(scene, Disc{0.3 * m}, lamp(8.0), translation({-3, 2, 0}) * rotation({1, 0, 0}, 90.0 * deg));
    const double sphere = kPi * 10.0 * 0.25 / 8.0 * std::sqrt(0.5);
    // Small and aside: the exact factor of a parallel disc. [Howell, A-9]
    const double h = 2.0 / 3.0, r = 0.3 / 3.0, z = 1.0 + h * h + r * r;
    const double disc =
        kPi * 8.0 * 0.5 * (1.0 - (1.0 + h * h - r * r) / std::sqrt(z * z - 4.0 * r * r));
    const double e = 20.0 / 25.0 * 0.8 + 1.0 + std::sqrt(0.5) + sphere + disc;
    expect_mean(scene, e * kReflectance / kPi, 1000000);
}

/// A lamp wrapped in glass: radiance in glass is n² times that of the same light outside, so what
/// is seen of it outside is (1 − R) L / n².
TEST(LightClosedForm, AnEmitterInGlassIsScaledByTheIndices) {
    const double n = 1.6;
    Scene scene = empty_scene();
    add(scene, Sphere{1.0 * m}, dielectric(plain(n)));
    add(scene, Sphere{0.3 * m}, lamp(2.0));
    const double r = std::pow((n - 1.0) / (n + 1.0), 2.0);
    const Ray ray{{0, 0, 4}, {0, 0, -1}, {}};
    expect_mean(scene, (1.0 - r) * 2.0 / (n * n), 100000, 1, ray);
    // From within, it is what it is.
    EXPECT_NEAR(radiance(scene, 10, 1, {{0, 0, 0.8}, {0, 0, -1}, {}}).mean(), 2.0, kExact);
}

// ---- light within media ------------------------------------------------------------------------

constexpr double kSigma = 0.4;  // m⁻¹

/// Wall, lamp and eye in a medium that absorbs: exp(−σ s) from lamp to wall, and again to the eye.
TEST(LightClosedForm, DirectLightIsAbsorbed) {
    const Ray far{-2.0 * kLook, kLook, {}};
    const double seen = std::exp(-kSigma * 2.0);
    Scene point = wall_scene();
    point.surroundings = plain(1.0, make_constant(kSigma), -1000);
    point.lights.push_back(PointLight{{{3, 4, 0}}, make_constant(20.0)});
    const double e = 20.0 / 25.0 * 0.8 * std::exp(-kSigma * 5.0);
    expect_mean(point, seen * e * kReflectance / kPi, 1000, 1, far);
    // A small sphere: its face is nearer than its centre by 2/3 of the radius on average.
    Scene sphere = wall_scene();
    sphere.surroundings = point.surroundings;
    add(sphere, Sphere{0.02 * m}, lamp(2000.0), translation({3, 4, 0}));
    const double es = kPi * 2000.0 * 4e-4 / 25.0 * 0.8 * std::exp(-kSigma * (5.0 - 0.04 / 3.0));
    expect_mean(sphere, seen * es * kReflectance / kPi, 400000, 1, far);
}

/// A body whose glass is as air is not there, wherever it lies between wall and lamp.
TEST(LightClosedForm, ABodyLikeAirIsNotThere) {
    const Vec3 centre{2, 2, 1};
    const double e = kPi * 2.0 / 9.0 * 2.0 / 3.0;
    Scene scene = wall_scene();
    add(scene, Sphere{1.0 * m}, lamp(2.0), translation(centre));
    add(scene, Sphere{0.3 * m}, dielectric(medium(vacuum())), translation(0.4 * centre));
    expect_mean(scene, e * kReflectance / kPi, 400000);
}

/// A wall and a lamp, both wholly in water, with the surface of a weaker body between them: where
/// the bodies overlap there is water, and the weaker one's surface is nothing. Then the same with
/// the surface of a body that is as strong and made of the same.
TEST(LightClosedForm, SurfacesInsideAStrongerBodyAreNotThere) {
    const Vec3 centre{2, 2, 1};
    const double e = kPi * 2.0 / 9.0 * 2.0 / 3.0;
    for (const bool same : {false, true}) {
        SCOPED_TRACE(same);
        Scene scene = wall_scene(60.0);
        // The wall reflects little light back from the walls of so large a box; they are 100 m away
        // and black.
        scene.render.max_depth = 3;
        scene.render.roulette_depth = 3;
        const MediumPtr water = plain(1.33, nullptr, 1);
        add(scene, Box{300.0 * m, 300.0 * m, 300.0 * m}, dielectric(water));
        add(scene, Sphere{1.0 * m}, lamp(2.0), translation(centre));
        add(scene, Sphere{0.5 * m}, dielectric(same ? water : plain(1.5, nullptr, 0)),
            translation(0.4 * centre));
        expect_mean(scene, e * kReflectance / kPi, 2500000);
    }
}

/// A rough surface without a step of the index bends nothing either.
TEST(LightClosedForm, RoughnessOfABodyLikeAirIsNotSeen) {
    for (const double sigma : {0.0, 0.3}) {
        Scene scene = furnace_scene();
        add(scene, Sphere{1.0 * m},
            dielectric(medium(vacuum(), sigma > 0.0 ? make_constant(sigma) : nullptr), 0.5));
        const double expected = std::exp(-2.0 * sigma);
        for (const int packet : {1, 8})
            EXPECT_NEAR(radiance(scene, 100, packet, {{0, 0, 4}, {0, 0, -1}, {}}).mean(), expected,
                        kExact);
    }
}

/// Roulette is played once a surface: not again where the next surface is none.
TEST(LightClosedForm, RouletteLeavesTheMeanAlone) {
    Scene scene = empty_scene();
    scene.render.max_depth = 16;
    scene.render.roulette_depth = 1;
    add(scene, Box{30.0 * m, 30.0 * m, 30.0 * m}, dielectric(plain(1.33, nullptr, 1)));
    add(scene, Rectangle{2.0 * m, 2.0 * m}, {"dim", Mirror{make_constant(0.01)}, nullptr, false});
    for (const double z : {1.0, 2.0, 3.0})
        add(scene, Sphere{0.4 * m}, dielectric(plain(1.5)), translation({0, 0, z}));
    add(scene, Rectangle{2.0 * m, 2.0 * m}, lamp(2.0, true), translation({0, 0, 4}));
    expect_mean(scene, 0.02, 4000000, 1, {{0, 0, 0.5}, {0, 0, -1}, {}});
}

/// Two mirrors of black glass: r(λ)² of the light at 45°, wavelength by wavelength. At the second
/// one all lanes go one way, each weighted by its own reflectance over their mean. (With that
/// weight left out by hand it turns red; the mean over all wavelengths hardly sees it.)
TEST(LightClosedForm, TwoReflectionsKeepEachWavelengthsShare) {
    Scene scene = empty_scene();
    const MediumPtr flint = glass("schott/N-SF66", make_constant(1e4));
    const Geometry plate = Box{1.0 * m, 0.2 * m, 1.0 * m};
    add(scene, plate, dielectric(flint),
        rotation({0, 0, 1}, -45.0 * deg) * translation({0, -0.1, 0}));
    add(scene, plate, dielectric(flint),
        translation({3, 0, 0}) * rotation({0, 0, 1}, 45.0 * deg) * translation({0, -0.1, 0}));
    add(scene, Rectangle{1.0 * m, 1.0 * m}, lamp(1.0, true),
        translation({3, 3, 0}) * rotation({1, 0, 0}, 90.0 * deg));
    const PreparedScene prepared(scene);
    constexpr int kBins = 10;
    std::array<MeanSums, kBins> bins;
    for (std::size_t i = 0; i < 200000; ++i) {
        const SampleKey key = independent_key(6, i);
        const WavelengthPacket lanes = packet_of(key, 8, WavelengthSampling::uniform);
        const PixelSample sample =
            trace_sample(prepared, {{0, 2, 0}, {0, -1, 0}, {}}, {}, lanes, key);
        for (std::size_t k = 0; k < 8; ++k) {
            const double n = index_of(*flint, lanes.lambda_nm[k]);
            const double t = std::asin(std::sqrt(0.5) / n), d = kPi / 4.0 - t, u = kPi / 4.0 + t;
            const double s = std::sin(d) / std::sin(u), tangent = std::tan(d) / std::tan(u);
            const double r = 0.5 * (s * s + tangent * tangent);
            const int bin = int(kBins * (lanes.lambda_nm[k] - kLambdaMin_nm) / 470.0);
            bins[std::size_t(std::min(bin, kBins - 1))].add(sample.radiance[k] / (r * r) - 1.0);
        }
    }
    for (const MeanSums& bin : bins) {
        EXPECT_LT(std::abs(bin.z()), kSigmas);
        EXPECT_LT((kSigmas + kPower99) * bin.standard_error(), 0.06);
    }
}

// ---- layers ------------------------------------------------------------------------------------

/// Reflectance and transmittances of a stack of plates, without interference.
struct Layer {
    double r_top, r_bottom, t;  // t: of radiance / n², the same both ways
};
Layer on_top(const Layer& a, const Layer& b) {
    const double loop = 1.0 / (1.0 - a.r_bottom * b.r_top);
    return {a.r_top + a.t * a.t * b.r_top * loop, b.r_bottom + b.t * b.t * a.r_bottom * loop,
            a.t * b.t * loop};
}
Layer interface_between(double n1, double n2) {
    const double r = std::pow((n2 - n1) / (n2 + n1), 2.0);
    return {r, r, 1.0 - r};
}
Layer bulk(double sigma, double thickness) { return {0, 0, std::exp(-sigma * thickness)}; }

/// A plate of glass over one of water that overlap by half: by priority the overlap is one of them,
/// and the stack is as one without overlap.
TEST(LightClosedForm, OverlapByPriorityIsAStackWithoutOverlap) {
    const auto stack = [](double glass_thickness, double water_thickness) {
        Layer s = interface_between(1.0, 1.6);
        s = on_top(s, bulk(0.5, glass_thickness));
        s = on_top(s, interface_between(1.6, 1.33));
        s = on_top(s, bulk(0.3, water_thickness));
        return on_top(s, interface_between(1.33, 1.0));
    };
    for (const int glass_priority : {0, 2}) {
        Scene scene = empty_scene();
        add(scene, Box{100.0 * m, 1.0 * m, 100.0 * m},
            dielectric(plain(1.6, make_constant(0.5), glass_priority)), translation({0, 0.5, 0}));
        add(scene, Box{100.0 * m, 1.0 * m, 100.0 * m},
            dielectric(plain(1.33, make_constant(0.3), 1)), translation({0, 0.0, 0}));
        add(scene, Rectangle{400.0 * m, 400.0 * m}, lamp(2.0),
            translation({0, -3, 0}) * rotation({1, 0, 0}, -90.0 * deg));
        const Layer expected = glass_priority == 2 ? stack(1.0, 0.5) : stack(0.5, 1.0);
        for (const int packet : {1, 8})
            expect_mean(scene, 2.0 * expected.t, 200000, packet, {{0, 4, 0}, {0, -1, 0}, {}});
    }
}

/// Planted: the wrong body in the overlap.
TEST(LightClosedForm, SeesTheWrongBodyInAnOverlap) {
    Scene scene = empty_scene();
    add(scene, Box{100.0 * m, 1.0 * m, 100.0 * m}, dielectric(plain(1.6, make_constant(0.5), 0)),
        translation({0, 0.5, 0}));
    add(scene, Box{100.0 * m, 1.0 * m, 100.0 * m}, dielectric(plain(1.33, make_constant(0.3), 1)));
    add(scene, Rectangle{400.0 * m, 400.0 * m}, lamp(2.0),
        translation({0, -3, 0}) * rotation({1, 0, 0}, -90.0 * deg));
    const MeanSums found = radiance(scene, 200000, 1, {{0, 4, 0}, {0, -1, 0}, {}});
    const double wrong = 2.0 * 0.8 * std::exp(-0.5 - 0.15);
    EXPECT_GT(std::abs(found.mean() - wrong) / found.standard_error(), kSigmas);
}

}  // namespace
}  // namespace dewbow
