// SPDX-License-Identifier: Apache-2.0
#include "forward_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/spectrum/rgb.h"
#include "emission.h"
#include "interfaces.h"

namespace dewbow::bench {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSize = 24;

DispersionPtr constant_index(double n) {
    return make_dispersion({"constant", {n}, IndexReference::vacuum});
}

PlainBody box(Vec3 centre, Vec3 half, double index) {
    PlainBody body;
    for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7})
        body.vertices.push_back(centre + Vec3{corner & 1 ? half.x : -half.x,
                                              corner & 2 ? half.y : -half.y,
                                              corner & 4 ? half.z : -half.z});
    body.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    body.index = constant_index(index);
    return body;
}

PlainReceiver square(Vec3 centre, Vec3 half_u, Vec3 half_v, double reflectance) {
    return {"wall", centre, normalised(cross(half_u, half_v)), half_u, half_v, reflectance};
}

/// A wall of 4 m × 4 m in z = 0, of reflectance 0.5, whose middle square metre is seen from z = 2.
PlainScene before_wall() {
    PlainScene scene;
    scene.camera = {{0, 0, 2}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, 0.25, kSize, kSize};
    scene.surrounding_index = constant_index(1.0);
    scene.receivers = {square({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 0.5)};
    scene.film_from_xyz = 1.0;
    return scene;
}

/// A spot, 3 m from the wall, whose light's colour is 1.
PlainSpot spot_towards(Vec3 position, Vec3 direction, double half_angle_rad) {
    PlainSpot spot{position, normalised(direction), half_angle_rad, make_constant(1.0), {}};
    spot.colour = rgb_from_xyz<LinearSrgb>(xyz_from_spectrum(*spot.intensity));
    return spot;
}

double mean_y(const Picture& picture) {
    double sum = 0.0;
    for (const auto& pixel : picture.pixels) sum += xyz_from_rgb(pixel)[1];
    return sum / double(picture.pixels.size());
}

double y_of(const PlainSpot& spot) { return xyz_from_rgb(spot.colour)[1]; }

/// Errors of sums over even points are far below their number's inverse root: no chance is
/// involved but the choice at each boundary.
constexpr int kSamples = 1024;
constexpr double kEven = 1e-3;

TEST(DirectPicture, LightOfASpotFallsOffByTheLaw) {
    PlainScene scene = before_wall();
    scene.spots = {spot_towards({0, 0, 3}, {0, 0, -1}, 0.6)};
    const SeenPicture seen = direct_picture(scene, kSamples, 1);
    // ∫ cos³ over the square metre, of I ρ / (π 9).
    double integral = 0.0;
    constexpr int kSteps = 200;
    for (int i = 0; i < kSteps; ++i)
        for (int k = 0; k < kSteps; ++k) {
            const double x = (i + 0.5) / kSteps - 0.5, y = (k + 0.5) / kSteps - 0.5;
            integral += std::pow(9.0 / (9.0 + x * x + y * y), 1.5) / (kSteps * kSteps);
        }
    EXPECT_NEAR(mean_y(seen.picture) / (y_of(scene.spots[0]) * 0.5 / (kPi * 9.0) * integral), 1.0,
                kEven);
    for (const bool receiver : seen.receivers) EXPECT_TRUE(receiver);
}

TEST(ForwardPicture, APlateLetsItsSeriesOfReflectionsThrough) {
    PlainScene scene = before_wall();
    // Light of 1.1° meets the plate all but straight.
    scene.spots = {spot_towards({0, 0, 5}, {0, 0, -1}, 0.02)};
    scene.bodies = {box({0, 0, 3}, {0.5, 0.5, 0.05}, 1.5)};
    const double through = 2.0 * 1.5 / (1.5 * 1.5 + 1.0);  // (1 − R) / (1 + R)
    const double flux = y_of(scene.spots[0]) * 2.0 * kPi * (1.0 - std::cos(0.02));
    // What the wall throws back comes again from the plate, in part.
    constexpr double kChance = 4e-3;
    EXPECT_NEAR(
        mean_y(forward_picture(scene, kSamples * kSize * kSize, 1)) / (through * flux * 0.5 / kPi),
        1.0, kChance);
}

TEST(ForwardPicture, APrismDeviatesByItsLaw) {
    PlainScene scene = before_wall();
    // A prism of 10°, its upper face square to the light, index 1.5: sin i₂ = 1.5 sin 10°.
    PlainBody body = box({0, 0, 2.5}, {0.1, 0.1, 0.01}, 1.5);
    for (Vec3& v : body.vertices)
        if (v.z < 2.5) v.z -= std::tan(10.0 * kPi / 180.0) * (v.x + 0.1);
    scene.bodies = {body};
    scene.spots = {spot_towards({0, 0, 3}, {0, 0, -1}, 0.002)};
    const Picture picture = forward_picture(scene, kSamples * kSize * kSize, 1);
    double light = 0.0, column = 0.0;
    for (int i = 0; i < kSize * kSize; ++i) {
        const double y = xyz_from_rgb(picture.pixels[std::size_t(i)])[1];
        light += y;
        column += y * (0.5 + i % kSize);
    }
    const double angle = std::asin(1.5 * std::sin(10.0 * kPi / 180.0)) - 10.0 * kPi / 180.0;
    const double height = 2.49 - 0.1 * std::tan(10.0 * kPi / 180.0);
    // The thick end of the wedge is at x > 0: light bends towards it.
    const double expected = kSize * (0.5 + height * std::tan(angle));
    /// Light lies in a column or two: its middle is known to some hundredths of that.
    constexpr double kColumn = 0.25;
    EXPECT_NEAR(column / light, expected, kColumn);
}

/// A body of index 1 bends nothing: what goes through it is counted from the lamp, what passes by
/// from the eye, and both are the picture without it. So is what goes on from wall to wall.
class ClearBody : public testing::TestWithParam<int> {};

TEST_P(ClearBody, ChangesNothing) {
    PlainScene scene = before_wall();
    scene.receivers.push_back(square({0.6, 0, 1}, {0, 2, 0}, {0, 0, 1}, 0.8));
    PlainLamp lamp;
    lamp.shape = GetParam() == 0 ? LampShape::disc : LampShape::rectangle;
    lamp.centre = {-0.5, 0.3, 2.5};
    lamp.normal = normalised(Vec3{0.5, -0.3, -2.5});
    const Tangents frame = tangents_of(lamp.normal);
    lamp.half_u = frame.t * 0.2;
    lamp.half_v = frame.b * 0.2;
    lamp.radiance = make_constant(1.0);
    lamp.colour = rgb_from_xyz<LinearSrgb>(xyz_from_spectrum(*lamp.radiance));
    if (GetParam() < 2) scene.lamps = {lamp};
    if (GetParam() == 2) {
        PlainSun sun{lamp.normal, 0.1, make_constant(1.0), lamp.colour};
        scene.suns = {sun};
    }
    scene.bodies = {box({-0.42, 0.25, 2.1}, {0.15, 0.15, 0.1}, 1.0)};
    const Picture with = lit_picture(scene, 512, 1);
    PlainBody ball;
    ball.sphere = PlainSphere{{-0.42, 0.25, 2.1}, 0.15};
    ball.index = constant_index(1.0);
    scene.bodies = {ball};
    const Picture with_ball = lit_picture(scene, 512, 2);
    scene.bodies = {box({50, 0, 50}, {1e-3, 1e-3, 1e-3}, 1.0)};
    const Picture without = camera_picture(scene, 512, 3).picture;
    // Four standard deviations of the ratio, from twelve seeds; false alarms: 6 in 10⁵ for other
    // seeds. Paths that end at the first wall lose 5 to 8 % of the light of lamps.
    constexpr double kMean = 0.011;
    EXPECT_NEAR(mean_y(with) / mean_y(without), 1.0, kMean);
    EXPECT_NEAR(mean_y(with_ball) / mean_y(without), 1.0, kMean);
}
INSTANTIATE_TEST_SUITE_P(Sources, ClearBody, testing::Values(0, 1, 2));

TEST(Interfaces, WaterInGlassHasTheRatioOfBoth) {
    PlainScene scene = before_wall();
    PlainBody water = box({0, 0, 1}, {0.1, 0.1, 0.1}, 1.33);
    water.name = "water";
    water.priority = 1;
    PlainBody glass = box({0, 0, 1}, {0.2, 0.2, 0.2}, 1.5);
    glass.name = "glass";
    scene.bodies = {glass, water};
    const auto interfaces = interfaces_of(scene);
    ASSERT_EQ(interfaces.size(), 2u);
    const Wavelength green = 550.0 * unit::nm;
    EXPECT_DOUBLE_EQ(relative_index(scene, interfaces[0], green), 1.5);
    EXPECT_DOUBLE_EQ(relative_index(scene, interfaces[1], green), 1.33 / 1.5);
    EXPECT_EQ(interfaces[1].surface.triangles.size(), 12u);
    // Of lower priority it is not there.
    scene.bodies[1].priority = -1;
    EXPECT_EQ(interfaces_of(scene).size(), 1u);
}

}  // namespace
}  // namespace dewbow::bench
