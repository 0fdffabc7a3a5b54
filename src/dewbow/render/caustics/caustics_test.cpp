// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/caustics.h"

#include <gtest/gtest.h>

#include "dewbow/render/caustics/emission_scenes.h"

namespace dewbow::caustics {
namespace {

/// Light paths that aiming learns from, for 32 × 32 pixels.
std::int64_t learnt_from(int samples_per_pixel) {
    Scene scene = make_empty_scene();
    scene.film.width = scene.film.height = 32;
    scene.render.samples_per_pixel = samples_per_pixel;
    add_shape(scene, Sphere{1.0 * unit::m}, {}, add_mirror(scene));
    scene.lights.push_back(PointLight{{{0, 3, 0}}, make_constant(1.0)});
    const auto report = make_caustics_estimator(scene)->light_path_report();
    return report ? std::int64_t(report->traced) : 0;
}

TEST(Caustics, LearnAsForTheUsualSamplesWhereTimeOrNoiseEndsTheRender) {
    constexpr double kRounding = 15.0;  // 1 + 2 + 4 + 8
    EXPECT_NEAR(double(learnt_from(64)), 32.0 * 32.0 * 64.0 / 4.0, kRounding);
    EXPECT_NEAR(double(learnt_from(128)), 32.0 * 32.0 * 128.0 / 4.0, kRounding);
    EXPECT_EQ(learnt_from(kMostSamples), learnt_from(64));
}

}  // namespace
}  // namespace dewbow::caustics
