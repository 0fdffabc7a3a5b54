// SPDX-License-Identifier: Apache-2.0

// Bodies that stand on each other, sheets that are no bodies, and mixes: what scenes made by people
// have, held against the same scene written so that nothing touches.

#include <gtest/gtest.h>

#include "dewbow/base/error.h"
#include "scene_kit.h"

namespace dewbow::kit {
namespace {

constexpr int kRays = 4000;
/// The rays are the same with and without the gap, so only those whose place moves by the gap
/// differ.
constexpr double kGap = 1e-9, kSameAsWithGap = 1e-6;

/// Mean radiance over a fan of rays that come from above and go through a glass cube to the floor.
double through_cube(Geometry cube, Geometry floor, const Affine& floor_place, double gap) {
    Scene scene = furnace_scene();
    scene.render.max_depth = 64;  // some light is caught in the cube by total reflection
    add(scene, std::move(cube), dielectric(glass("schott/N-BK7")), translation({0, 0.5 + gap, 0}));
    add(scene, std::move(floor), diffuse(0.0), floor_place);
    const PreparedScene prepared(scene);
    double sum = 0.0;
    for (int i = 0; i < kRays; ++i) {
        const SampleKey key(1, std::uint32_t(i));
        const auto u = key.two(0, Purpose::test);
        const Vec3 origin{0.8 * u[0] - 0.4, 3.0, 0.8 * u[1] - 0.4};
        const Vec3 direction = normalised({u[1] - 0.5, -1.5, 0.7 * u[0] - 0.2});
        const WavelengthPacket packet = sample_wavelengths(WavelengthSampling::uniform, 1, u[0]);
        sum += trace_sample(prepared, {origin, direction, {}}, {}, packet, key).radiance[0];
    }
    return sum / kRays;
}

TEST(Contact, AFloorIsThereUnderABodyThatStandsOnIt) {
    const Affine flat = rotation({1, 0, 0}, -90.0 * deg);
    const Geometry floors[] = {Plane{}, Rectangle{10.0 * m, 10.0 * m},
                               Box{10.0 * m, 1.0 * m, 10.0 * m}, box_mesh({10, 1, 10})};
    const Affine places[] = {flat, flat, translation({0, -0.5, 0}), translation({0, -0.5, 0})};
    for (std::size_t floor = 0; floor < 4; ++floor) {
        for (const bool mesh : {false, true}) {
            const Geometry cube =
                mesh ? Geometry(box_mesh({1, 1, 1})) : Box{1.0 * m, 1.0 * m, 1.0 * m};
            const double apart = through_cube(cube, floors[floor], places[floor], kGap);
            const double touching = through_cube(cube, floors[floor], places[floor], 0.0);
            EXPECT_LT(apart, 0.5);  // the floor is black: what is left is reflected
            EXPECT_NEAR(touching, apart, kSameAsWithGap + 1.0 / kRays)
                << floor << (mesh ? " mesh" : " box");
        }
    }
}

/// Radiance of a white ball of reflectance ½ inside a glowing sphere of radius 2, written as
/// radius × scale.
double lit_inside(double radius, double scale) {
    Scene scene = empty_scene();
    add(scene, Sphere{radius * m}, lamp(1.0, true), scaling({scale, scale, scale}));
    add(scene, Sphere{0.3 * m}, diffuse(0.5), translation({0.9, 0, 0}));
    const PreparedScene prepared(scene);
    double sum = 0.0;
    for (int i = 0; i < kRays; ++i) {
        const SampleKey key(2, std::uint32_t(i));
        const WavelengthPacket packet = sample_wavelengths(WavelengthSampling::uniform, 1, 0.5);
        sum += trace_sample(prepared, {{0, 0, 0}, {1, 0, 0}, {}}, {}, packet, key).radiance[0];
    }
    return sum / kRays;
}

TEST(SphereLight, IsTheSameFromInsideHoweverItIsWritten) {
    // In a furnace of black walls that glow, the ball gives back ½. Standard error of the mean:
    // below 0.003 (measured spread 0.18 a ray); false alarm 1e-5 at 4.4 of them.
    constexpr double kTolerance = 0.0135;
    EXPECT_NEAR(lit_inside(2.0, 1.0), 0.5, kTolerance);
    EXPECT_NEAR(lit_inside(1.0, 2.0), 0.5, kTolerance);
    EXPECT_NEAR(lit_inside(4.0, 0.5), 0.5, kTolerance);
}

TEST(CameraMedia, AnOpenSheetOfGlassPutsNobodyInside) {
    for (const double side : {-90.0, 90.0}) {
        Scene scene = furnace_scene();
        add(scene, Rectangle{4.0 * m, 4.0 * m}, dielectric(glass("schott/N-BK7")),
            translation({0, 1, 0}) * rotation({1, 0, 0}, side * deg));
        add(scene, Sphere{0.5 * m}, dielectric(glass("fluid/water")), translation({3, 0, 0}));
        scene.camera.world_from_camera = Transform<World, Camera>(Affine{});
        EXPECT_EQ(PreparedScene(scene).camera_media, MediaStack{});
        scene.camera.world_from_camera = Transform<World, Camera>(translation({3, 0, 0}));
        EXPECT_NE(PreparedScene(scene).camera_media, MediaStack{});
    }
}

TEST(Depth, TheGreatestThatIsAllowedIsNoneAtAll) {
    Scene scene = furnace_scene();
    scene.render.max_depth = scene.render.roulette_depth = kMostDepth;
    add(scene, Sphere{0.5 * m}, dielectric(glass("schott/N-BK7")));
    EXPECT_NO_THROW(validate(scene));
    const PreparedScene prepared(scene);
    const WavelengthPacket packet = sample_wavelengths(WavelengthSampling::uniform, 8, 0.3);
    const PixelSample sample =
        trace_sample(prepared, {{0.1, 0.2, 3}, {0, 0, -1}, {}}, {}, packet, SampleKey(3, 0));
    for (int k = 0; k < 8; ++k) EXPECT_NEAR(sample.radiance[std::size_t(k)], 1.0, 1e-9);
    scene.render.max_depth = kMostDepth + 1;
    EXPECT_THROW(validate(scene), InputError);
}

/// Share of rays that get through `layers` thin boxes of half-black mix, all inside a stronger
/// body.
double through_layers(int layers) {
    Scene scene = furnace_scene();
    add(scene, Box{4.0 * m, 4.0 * m, 4.0 * m}, dielectric(plain(1.0 + 1e-9, nullptr, 5)));
    const int clear = scene.add(dielectric(plain(1.3, nullptr, 0)));
    const int black = scene.add({"black", Black{}, nullptr, false});
    for (int i = 0; i < layers; ++i)
        add(scene, Box{2.0 * m, 2.0 * m, 0.1 * m}, {"half", Mix{clear, black, 0.5}, nullptr, false},
            translation({0, 0, 0.3 * i}));
    const PreparedScene prepared(scene);
    double sum = 0.0;
    for (int i = 0; i < kRays; ++i) {
        const SampleKey key(4, std::uint32_t(i));
        const WavelengthPacket packet = sample_wavelengths(WavelengthSampling::uniform, 1, 0.5);
        sum += trace_sample(prepared, {{0.1, 0.2, 3}, {0, 0, -1}, {}}, {}, packet, key).radiance[0];
    }
    return sum / kRays;
}

TEST(Mix, ChoosesAnewAtEachSurface) {
    // Binomial: standard error at most 0.008; false alarm 1e-5 at 4.4 of them.
    constexpr double kTolerance = 0.035;
    EXPECT_NEAR(through_layers(1), 0.25, kTolerance);
    EXPECT_NEAR(through_layers(2), 0.0625, kTolerance);
}

TEST(Mix, RefusesPartsThatNoPathCouldHoldTogether) {
    Scene scene = furnace_scene();
    const int crown = scene.add(dielectric(glass("schott/N-BK7")));
    const int flint = scene.add(dielectric(glass("schott/SF66")));
    const int glowing = scene.add(lamp(1.0));
    add(scene, Sphere{1.0 * m}, {"two glasses", Mix{crown, flint, 0.5}, nullptr, false});
    EXPECT_THROW(validate(scene), InputError);
    scene.materials.back().surface = Mix{crown, glowing, 0.5};
    EXPECT_THROW(validate(scene), InputError);
    scene.materials.back().surface = Mix{crown, crown, 0.5};
    EXPECT_NO_THROW(validate(scene));
}

}  // namespace
}  // namespace dewbow::kit
