// SPDX-License-Identifier: Apache-2.0
// What rays carry in all, against closed forms of the flux between a lamp and a receiver.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/base/random.h"
#include "dewbow/render/caustics/emission_scenes.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::caustics {
namespace {

using unit::deg;
using unit::m;

constexpr double kPi = std::numbers::pi;
constexpr int kRays = 1 << 14;
/// Of the mean over stratified rays of functions with edges: twice the worst of 16 keys.
constexpr double kMeanError = 1e-2;

/// Flux in W nm⁻¹ that meets a caster, of a lamp of one.
double flux(const Scene& scene) {
    const Ready ready(scene);
    const EmissionMap& map = ready.maps[0];
    WavelengthPacket packet;
    packet.count = 1;
    packet.lambda_nm[0] = 550.0;
    const LaneSet lanes = LaneSet::all(packet);
    RgbLightLanes rgb;
    rgb.begin(packet);
    double sum = 0.0;
    for (int i = 0; i < kRays; ++i) {
        const SampleKey key(stream_key(1, 0, 0), std::uint32_t(i));
        const auto a = key.two(0, Purpose::test);
        const auto ray =
            map.ray({a[0], a[1], key.third(0, Purpose::test), key.fourth(0, Purpose::test)});
        if (!ray || !ready.prepared.accelerator.intersect(ray->ray)) continue;
        const auto place = map.place(ray->ray);
        if (!place) continue;
        LaneValues carried;
        radiance(*ray, ready.prepared.lights, lanes, rgb, carried);
        sum += carried[0] / place->pdf / kRays;
    }
    return sum;
}

int add_lamp(Scene& scene, double radiance) {
    return scene.add({"lamp", Black{}, make_constant(radiance)});
}
const Affine kUp = rotation({1, 0, 0}, -90.0 * deg), kDown = rotation({1, 0, 0}, 90.0 * deg);

void expect_flux(const Scene& scene, double expected) {
    EXPECT_NEAR(flux(scene) / expected, 1.0, kMeanError);
}

TEST(EmissionFlux, OfAPointIsThatOfASolidAngle) {
    Scene scene = make_empty_scene();
    add_shape(scene, Sphere{0.5 * m}, translation({1, -2, 0.5}), add_glass(scene));
    scene.lights.push_back(PointLight{{{0.2, 0.1, 0}}, make_constant(3.0)});
    const double sine = 0.5 / length(Vec3{0.8, -2.1, 0.5});
    expect_flux(scene, 3.0 * 2.0 * kPi * (1.0 - std::sqrt(1.0 - sine * sine)));
}

/// A square mirror at half its side from a point: a sixth of the sphere.
TEST(EmissionFlux, OfAPointAtTheMiddleOfACube) {
    Scene scene = make_empty_scene();
    add_shape(scene, Rectangle{2.0 * m, 2.0 * m}, translation({0, -1, 0}) * kUp, add_mirror(scene));
    scene.lights.push_back(PointLight{{}, make_constant(1.0)});
    expect_flux(scene, 4.0 * kPi / 6.0);
}

TEST(EmissionFlux, OfTheSunIsThatOfAShadow) {
    for (const Angle radius : {0.0 * deg, 0.2666 * deg}) {
        Scene scene = make_empty_scene();
        add_shape(scene, Sphere{0.5 * m}, translation({1, -2, 0.5}), add_glass(scene));
        const Dir<World> d{normalised(Vec3{0.3, -1, 0.2})};
        scene.lights.push_back(DistantLight{d, radius, make_constant(2.0)});
        expect_flux(scene, 2.0 * kPi * 0.25);
        Scene pane = make_empty_scene();
        add_shape(pane, Rectangle{2.0 * m, 0.7 * m}, translation({1, -2, 0.5}) * kUp,
                  add_mirror(pane));
        pane.lights = scene.lights;
        // Of a disc of even radiance above the horizon the irradiance goes by the centre's cosine.
        expect_flux(pane, 2.0 * 1.4 * std::abs(d.v.y));
    }
}

TEST(EmissionFlux, OfAnEvenSkyIsThatOfTheWholeSurface) {
    Scene scene = make_empty_scene();
    add_shape(scene, Sphere{0.5 * m}, {}, add_glass(scene));
    scene.lights.push_back(UniformEnvironment{make_constant(2.0)});
    expect_flux(scene, 2.0 * kPi * 4.0 * kPi * 0.25);
}

/// From disc to disc. [Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", C-41]
TEST(EmissionFlux, FromDiscToDisc) {
    const double a = 0.5, b = 0.8, h = 0.6;
    Scene scene = make_empty_scene();
    add_shape(scene, Disc{b * m}, translation({0, -h, 0}) * kUp, add_mirror(scene));
    add_shape(scene, Disc{a * m}, kDown, add_lamp(scene, 2.0));
    const double x = 1.0 + (1.0 + b * b / (h * h)) / (a * a / (h * h));
    const double factor = 0.5 * (x - std::sqrt(x * x - 4.0 * b * b / (a * a)));
    expect_flux(scene, 2.0 * kPi * kPi * a * a * factor);
}

/// Between two equal parallel rectangles. [Howell, C-11]
TEST(EmissionFlux, FromRectangleToRectangle) {
    for (const double h : {0.4, 3.0, 30.0}) {
        const double x = 1.0 / h, y = 0.6 / h, x1 = std::sqrt(1.0 + x * x),
                     y1 = std::sqrt(1.0 + y * y);
        const double factor =
            2.0 / (kPi * x * y) *
            (std::log(x1 * y1 / std::sqrt(1.0 + x * x + y * y)) + x * y1 * std::atan(x / y1) +
             y * x1 * std::atan(y / x1) - x * std::atan(x) - y * std::atan(y));
        Scene scene = make_empty_scene();
        add_shape(scene, Rectangle{1.0 * m, 0.6 * m}, translation({0, -h, 0}) * kUp,
                  add_mirror(scene));
        add_shape(scene, Rectangle{1.0 * m, 0.6 * m}, kDown, add_lamp(scene, 2.0));
        expect_flux(scene, 2.0 * kPi * 0.6 * factor);
    }
}

/// From a ball to a disc that faces it. [Howell, C-140]
TEST(EmissionFlux, FromBallToDisc) {
    for (const double h : {1.2, 4.0}) {
        Scene scene = make_empty_scene();
        add_shape(scene, Disc{0.7 * m}, translation({0, -h, 0}) * kUp, add_mirror(scene));
        add_shape(scene, Sphere{0.3 * m}, {}, add_lamp(scene, 2.0));
        expect_flux(scene, 2.0 * kPi * 4.0 * kPi * 0.09 * 0.5 * (1.0 - h / std::hypot(h, 0.7)));
    }
}

TEST(EmissionFlux, OfASpotIsThatOfItsCones) {
    for (const double size : {0.5, 10.0}) {  // narrower and wider than the spot
        Scene scene = make_empty_scene();
        add_shape(scene, Sphere{size * m}, translation({0, -20, 0}), add_glass(scene));
        const Angle inner = 4.0 * deg, outer = 8.0 * deg;
        scene.lights.push_back(SpotLight{{}, {{0, -1, 0}}, inner, outer, make_constant(2.0)});
        const double cut = std::min(std::asin(size / 20.0), inner.to(unit::rad));
        // ∫ ((c − c_o) / (c_i − c_o))² dc from c_o to c_i
        const double rim = size > 1.0 ? (cos(inner) - cos(outer)) / 3.0 : 0.0;
        expect_flux(scene, 2.0 * 2.0 * kPi * ((1.0 - std::cos(cut)) + rim));
    }
}

TEST(EmissionFlux, OfABeamIsThatOfItsDiscOrOfTheShadow) {
    for (const double size : {0.1, 2.0}) {
        Scene scene = make_empty_scene();
        add_shape(scene, Sphere{size * m}, translation({0.1, -5, 0}), add_glass(scene));
        scene.lights.push_back(BeamLight{{}, {{0, -1, 0}}, 0.5 * m, make_constant(2.0)});
        const double radius = std::min(size, 0.5);
        expect_flux(scene, 2.0 * kPi * radius * radius);
    }
}

/// All that a lamp gives meets a bulb around it.
TEST(EmissionFlux, IntoABulbIsAllThereIs) {
    const auto into_bulb = [](Geometry geometry, const Affine& world, bool two_sided = false) {
        Scene scene = make_empty_scene();
        add_bulb(scene);
        const int lamp = add_lamp(scene, 2.0);
        scene.materials[std::size_t(lamp)].two_sided_emission = two_sided;
        add_shape(scene, std::move(geometry), world, lamp);
        return flux(scene) / (2.0 * kPi);
    };
    const Affine askew = rotation(normalised(Vec3{1, 0.2, 0.3}), 2.0 * unit::rad);
    EXPECT_NEAR(into_bulb(Box{0.3 * m, 0.4 * m, 0.5 * m}, askew) / 0.94, 1.0, kMeanError);
    EXPECT_NEAR(into_bulb(Rectangle{0.3 * m, 0.4 * m}, askew, true) / 0.24, 1.0, kMeanError);
    const double triangle = 0.5 * 0.4 * 0.4 * std::sin(kPi / 3.0);
    EXPECT_NEAR(into_bulb(Prism{60.0 * deg, 0.4 * m, 0.5 * m}, askew) / (2.0 * triangle + 0.6), 1.0,
                kMeanError);
    // An icosahedron's edge is 1.05146 of its circumradius; 20 triangles of sqrt(3)/4 edge².
    EXPECT_NEAR(into_bulb(icosahedron(), askew * scaling({0.3, 0.3, 0.3})) /
                    (5.0 * std::sqrt(3.0) * std::pow(0.3 * 1.0514622242382672, 2)),
                1.0, kMeanError);
    // Spheroid of half axes 0.2, 0.2, 0.4: 2π a² (1 + c/(a e) asin e), e² = 1 − a²/c².
    const double e = std::sqrt(0.75);
    EXPECT_NEAR(into_bulb(Sphere{0.2 * m}, askew * scaling({1, 2, 1})) /
                    (2.0 * kPi * 0.04 * (1.0 + 2.0 / e * std::asin(e))),
                1.0, kMeanError);

    Scene profile = make_empty_scene();
    add_bulb(profile);
    profile.lights.push_back(ProfileLight{{}, {}, test_web(), make_constant(2.0)});
    EXPECT_NEAR(flux(profile) / (2.0 * test_web()->flux_lm()), 1.0, kMeanError);
}

}  // namespace
}  // namespace dewbow::caustics
