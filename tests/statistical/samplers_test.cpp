// SPDX-License-Identifier: Apache-2.0

// Samplers draw what their densities say: χ² on the sphere of directions, and the density that a
// sample brings equals the density of its direction.

#include <gtest/gtest.h>

#include "chi_square.h"
#include "dewbow/render/environment.h"
#include "dewbow/render/light_set.h"
#include "dewbow/render/microfacet.h"

namespace dewbow {
namespace {

using namespace kit;

TEST(Samplers, VisibleNormals) {
    for (const double alpha : {0.3, 0.7, 1.0})
        for (const double cosine : {1.0, 0.6, 0.1}) {
            SCOPED_TRACE(::testing::Message() << alpha << " " << cosine);
            const Vec3 w = tilted(cosine);
            expect_good(
                [&](const SampleKey& key) {
                    return sample_visible_normal(w, alpha, test_numbers(key, 0));
                },
                [&](Vec3 d) { return d.z > 0.0 ? ggx_visible_pdf(w, d, alpha) : 0.0; }, true);
        }
}

/// Planted: 2 % more roughness in the density than in the samples.
TEST(Samplers, SeeAPlantedError) {
    const Vec3 w = tilted(0.6);
    const ChiSquare found = chi_square(
        [&](const SampleKey& key) { return sample_visible_normal(w, 0.5, test_numbers(key, 0)); },
        [&](Vec3 d) { return d.z > 0.0 ? ggx_visible_pdf(w, d, 0.51) : 0.0; });
    EXPECT_GT(found.score, kChiLimit);
}

// ---- lights ------------------------------------------------------------------------------------

Scene lights_scene() {
    Scene scene = empty_scene();
    const Material two{"two", Black{}, make_constant(1.0), true};
    add(scene, Sphere{0.5 * m}, lamp(1.0), translation({2, 1, 0}));
    add(scene, Sphere{0.5 * m}, lamp(1.0), translation({-2, 0, 1}) * scaling({1, 0.4, 1.5}));
    add(scene, Disc{0.7 * m}, two, translation({0, 2, 0}) * rotation({1, 0, 0}, 60.0 * deg));
    add(scene, Rectangle{1.0 * m, 0.5 * m}, lamp(1.0), translation({0, 0, -2}));
    add(scene, Box{0.6 * m, 0.5 * m, 0.4 * m}, lamp(1.0), translation({0, -2, 0.5}));
    add(scene, sphere_mesh(0.4, 1), lamp(1.0), translation({0.3, 0.5, 2}));
    scene.lights.push_back(DistantLight{{normalised({1, 1, 1})}, 8.0 * deg, make_constant(0.2)});
    auto image = std::make_shared<ImageEnvironment>();
    image->width = 8, image->height = 4;
    for (int i = 0; i < 32; ++i) image->pixels.push_back({{0.1 * i, 0.5, 1.0}});
    image->world_from_object = Transform<World, Object>(rotation({0, 1, 0}, 70.0 * deg));
    scene.lights.push_back(std::shared_ptr<const ImageEnvironment>(image));
    return scene;
}

/// A sampled direction has, looked at from the other end, the density that it was drawn with.
TEST(Samplers, LightsKnowTheDensityOfTheirSamples) {
    constexpr double kSame = 1e-6;  // directions at the rim of a light, cosines near 0
    const Scene scene = lights_scene();
    const LightSet lights(scene);
    std::vector<int> seen_shapes(scene.shapes.size(), 0), seen_far(scene.lights.size(), 0);
    const Receiver receiver{{0.1, 0.2, 0.3}};
    for (std::size_t i = 0; i < 100000; ++i) {
        const SampleKey key = independent_key(34, i);
        const auto s = lights.sample(receiver, test_numbers(key, 0)[0], test_numbers(key, 1));
        if (!s) continue;
        if (std::isinf(s->distance)) {
            ++seen_far[std::size_t(s->index)];
            ASSERT_NEAR(lights.pdf_of_infinite(receiver, s->index, s->direction) / s->pdf, 1.0,
                        kSame);
            continue;
        }
        ++seen_shapes[std::size_t(s->index)];
        // That light alone, so that nothing stands before it.
        static std::vector<std::unique_ptr<Scene>> alone;
        static std::vector<std::unique_ptr<Accelerator>> trees;
        if (alone.empty())
            for (const Shape& shape : scene.shapes) {
                alone.push_back(std::make_unique<Scene>(empty_scene()));
                alone.back()->materials = scene.materials;
                alone.back()->shapes = {shape};
                trees.push_back(
                    std::make_unique<Accelerator>(*alone.back(), std::vector<bool>{false}));
            }
        Hit hit = trees[std::size_t(s->index)]->intersect({receiver.position, s->direction, {}});
        if (!hit || std::abs(hit.t / s->distance - 1.0) > 1e-6)
            continue;  // the far side, or the rim
        hit.shape = s->index;
        ASSERT_NEAR(lights.pdf_of_hit(receiver, s->direction, hit) / s->pdf, 1.0, 1e-4)
            << "light " << s->index;
    }
    for (const int count : seen_shapes) EXPECT_GT(count, 200);
    for (const int count : seen_far) EXPECT_GT(count, 200);
}

/// A bright pixel at a pole, at the seam, and in their corner.
TEST(Samplers, EnvironmentPictureAtPolesAndSeam) {
    for (const int bright : {3, 44, 0, 24, 47}) {
        SCOPED_TRACE(bright);
        auto image = std::make_shared<ImageEnvironment>();
        image->width = 8, image->height = 6;
        for (int i = 0; i < 48; ++i)
            image->pixels.push_back({{0.2, 0.2, i == bright ? 20.0 : 0.2}});
        const EnvironmentMap map(image);
        const ChiSquare found = chi_square(
            [&](const SampleKey& key) -> std::optional<Vec3> {
                const EnvironmentMap::Sample s = map.sample(test_numbers(key, 0));
                EXPECT_NEAR(map.pdf(s.direction) / s.pdf, 1.0, 1e-6);
                return s.direction;
            },
            [&](Vec3 d) { return map.pdf(d); }, 200000, 1e-2);
        EXPECT_NEAR(found.integral, 1.0, 2e-2);
        EXPECT_LT(found.score, kChiLimit);
        EXPECT_FALSE(found.in_void);
    }
}

TEST(Samplers, EnvironmentPicture) {
    auto image = std::make_shared<ImageEnvironment>();
    image->width = 8, image->height = 6;
    for (int i = 0; i < 48; ++i)
        image->pixels.push_back({{0.1 * (i % 8), 0.5, i == 21 ? 9.0 : 0.0}});
    image->world_from_object =
        Transform<World, Object>(rotation(normalised({1, 2, 0}), 50.0 * deg));
    const EnvironmentMap map(image);
    const auto sample = [&](const SampleKey& key) -> std::optional<Vec3> {
        const EnvironmentMap::Sample s = map.sample(test_numbers(key, 0));
        EXPECT_NEAR(map.pdf(s.direction) / s.pdf, 1.0, 1e-6);
        return s.direction;
    };
    const ChiSquare found = chi_square(
        sample, [&](Vec3 d) { return map.pdf(d); }, 200000);
    // The density jumps from pixel to pixel, askew to the cells: midpoints miss more of it.
    EXPECT_NEAR(found.integral, 1.0, 5e-3);
    EXPECT_LT(found.score, 4.0 * kChiLimit);
}

}  // namespace
}  // namespace dewbow
