// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/estimator_choice.h"

#include <gtest/gtest.h>

#include "dewbow/render/light_share.h"

namespace dewbow {
namespace {

// A white wall below a pane without reflection, the lamp above it: all its light comes through the
// pane, which stops shadow rays, and is what it would be without.

constexpr double kWall_m = -2.0, kLamp_m[] = {2.0, -1.0};  // z; y and z
constexpr double kHalfAngle_deg = 15.0;

void add(Scene& scene, Geometry geometry, const Affine& world, int material) {
    scene.shapes.push_back({"", std::move(geometry), Transform<World, Object>(world), material});
}

Material white() { return {"white", Diffuse{make_constant(0.8)}, {}}; }

DispersionPtr no_glass() { return make_dispersion({"constant", {1.0}, IndexReference::air}); }

void add_lamp(Scene& scene, double y, double intensity) {
    scene.lights.push_back(PointLight{{{0.0, y, kLamp_m[1]}}, make_constant(intensity)});
}

Scene wall_below_pane() {
    using unit::m;
    Scene scene = make_empty_scene();
    scene.film.width = 64, scene.film.height = 48;  // in 32 × 24 parts
    scene.render.samples_per_pixel = 16;
    scene.camera.projection = Perspective{2.0 * kHalfAngle_deg * unit::deg};
    scene.camera.world_from_camera = Transform<World, Camera>(translation({0, 0, 1}));
    add(scene, Rectangle{6.0 * m, 6.0 * m}, translation({0, 0, kWall_m}), scene.add(white()));
    add(scene, Rectangle{20.0 * m, 20.0 * m},
        translation({0, 1, 0}) * rotation({1, 0, 0}, 90.0 * unit::deg),
        scene.add({"pane", ThinDielectric{no_glass()}, {}}));
    add_lamp(scene, kLamp_m[0], 1.0);
    return scene;
}

/// Irradiance at a place of the wall, in any unit.
double irradiance(double x, double y, double lamp_y) {
    const double across = kLamp_m[1] - kWall_m;
    const double squared = x * x + (y - lamp_y) * (y - lamp_y) + across * across;
    return across / std::pow(squared, 1.5);
}

double share_of(const Scene& scene) {
    CausticsEstimator estimator(scene);
    estimator.aim();  // the pane is much larger than what is seen: geometry alone aims badly
    return light_share(estimator, scene);
}

/// What the pilot makes of light that is there for sure: 1 % is added to each part.
constexpr double kFloor = 0.01;

TEST(LightShare, OfLightThatOnlyLightPathsFindIsAll) {
    // Parts differ by a factor two, so that what is added to them matters differently.
    constexpr double kUneven = 0.004;
    EXPECT_NEAR(share_of(wall_below_pane()), 1.0 - kFloor, kUneven);
}

TEST(LightShare, OfAPictureThatIsHalfBlackIsAHalf) {
    Scene scene = wall_below_pane();
    add(scene, Rectangle{3.0 * unit::m, 6.0 * unit::m}, translation({1.5, 0, kWall_m + 1e-3}),
        scene.add({"black", Black{}, {}}));
    // The filter takes light over the edge, into one more column of 32.
    constexpr double kColumn = 1.0 / 32.0, kUneven = 0.004;
    EXPECT_NEAR(share_of(scene), 0.5 + 0.5 * kColumn, 0.5 * kColumn + kUneven);
}

// A lamp below the pane brings known light beside it.
TEST(LightShare, IsThatOfTheClosedForm) {
    constexpr double kBelow = 3.0;
    Scene scene = wall_below_pane();
    add_lamp(scene, -kLamp_m[0], kBelow);
    const double half = std::tan(kHalfAngle_deg * std::numbers::pi / 180.0) * (1.0 - kWall_m);
    double share = 0.0;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 32; ++x) {
            const double at_x = half * (32.0 / 24.0) * (2.0 * (x + 0.5) / 32.0 - 1.0);
            const double at_y = half * (1.0 - 2.0 * (y + 0.5) / 24.0);
            const double light = irradiance(at_x, at_y, kLamp_m[0]);
            share += light / (light + kBelow * irradiance(at_x, at_y, -kLamp_m[0])) / (32 * 24);
        }
    // Camera samples ask one of two lamps, four times: they differ, and the mean of quotients is
    // not the quotient of means.
    constexpr double kFewSamples = 0.06;
    EXPECT_NEAR(share_of(scene), share, kFewSamples);
    EXPECT_EQ(share_of(scene), share_of(scene));
}

TEST(EstimatorChoice, IsCausticsWhereLightComesThroughGlass) {
    const Scene scene = wall_below_pane();
    const EstimatorChoice choice = choose_estimator(scene);
    EXPECT_EQ(choice.row.name, "caustics");
    EXPECT_EQ(choice.estimator->light_paths(), 1.0);
}

TEST(EstimatorChoice, IsCausticsWhereHazeIsAllThatScatters) {
    Scene scene = wall_below_pane();
    scene.materials[0] = {"black", Black{}, {}};
    Medium haze = *scene.surroundings;
    haze.scattering = make_constant(0.1);
    haze.phase = henyey_greenstein(0.0);
    scene.surroundings = std::make_shared<Medium>(haze);
    EXPECT_EQ(choose_estimator(scene).row.name, "caustics");
}

void expect_path(const Scene& scene, const std::string& reason) {
    const EstimatorChoice choice = choose_estimator(scene);
    EXPECT_EQ(choice.row.name, "path");
    EXPECT_EQ(choice.estimator->light_paths(), 0.0);
    EXPECT_NE(choice.reason.find(reason), std::string::npos) << choice.reason;
}

TEST(EstimatorChoice, IsPathWhereNothingIsToBeDone) {
    Scene plain = wall_below_pane();
    plain.materials[1] = white();
    expect_path(plain, "nothing here bends or mirrors light");
    Scene dark = wall_below_pane();
    dark.lights.clear();
    expect_path(dark, "nothing here gives light");
    Scene clear = wall_below_pane();
    clear.materials[0] = {"black", Black{}, {}};
    expect_path(clear, "nothing here scatters light");
    Scene none = wall_below_pane();
    none.render.caustics.light_paths = 0.0;
    expect_path(none, "light_paths is 0");
}

TEST(EstimatorChoice, LooksIntoMixes) {
    Scene scene = wall_below_pane();
    const int pane = scene.add({"pane", ThinDielectric{no_glass()}, {}});
    const int black = scene.add({"black", Black{}, {}});
    scene.materials[1] = {"mixed pane", Mix{black, pane, 0.5}, {}};
    scene.materials[0] = {"mixed wall", Mix{scene.add(white()), black, 0.5}, {}};
    EXPECT_EQ(choose_estimator(scene).row.name, "caustics");
}

// A bead of glass far from what is seen throws next to nothing there.
TEST(EstimatorChoice, IsPathWhereLightPathsBringNextToNothing) {
    Scene scene = wall_below_pane();
    scene.shapes.pop_back();
    add(scene, Sphere{0.01 * unit::m}, translation({0, 4, 6}),
        scene.add(
            {"bead",
             Dielectric{std::make_shared<Medium>(Medium{
                 "", make_dispersion({"constant", {1.5}, IndexReference::vacuum}), nullptr, 0})},
             {}}));
    expect_path(scene, "what glass and mirrors throw is little");
}

}  // namespace
}  // namespace dewbow
