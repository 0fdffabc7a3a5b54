// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/media.h"

#include <gtest/gtest.h>

#include "dewbow/render/accelerator.h"

namespace dewbow {
namespace {

using unit::m;

MediumPtr medium(double n, int priority, SpectrumPtr absorption = nullptr) {
    return std::make_shared<Medium>(Medium{
        "", make_dispersion({"constant", {n}, IndexReference::vacuum}), absorption, priority});
}

void add_sphere(Scene& scene, double radius, const MediumPtr& interior, Vec3 at = {}) {
    const int id = scene.add({"", Dielectric{interior, 0.0, nullptr}, nullptr});
    scene.shapes.push_back({"", Sphere{radius * m}, Transform<World, Object>(translation(at)), id});
}

TEST(MediaStack, TheStrongestIsTheInterior) {
    MediaStack stack;
    EXPECT_EQ(stack.interior(), 0);
    stack = stack.entered(3).entered(7).entered(5);
    EXPECT_EQ(stack.interior(), 7);
    EXPECT_EQ(stack.left(7).interior(), 5);
    EXPECT_EQ(stack.left(5).interior(), 7);
    EXPECT_EQ(stack.left(4), stack) << "not there";
    EXPECT_TRUE(stack.holds(3));
    EXPECT_FALSE(stack.holds(4));
    EXPECT_EQ(stack.left(3).left(5).left(7), MediaStack{});
}

TEST(MediaStack, TheOrderOfEnteringDoesNotMatter) {
    EXPECT_EQ(MediaStack{}.entered(1).entered(9).entered(4),
              MediaStack{}.entered(9).entered(4).entered(1));
}

TEST(MediaStack, TheSameMediumTwiceIsLeftTwice) {
    const MediaStack twice = MediaStack{}.entered(2).entered(2);
    EXPECT_EQ(twice.left(2).interior(), 2);
    EXPECT_EQ(twice.left(2).left(2), MediaStack{});
}

TEST(MediaStack, OfNineTheWeakestIsDropped) {
    MediaStack stack;
    for (int id = 1; id <= 8; ++id) stack = stack.entered(id);
    stack = stack.entered(9);
    EXPECT_EQ(stack.interior(), 9);
    EXPECT_FALSE(stack.holds(1));
    EXPECT_TRUE(stack.holds(2));
}

TEST(MediaTable, NumbersByPriority) {
    Scene scene = make_empty_scene();
    const MediumPtr strong = medium(1.5, 5), weak = medium(1.3, -2), middle = medium(1.4, 0);
    add_sphere(scene, 1.0, strong);
    add_sphere(scene, 1.0, weak);
    scene.add({"paper", Diffuse{make_constant(0.5)}, nullptr});
    add_sphere(scene, 1.0, middle);
    const MediaTable table(scene);
    EXPECT_EQ(table.size(), 4);
    EXPECT_EQ(table.interior_of(0), 3);
    EXPECT_EQ(table.interior_of(1), 1);
    EXPECT_EQ(table.interior_of(2), -1);
    EXPECT_EQ(table.interior_of(3), 2);
    EXPECT_EQ(&table.medium(3), strong.get());
    EXPECT_EQ(&table.medium(0), scene.surroundings.get());
}

TEST(PacketMedia, AreThoseOfTheirPacket) {
    Scene scene = make_empty_scene();
    const auto flint = std::make_shared<Medium>(
        Medium{"", make_dispersion({"cauchy", {1.6, 0.01}, IndexReference::vacuum}),
               make_constant(3.0), 0});
    add_sphere(scene, 1.0, flint);
    const MediaTable table(scene);
    PacketMedia media(table);
    for (const double u : {0.1, 0.7}) {
        const WavelengthPacket packet = sample_wavelengths(WavelengthSampling::visual, 8, u);
        media.begin(packet);
        for (std::size_t k = 0; k < 8; ++k) {
            EXPECT_EQ(media.index(1)[k], (*flint->index)(packet.lambda_nm[k] * unit::nm).value);
            EXPECT_EQ((*media.extinction(1))[k], 3.0);
        }
        EXPECT_EQ(media.extinction(0), nullptr);
        EXPECT_EQ(media.scattering(1), nullptr);
    }
}

TEST(PacketMedia, ExtinctionIsAbsorptionAndScattering) {
    Scene scene = make_empty_scene();
    Medium haze = *scene.surroundings;
    haze.scattering = make_tabulated({400, 700}, {4.0, 1.0}, OutsideTable::hold);
    haze.phase = henyey_greenstein(0.0);
    scene.surroundings = std::make_shared<Medium>(haze);
    haze.absorption = make_constant(0.5);
    add_sphere(scene, 1.0, std::make_shared<Medium>(haze));
    const MediaTable table(scene);
    PacketMedia media(table);
    const WavelengthPacket packet = sample_wavelengths(WavelengthSampling::visual, 8, 0.3);
    media.begin(packet);
    for (std::size_t k = 0; k < 8; ++k) {
        const double expected = (*haze.scattering)(packet.lambda_nm[k] * unit::nm);
        for (const int id : {0, 1}) EXPECT_EQ((*media.scattering(id))[k], expected);
        EXPECT_EQ((*media.extinction(0))[k], expected);
        EXPECT_EQ((*media.extinction(1))[k], expected + 0.5);
    }
}

TEST(MediaAt, CountsTheBodiesAroundAPoint) {
    Scene scene = make_empty_scene();
    add_sphere(scene, 2.0, medium(1.3, 0));
    add_sphere(scene, 1.0, medium(1.5, 1), {0.5, 0, 0});
    const MediaTable table(scene);
    const Accelerator accelerator(scene, see_through_shapes(scene));
    const auto interior = [&](Vec3 p) { return media_at(p, scene, table, accelerator).interior(); };
    EXPECT_EQ(interior({3, 0, 0}), 0);
    EXPECT_EQ(interior({-1.5, 0, 0}), 1);
    EXPECT_EQ(interior({0.5, 0, 0}), 2);
    EXPECT_EQ(media_at({0.5, 0, 0}, scene, table, accelerator), MediaStack{}.entered(1).entered(2));
}

/// A body like air is seen through, but not where it could lie in glass, and not if it does
/// anything.
TEST(SeeThrough, OnlyWhatIsNotThere) {
    Scene scene = make_empty_scene();
    const auto like_air = [](SpectrumPtr absorption = nullptr) {
        return std::make_shared<Medium>(Medium{"", air(), absorption, 0});
    };
    add_sphere(scene, 1.0, like_air());
    add_sphere(scene, 1.0, like_air(make_constant(1.0)), {10, 0, 0});
    add_sphere(scene, 1.0, medium(1.5, 0), {20, 0, 0});
    add_sphere(scene, 0.5, like_air(), {20, 0, 0});
    EXPECT_EQ(see_through_shapes(scene), (std::vector<bool>{true, false, false, false}));
    scene.surroundings = like_air(make_constant(1.0));
    EXPECT_EQ(see_through_shapes(scene), (std::vector<bool>{false, false, false, false}));
    Medium haze{"", air(), nullptr};
    haze.scattering = make_constant(1.0);
    haze.phase = henyey_greenstein(0.0);
    scene.surroundings = std::make_shared<Medium>(haze);
    EXPECT_FALSE(see_through_shapes(scene)[0]) << "clear air in haze";
}

}  // namespace
}  // namespace dewbow
