// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/haze/lit_part.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/base/random.h"
#include "dewbow/math/sampling.h"

namespace dewbow {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
constexpr int kRays = 2000;
constexpr double kLength = 6.0;

struct TestRay {
    Vec3 origin, direction, axis;
};
TestRay test_ray(int i) {
    const SampleKey key(stream_key(1, 0, 0), std::uint32_t(i));
    const auto a = key.two(0, Purpose::test), b = key.two(1, Purpose::test),
               c = key.two(2, Purpose::test);
    return {3.0 * sample_uniform_sphere<World>(a[0], a[1]).v,
            sample_uniform_sphere<World>(b[0], b[1]).v, sample_uniform_sphere<World>(c[0], c[1]).v};
}

/// Compares with asking at many points; how many rays have a part.
template <class Part, class Inside>
int expect_part(Part&& part_of, Inside&& inside) {
    int lit = 0;
    for (int i = 0; i < kRays; ++i) {
        const TestRay ray = test_ray(i);
        const RayInterval part = part_of(ray);
        lit += !part.empty();
        for (int step = 0; step < 60; ++step) {
            const double t = (step + 0.5) / 60.0 * kLength;
            const bool expected = inside(ray, ray.origin + ray.direction * t);
            EXPECT_EQ(!part.empty() && t >= part.begin && t <= part.end, expected)
                << "ray " << i << " at " << t;
        }
    }
    return lit;
}

TEST(LitPart, OfACone) {
    for (const double cosine : {0.0, 0.3, 0.9}) {
        const int lit = expect_part(
            [&](const TestRay& ray) {
                return part_in_cone(ray.origin, ray.direction, kLength, {0.3, 0.2, 0.1}, ray.axis,
                                    cosine);
            },
            [&](const TestRay& ray, Vec3 p) {
                const Vec3 from = p - Vec3{0.3, 0.2, 0.1};
                return dot(from, ray.axis) / length(from) >= cosine;
            });
        EXPECT_GT(lit, kRays / 50) << cosine;
    }
}

TEST(LitPart, OfACylinder) {
    const int lit = expect_part(
        [](const TestRay& ray) {
            return part_in_cylinder(ray.origin, ray.direction, kLength, {0.3, 0.2, 0.1}, ray.axis,
                                    0.5);
        },
        [](const TestRay& ray, Vec3 p) {
            const Vec3 from = p - Vec3{0.3, 0.2, 0.1};
            const double along = dot(from, ray.axis);
            return along > 0.0 && length(from - ray.axis * along) <= 0.5;
        });
    EXPECT_GT(lit, kRays / 50);
}

TEST(LitPart, OfABall) {
    const BoundingBall ball{{0.3, 0.2, 0.1}, 1.5};
    const int lit =
        expect_part([&](const TestRay& ray) { return ball.part(ray.origin, ray.direction); },
                    [&](const TestRay&, Vec3 p) { return ball.holds(p); });
    EXPECT_GT(lit, kRays / 50);
}

TEST(LitPart, GoesOnForEver) {
    const Vec3 z{0, 0, 1};
    const RayInterval along = part_in_cylinder({0.1, 0, -2}, z, kForever, {}, z, 0.5);
    EXPECT_NEAR(along.begin, 2.0, 1e-12);
    EXPECT_EQ(along.end, kForever);
    EXPECT_TRUE(part_in_cylinder({0.6, 0, -2}, z, kForever, {}, z, 0.5).empty());
    const RayInterval in_cone = part_in_cone({0, 0, 1}, z, kForever, {}, z, 0.9);
    EXPECT_EQ(in_cone.begin, 0.0);
    EXPECT_EQ(in_cone.end, kForever);
    const RayInterval leaves =
        part_in_cone({0, 0, 1}, Vec3{1, 0, 0}, kForever, {}, z, std::sqrt(0.5));
    EXPECT_NEAR(leaves.end, 1.0, 1e-12);
}

}  // namespace
}  // namespace dewbow
