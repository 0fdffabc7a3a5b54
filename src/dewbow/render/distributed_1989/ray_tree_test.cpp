// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/distributed_1989/ray_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/optics/catalogue.h"
#include "dewbow/optics/paper_index.h"
#include "dewbow/spectrum/illuminant.h"

namespace dewbow::distributed_1989 {
namespace {

using unit::m;

/// Quadrature of white at 0.5 nm, for the film and for the model.
constexpr double kWhiteByQuadrature = 1e-6;

MediumPtr flint() {
    return std::make_shared<Medium>(
        Medium{"SF11", make_dispersion(find_glass("schott/SF11").data), nullptr, 0});
}

void add(Scene& scene, Geometry geometry, Material material, const Affine& place = {}) {
    const int id = scene.add(std::move(material));
    scene.shapes.push_back({"shape", std::move(geometry), Transform<World, Object>(place), id});
}

/// A slab of flint, 1 m thick, across the z axis, amid light of `times` the film's white.
Scene slab_in_light(double times) {
    Scene scene = make_empty_scene();
    add(scene, Box{100.0 * m, 100.0 * m, 1.0 * m}, {"flint", Dielectric{flint()}});
    scene.lights.push_back(UniformEnvironment{make_scaled(find_illuminant("D65"), times)});
    scene.render.distributed_1989.least_weight = 0.0;
    return scene;
}

/// Monitor numbers of what arrives along a ray.
class Eye {
public:
    explicit Eye(const Scene& scene) : method_(scene), workspace_(method_) {}

    MonitorRgb see(const Ray& ray, std::uint32_t sample = 0) {
        const PixelSample found =
            RayTree(method_, SampleKey(7, sample), workspace_).grow(ray, MediaStack{});
        return method_.sampling().model().rgb(*found.colour);  // the film's white is 1
    }
    const Method& method() const { return method_; }

private:
    Method method_;
    Workspace workspace_;
};

const Ray kThrough{{0, 0, 5}, {0, 0, -1}, {}};
const Ray kAskew{{0, 0, 5}, normalised(Vec3{0.3, 0.7, -1}), {}};

void expect_grey(MonitorRgb rgb, double value, double tolerance) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], value, tolerance) << c;
}

// What glass takes from one way it gives to the other: amid white all is white.
TEST(RayTree, AFurnaceIsWhiteInEveryWay) {
    constexpr double kLeastWeight = 1e-7, kTails = 1e-5;
    for (const SpectralColours colours :
         {SpectralColours::linear, SpectralColours::empirical, SpectralColours::cie})
        for (const RgbOrSpectral transport : {RgbOrSpectral::rgb, RgbOrSpectral::spectral})
            for (const ReflectanceAt reflectance :
                 {ReflectanceAt::nominal, ReflectanceAt::spectral})
                for (const IndexSource index : {IndexSource::linear, IndexSource::scene})
                    for (const int samples : {5, 13}) {
                        Scene scene = slab_in_light(1.0);
                        auto& settings = scene.render.distributed_1989;
                        settings.model.colours = colours;
                        settings.transport = transport;
                        settings.reflectance = reflectance;
                        settings.index = index;
                        settings.sampling.samples = samples;
                        settings.sum = SampleSum::free;
                        settings.least_weight = kLeastWeight;
                        // Reflectance in channels is that at three wavelengths, and that of samples
                        // at their own: what one takes the other need not give.
                        const bool own = transport == RgbOrSpectral::rgb &&
                                         reflectance == ReflectanceAt::spectral;
                        // With 5 samples R differs from its mean over the spectrum.
                        const double tolerance = own                                      ? 2e-2
                                                 : reflectance == ReflectanceAt::spectral ? 2e-3
                                                                                          : kTails;
                        expect_grey(Eye(scene).see(kAskew), 1.0, tolerance);
                    }
}

/// By the index at sodium's line, at normal incidence.
double nominal_reflectance() {
    const double n =
        (*paper_index_of(flint()->index, IndexReading::intended))(kNominal_nm * unit::nm).value /
        (*air())(kNominal_nm * unit::nm).value;
    return std::pow((n - 1.0) / (n + 1.0), 2.0);
}

TEST(RayTree, SumsAreClampedWrappedOrFree) {
    const double r = nominal_reflectance(), through = 2.0 * (1.0 - r);
    struct Case {
        SampleSum sum;
        double limited;  // of `through`
    };
    const double wrapped = std::floor(255.0 * through + 0.5) - 256.0;
    for (const auto& [sum, limited] : {Case{SampleSum::clamp, 1.0}, Case{SampleSum::free, through},
                                       Case{SampleSum::wrap, wrapped / 255.0}}) {
        Scene scene = slab_in_light(2.0);
        scene.render.max_depth = 2;  // once reflected, or once through
        scene.render.distributed_1989.sum = sum;
        expect_grey(Eye(scene).see(kThrough), 2.0 * r + limited * (1.0 - r), kWhiteByQuadrature);
    }
}

// Before a mirror of 25 % white is a quarter of it, and so is what sums are clamped to.
TEST(RayTree, SumsAreClampedToWhatIsLeftOfWhite) {
    for (const RgbOrSpectral transport : {RgbOrSpectral::rgb, RgbOrSpectral::spectral}) {
        Scene scene = slab_in_light(2.0);
        add(scene, Rectangle{4.0 * m, 4.0 * m}, {"mirror", Mirror{make_constant(0.25)}},
            translation({0, 0, 4}));
        scene.render.max_depth = 3;
        scene.render.distributed_1989.transport = transport;
        const double r = nominal_reflectance();
        const Ray to_mirror{{0, 0, 3}, {0, 0, 1}, {}};  // and back into the slab
        // What the slab reflects meets the mirror again, which ends it.
        expect_grey(Eye(scene).see(to_mirror), 0.25 * (1.0 - r), kWhiteByQuadrature);
    }
}

TEST(RayTree, WeakBranchesAreDropped) {
    Scene scene = slab_in_light(1.0);
    scene.render.distributed_1989.least_weight = 0.5;
    const double r = nominal_reflectance();
    expect_grey(Eye(scene).see(kThrough), (1.0 - r) * (1.0 - r), kWhiteByQuadrature);
}

/// A prism of 60° and a small lamp, seen through it at minimum deviation.
struct ThroughPrism {
    Scene scene = make_empty_scene();
    Vec3 eye;
    double angle;  ///< of the ray at minimum deviation, from the x axis

    explicit ThroughPrism(int samples) {
        scene.render.distributed_1989.sampling.samples = samples;
        add(scene, Prism{60.0 * unit::deg, 20.0 * m, 20.0 * m}, {"flint", Dielectric{flint()}});
        const DispersionPtr line = paper_index_of(flint()->index, IndexReading::intended);
        const double n = (*line)(520.0 * unit::nm).value / (*air())(520.0 * unit::nm).value;
        angle = std::asin(n * 0.5) - std::numbers::pi / 6.0;
        // Halfway up, the sides are 5 m away.
        const Vec3 in{-std::cos(angle), -std::sin(angle), 0}, out{-in.x, in.y, 0};
        eye = Vec3{-5, 2.8867513, 0} + 20.0 * in;
        add(scene, Sphere{0.02 * m}, {"lamp", Black{}, find_illuminant("D65")},
            translation(Vec3{5, 2.8867513, 0} + 50.0 * out));
    }
    Ray at(double offset) const {
        return {eye, {std::cos(angle + offset), std::sin(angle + offset), 0}, {}};
    }
};

/// Brightest colour of each image along a fan of rays.
std::vector<MonitorRgb> images(const ThroughPrism& view) {
    constexpr int kRays = 6000;
    constexpr double kHalf = 0.08;  // rad
    Eye eye(view.scene);
    std::vector<MonitorRgb> found;
    bool within = false;
    for (int i = 0; i < kRays; ++i) {
        const MonitorRgb rgb = eye.see(view.at(kHalf * (2.0 * i / kRays - 1.0)), std::uint32_t(i));
        const double brightness = rgb[0] + rgb[1] + rgb[2];
        if (brightness <= 1e-9) {
            within = false;
            continue;
        }
        if (!within) found.emplace_back();
        MonitorRgb& image = found.back();
        if (brightness > image[0] + image[1] + image[2]) image = rgb;
        within = true;
    }
    return found;
}

// The white disc through a prism: 13 discs, from red to violet, each in the colour of its sample.
TEST(RayTree, FixedSamplesMakeAsManyImages) {
    for (const int samples : {5, 13, 31}) {
        const ThroughPrism view(samples);
        const std::vector<MonitorRgb> found = images(view);
        ASSERT_EQ(found.size(), std::size_t(samples));
        const Method method(view.scene);
        for (int k = 0; k < samples; ++k) {
            const MonitorRgb colour = method.sampling().sample(k, 0.5).rgb;
            // The more a colour is bent, the nearer to the apex it is seen.
            const MonitorRgb& image = found[std::size_t(k)];
            const double sum = colour[0] + colour[1] + colour[2];
            const double seen = image[0] + image[1] + image[2];
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(image[c] / seen, colour[c] / sum, kWhiteByQuadrature) << k;
        }
    }
}

TEST(RayTree, JitteredSamplesLieWithinTheirIntervals) {
    ThroughPrism view(13);
    const std::size_t fixed = images(view).size();
    view.scene.render.distributed_1989.sampling.jitter = Jitter::both;
    EXPECT_GT(images(view).size(), fixed);  // another place for each ray
}

TEST(RayTree, ALambertSurfaceTakesDirectLight) {
    constexpr double kIntensity = 3.0, kReflectance = 0.6, kHeight = 2.0;
    for (const RgbOrSpectral transport : {RgbOrSpectral::rgb, RgbOrSpectral::spectral}) {
        Scene scene = make_empty_scene();
        scene.render.distributed_1989.transport = transport;
        add(scene, Plane{}, {"grey", Diffuse{make_constant(kReflectance)}});
        scene.lights.push_back(
            PointLight{{{1, 0, kHeight}}, make_scaled(find_illuminant("D65"), kIntensity)});
        const double squared = 1.0 + kHeight * kHeight;
        const double expected =
            kReflectance / std::numbers::pi * kIntensity * kHeight / (squared * std::sqrt(squared));
        expect_grey(Eye(scene).see(kThrough), expected, kWhiteByQuadrature);
        // Glass stops shadow rays.
        add(scene, Box{1.0 * m, 1.0 * m, 0.1 * m}, {"flint", Dielectric{flint()}},
            translation({0.5, 0, 1}));
        expect_grey(Eye(scene).see({{0, 0, 0.5}, {0, 0, -1}, {}}), 0.0, 0.0);
    }
}

TEST(RayTree, RoughSurfacesGiveEachOtherNothing) {
    Scene scene = make_empty_scene();
    add(scene, Plane{}, {"grey", Diffuse{make_constant(0.9)}});
    add(scene, Rectangle{1.0 * m, 1.0 * m}, {"grey", Diffuse{make_constant(0.9)}},
        translation({0, 0, 2}));
    scene.lights.push_back(PointLight{{{0, 0, 3}}, find_illuminant("D65")});
    expect_grey(Eye(scene).see({{0, 0, 1}, {0, 0, -1}, {}}), 0.0, 0.0);  // in the shadow
}

TEST(RayTree, PanesAndFacetsGiveToOneWayWhatTheyTakeFromTheOther) {
    Scene pane = make_empty_scene();
    pane.lights.push_back(UniformEnvironment{find_illuminant("D65")});
    Scene frosted = slab_in_light(1.0);
    add(pane, Rectangle{9.0 * m, 9.0 * m}, {"pane", ThinDielectric{flint()->index}});
    expect_grey(Eye(pane).see(kAskew), 1.0, kWhiteByQuadrature);

    // Light that facets hide from each other is lost: 6 % at most of once through.
    constexpr double kLost = 0.06;
    std::get<Dielectric>(frosted.materials[0].surface).roughness = 0.3;
    frosted.render.distributed_1989.least_weight = 1e-3;
    Eye eye(frosted);
    constexpr std::uint32_t kSamples = 256;
    double mean = 0.0;
    for (std::uint32_t i = 0; i < kSamples; ++i) mean += eye.see(kThrough, i)[1] / kSamples;
    EXPECT_LE(mean, 1.0 + kWhiteByQuadrature);
    EXPECT_GE(mean, 1.0 - 2.0 * kLost);
}

// A rough metal sees lamps by shadow rays and the rest by a ray of its own: no lamp twice.
TEST(RayTree, LampsInGlossyMetalsAreCountedOnce) {
    Scene scene = make_empty_scene();
    scene.lights.push_back(UniformEnvironment{find_illuminant("D65")});
    add(scene, Plane{}, {"metal", Conductor{make_constant(0.2), make_constant(3.0), 0.7}});
    Eye eye(scene);
    constexpr std::uint32_t kSamples = 4096;
    // Fresnel's reflectance at normal incidence; rough metals reflect it to within a few per cent,
    // and 4096 stratified samples of the sky leave less than one.
    const double expected = (0.8 * 0.8 + 9.0) / (1.2 * 1.2 + 9.0);
    double mean = 0.0;
    for (std::uint32_t i = 0; i < kSamples; ++i) mean += eye.see(kThrough, i)[1] / kSamples;
    EXPECT_NEAR(mean, expected, 0.04);
}

TEST(RayTree, WhatIsSeenFirstFillsTheLayers) {
    const Scene scene = slab_in_light(1.0);
    const Method method(scene);
    Workspace workspace(method);
    const PixelSample sample = RayTree(method, SampleKey(1, 0), workspace).grow(kThrough, {});
    EXPECT_TRUE(sample.hit);
    EXPECT_EQ(sample.normal, (Vec3{0, 0, 1}));
}

}  // namespace
}  // namespace dewbow::distributed_1989
