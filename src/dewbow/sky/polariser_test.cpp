// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/polariser.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/rainbow/stokes.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr Intensities kBow{0.962, 0.038};

double through(const Polariser& polariser, Vec3 view, Vec3 to_sun) {
    const double share = polariser.perpendicular_share(view, to_sun);
    return kPolariserShare * (share * kBow.perpendicular + (1.0 - share) * kBow.parallel);
}

Transform<World, Camera> camera_to(Vec3 target) {
    return Transform<World, Camera>(looking_at({}, target, {0.0, 1.0, 0.0}));
}

// Against the Stokes vector in the middle of the picture, where the picture's vertical is the
// camera's +y, from all sides and at all angles.
TEST(Polariser, IsThatOfStokesInTheMiddleOfThePicture) {
    for (const Vec3 to_sun : {normalised({0.3, 0.2, 1.0}), normalised({-1.0, 0.4, 0.1})})
        for (const Vec3 target : {Vec3{0.5, 0.6, -1.0}, Vec3{-1.0, 0.1, -0.2}, Vec3{1, -1, 1}})
            for (double degrees = -170.0; degrees < 180.0; degrees += 35.0) {
                const Vec3 view = normalised(target);
                const Stokes light = stokes_of(kBow, tangent_of_bow({view}, {to_sun}));
                const double expected = through_polariser(light, degrees * deg);
                for (const bool around : {false, true})
                    EXPECT_NEAR(
                        through(Polariser(degrees * deg, camera_to(target), around), view, to_sun),
                        expected, 1e-12)
                        << degrees;
            }
}

// A panorama's polariser turns with the line of sight: everywhere it is that of a camera that looks
// there.
TEST(Polariser, OfAPanoramaTurnsWithTheSight) {
    const Polariser around(25.0 * deg, camera_to({0.0, 0.0, -1.0}), true);
    const Vec3 to_sun = normalised({0.3, 0.2, 1.0});
    for (const Vec3 target : {Vec3{0.5, 0.6, -1.0}, Vec3{-1.0, 0.1, -0.2}, Vec3{1.0, -1.0, 1.0}})
        EXPECT_NEAR(
            through(around, normalised(target), to_sun),
            through(Polariser(25.0 * deg, camera_to(target), false), normalised(target), to_sun),
            1e-12);
}

// Two that are crossed share all light between them, wherever one looks along the axis of the
// camera; aslant, a flat sheet's axes are no longer at right angles.
TEST(Polariser, CrossedOnesShareTheLight) {
    const Vec3 to_sun = normalised({0.3, 0.2, 1.0}), view = normalised({0.1, 0.7, -1.0});
    const Polariser one(10.0 * deg, camera_to(view), false),
        other(100.0 * deg, camera_to(view), false);
    EXPECT_NEAR(through(one, view, to_sun) + through(other, view, to_sun), kBow.unpolarised(),
                1e-12);
}

TEST(Polariser, WithoutAPlaneHalfGoesThrough) {
    const Vec3 view = normalised({0.1, 0.7, -1.0});
    EXPECT_EQ(Polariser(10.0 * deg, camera_to(view), false).perpendicular_share(view, -view), 0.5);
}

}  // namespace
}  // namespace dewbow
