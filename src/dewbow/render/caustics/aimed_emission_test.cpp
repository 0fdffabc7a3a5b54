// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/aimed_emission.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/render/caustics/emission_scenes.h"

namespace dewbow::caustics {
namespace {

using unit::m;

/// Densities are found again from rays that were computed from numbers: as in emission_map_test.
constexpr double kRounding = 1e-6;

/// Lets the two halves of every coordinate differ by far.
LearntDensity make_uneven() {
    std::vector<LearntDensity::Box> boxes;
    std::uint64_t mass = 1;
    const auto grow = [&](const auto& self, int axis) -> void {
        const std::size_t here = boxes.size();
        boxes.emplace_back();
        if (axis == kAimDimensions) {
            boxes[here].mass = mass = mass * 7 % 101;
            return;
        }
        boxes[here].axis = axis, boxes[here].cut = 0.5;
        self(self, axis + 1);
        boxes[here].second = std::uint32_t(boxes.size());
        self(self, axis + 1);
    };
    grow(grow, 1);  // where lamps end and begin is not known here
    return LearntDensity(boxes);
}

SampleKey key(int i) { return {stream_key(5, 0, 0), std::uint32_t(i)}; }

double density_backwards(const AimedEmission& emission, const PreparedScene& prepared,
                         const EmittedRay& emitted) {
    const Ray& ray = emitted.ray;
    if (emitted.source == LightSample::Source::infinite)
        return emission.density_of_infinite(emitted.index, {ray.origin, -ray.direction, {}});
    // From a little before the lamp back to it.
    const Ray back{ray.origin + 1e-3 * ray.direction, -ray.direction, {}};
    const Hit hit = prepared.accelerator.intersect(back);
    return emission.density_of_hit(hit, ray.origin, back);
}

// Both sides of the weights see one density, whatever was learnt.
TEST(AimedEmission, CameraPathsFindTheDensityThatRaysStartWith) {
    for (const LitScene& lit : all_lamps()) {
        const PreparedScene prepared(lit.scene);
        AimedEmission emission(prepared);
        emission.learn(make_uneven());
        int found = 0, same = 0;
        for (int i = 0; i < 500; ++i) {
            const std::optional<EmittedRay> ray = emission.sample(key(i));
            if (!ray || ray->without_extent) continue;
            ++found;
            const double back = density_backwards(emission, prepared, *ray);
            same += std::abs(back / ray->pdf - 1.0) < kRounding;
        }
        // A number next to a cut may come back on its other side: rarely.
        EXPECT_GE(same, found - 1) << lit.name;
    }
}

/// Mean of 1/pdf over rays that pass a ball around the casters: m² sr (sr of points, m² of parallel
/// light) of those that can start.
double measure_of_rays(const AimedEmission& emission, int rays) {
    constexpr double kRadius = 5.0;
    const Vec3 centre{0, -3, 0};
    double sum = 0.0;
    for (int i = 0; i < rays; ++i) {
        const std::optional<EmittedRay> ray = emission.sample(key(i));
        if (ray && length(cross(centre - ray->ray.origin, ray->ray.direction)) < kRadius)
            sum += 1.0 / ray->pdf;
    }
    return sum / rays;
}

// How many rays there are does not depend on how they are sampled.
TEST(AimedEmission, TheMeasureOfRaysDoesNotDependOnWhatWasLearnt) {
    constexpr int kRays = 1 << 13;
    // 1/pdf is spread over a factor of ten or so by the uneven density: with independent numbers
    // the standard error is 2 %; five of them.
    constexpr double kError = 0.1;
    for (const LitScene& lit : all_lamps()) {
        const PreparedScene prepared(lit.scene);
        AimedEmission emission(prepared);
        const double even = measure_of_rays(emission, kRays);
        emission.learn(make_uneven());
        EXPECT_NEAR(measure_of_rays(emission, kRays) / even, 1.0, kError) << lit.name;
    }
}

/// `count` small lamps in a row above a ball of glass, the last one as bright as all others.
Scene row_of_lamps(int count) {
    Scene scene = make_empty_scene();
    add_shape(scene, Sphere{0.5 * m}, translation({0, -4, 0}), add_glass(scene));
    const int dim = scene.add({"dim", Black{}, make_constant(1.0)});
    const int bright = scene.add({"bright", Black{}, make_constant(double(count) - 1.0)});
    for (int i = 0; i < count; ++i)
        add_shape(scene, Disc{1e-3 * m},
                  translation({1e-4 * i, 0, 0}) * rotation({1, 0, 0}, 90.0 * unit::deg),
                  i + 1 < count ? dim : bright);
    return scene;
}

TEST(AimedEmission, ChoosesAmongThousandsByPower) {
    constexpr int kLamps = 3000, kRays = 40'000;
    const Scene scene = row_of_lamps(kLamps);
    const PreparedScene prepared(scene);
    const AimedEmission emission(prepared);
    ASSERT_FALSE(emission.empty());
    int bright = 0;
    std::vector<int> count(kLamps);
    for (int i = 0; i < kRays; ++i) {
        const std::optional<EmittedRay> ray = emission.sample(key(i));
        ASSERT_TRUE(ray);
        bright += ray->index == kLamps - 1;
        ++count[std::size_t(ray->index)];
    }
    // Half of the power; a tenth falls on all alike. Six standard deviations of a binomial.
    EXPECT_NEAR(bright, 0.45 * kRays, 6.0 * std::sqrt(0.25 * kRays));
    // Evenly spread numbers meet each of the others about seven times.
    EXPECT_GT(*std::min_element(count.begin(), count.end()), 2);
}

TEST(AimedEmission, IsEmptyWithoutCastersAndWithoutLamps) {
    Scene scene = row_of_lamps(1);
    scene.shapes.erase(scene.shapes.begin());
    EXPECT_TRUE(AimedEmission(PreparedScene(scene)).empty());
    Scene dark = make_empty_scene();
    add_shape(dark, Sphere{0.5 * m}, {}, add_glass(dark));
    EXPECT_TRUE(AimedEmission(PreparedScene(dark)).empty());
}

}  // namespace
}  // namespace dewbow::caustics
