// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/training.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dewbow/base/parallel.h"
#include "dewbow/render/caustics/emission_scenes.h"

namespace dewbow::caustics {
namespace {

using unit::m;

/// Leaves parallel loops as they were.
struct ThreadsGuard {
    ~ThreadsGuard() { set_thread_count(0); }
};

/// A round lamp above a plate of glass, and a second lamp of the same power beside it.
Scene lamps_above_plate() {
    Scene scene = make_empty_scene();
    add_shape(scene, Rectangle{1.0 * m, 1.0 * m}, rotation({1, 0, 0}, -90.0 * unit::deg),
              add_mirror(scene));
    const int lamp = scene.add({"lamp", Black{}, make_constant(1.0)});
    for (const double x : {0.0, 1.0})
        add_shape(scene, Disc{0.2 * m},
                  translation({x, 1, 0}) * rotation({1, 0, 0}, 90.0 * unit::deg), lamp);
    return scene;
}

/// Light of the first lamp that goes through a slit in the plate, 1 / 25 of it.
double through_slit(const EmittedRay& ray, const SampleKey&) {
    const Vec3 at = ray.ray.origin - ray.ray.direction * (ray.ray.origin.y / ray.ray.direction.y);
    const bool passes = ray.index == 0 && std::abs(at.x) < 0.02 && std::abs(at.z) < 0.5;
    return passes ? 1.0 / (ray.pdf * ray.pdf) : 0.0;
}

struct Trained {
    explicit Trained(const Scene& scene, double planned = 4e5)
        : prepared(scene), emission(prepared) {
        report = train(emission, 1, planned, through_slit);
    }
    PreparedScene prepared;
    AimedEmission emission;
    TrainingReport report;
};

/// Mean and relative variance of what paths bring through the slit.
struct Estimate {
    double mean = 0.0, variance = 0.0;
};
Estimate estimate(const AimedEmission& emission) {
    constexpr int kPaths = 200'000;
    Estimate result;
    double squares = 0.0;
    for (int i = 0; i < kPaths; ++i) {
        const SampleKey key(stream_key(77, std::uint32_t(i), 0), 0);  // independent of each other
        const std::optional<EmittedRay> ray = emission.sample(key);
        const double square = ray ? through_slit(*ray, key) : 0.0;
        result.mean += std::sqrt(square) / kPaths, squares += square / kPaths;
    }
    result.variance = squares / (result.mean * result.mean) - 1.0;
    return result;
}

TEST(Training, AimsThroughASlit) {
    const Scene scene = lamps_above_plate();
    const PreparedScene prepared(scene);
    const AimedEmission untrained(prepared);
    const Trained trained(scene);
    ASSERT_EQ(trained.report.size(), 4u);
    EXPECT_EQ(trained.report.front().paths, 4096);
    EXPECT_EQ(trained.report.back().paths, 32768);
    // One lamp of two and a slit of 1/25: about a fiftieth arrives without learning. Of what is
    // learnt a tenth is uniform.
    EXPECT_LT(trained.report.front().share(), 0.04);
    EXPECT_GT(trained.report.back().share(), 0.5);

    const Estimate before = estimate(untrained), after = estimate(trained.emission);
    // Standard errors of 2·10⁵ paths whose relative variances are some 50 and 1: 1.6 % and 0.2 %.
    EXPECT_NEAR(after.mean / before.mean, 1.0, 5.0 * 0.016);
    EXPECT_LT(after.variance, before.variance / 20.0);
}

TEST(Training, HasTheSameBitsOnAnyNumberOfThreads) {
    const ThreadsGuard guard;
    const Scene scene = lamps_above_plate();
    set_thread_count(1);
    const Trained one(scene);
    set_thread_count(2);
    const Trained two(scene);
    for (std::size_t k = 0; k < one.report.size(); ++k)
        EXPECT_EQ(one.report[k].arrived, two.report[k].arrived);
    for (int i = 0; i < 10'000; ++i) {
        const SampleKey key(stream_key(3, 0, 0), std::uint32_t(i));
        const auto a = one.emission.sample(key), b = two.emission.sample(key);
        ASSERT_EQ(a.has_value(), b.has_value());
        if (!a) continue;
        ASSERT_EQ(a->pdf, b->pdf);
        ASSERT_EQ(a->ray.origin, b->ray.origin);
        ASSERT_EQ(a->ray.direction, b->ray.direction);
    }
}

// What reaches the picture by one path in ten thousand is found by a tenth of the paths as if
// nothing had been learnt: no light is lost.
TEST(Training, StarvesNothing) {
    const Scene scene = lamps_above_plate();
    const PreparedScene prepared(scene);
    const AimedEmission untrained(prepared);
    const Trained trained(scene);
    for (int i = 0; i < 10'000; ++i) {
        const SampleKey key(stream_key(4, 0, 0), std::uint32_t(i));
        const AimedEmission::Aim aim = trained.emission.aim(AimedEmission::numbers(key));
        ASSERT_GE(aim.density, kUniformShare * (1.0 - 1e-12));
    }
}

TEST(Training, TakesAQuarterOfAShortRenderAndASixteenthOfALongOne) {
    const Scene scene = lamps_above_plate();
    const auto paths = [&](double planned) {
        std::int64_t sum = 0;
        for (const TrainingPass& pass : Trained(scene, planned).report) sum += pass.paths;
        return double(sum);
    };
    EXPECT_EQ(paths(1000.0), 0.0);
    constexpr double kRounding = 15.0;  // 1 + 2 + 4 + 8
    for (const double planned : {1e4, 65'536.0, 2e5})
        EXPECT_NEAR(paths(planned), planned / 4.0, kRounding);
    EXPECT_EQ(paths(5e5), 61'440.0);
    EXPECT_NEAR(paths(2e6), 2e6 / 16.0, kRounding);
    EXPECT_EQ(paths(1e12), 245'760.0);
}

TEST(Training, LearnsNothingWhereNothingArrives) {
    const Scene scene = lamps_above_plate();
    const PreparedScene prepared(scene);
    AimedEmission emission(prepared);
    const auto report =
        train(emission, 1, 4e5, [](const EmittedRay&, const SampleKey&) { return 0.0; });
    EXPECT_EQ(report.back().arrived, 0);
    EXPECT_EQ(emission.aim({0.5, 0.1, 0.2, 0.3, 0.4}).density, 1.0);
}

}  // namespace
}  // namespace dewbow::caustics
