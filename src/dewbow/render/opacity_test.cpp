// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/opacity.h"

#include <gtest/gtest.h>

#include "dewbow/base/random.h"
#include "dewbow/math/sampling.h"
#include "dewbow/render/accelerator.h"

namespace dewbow {
namespace {

using unit::m;

/// Standard deviations between a count and what is expected. Each test here makes at most 30 such
/// comparisons of seeds that do not change; one of them fails by chance, when the code changes,
/// with a probability of 30 × 5.7e-7 (two-sided normal).
constexpr double kSigmas = 5.0;
/// At this number of rays a share of 0.3 that is 0.31 in truth is found with a probability above
/// 0.999: 0.01 are 9.8 standard deviations.
constexpr int kRays = 200'000;
constexpr double kShare = 0.3;

/// The same opacity on all shapes below `count`.
class Even : public Opacity {
public:
    explicit Even(double share, int count = 1000) : share_(share), count_(count) {}
    bool tests(int shape) const override { return shape < count_; }
    double at(int, int, double, double) const override { return share_; }

private:
    double share_;
    int count_;
};

double sigmas_off(int count, double expected) {
    return (count - kRays * expected) / std::sqrt(kRays * expected * (1.0 - expected));
}

Scene scene_of(std::vector<std::pair<Geometry, Affine>> shapes) {
    Scene scene = make_empty_scene();
    scene.add({"black", Black{}});
    for (auto& [geometry, place] : shapes)
        scene.shapes.push_back({"", std::move(geometry), Transform<World, Object>(place), 0});
    return scene;
}

Geometry quad_mesh() {
    auto mesh = std::make_shared<Mesh>();
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        mesh->vertices.push_back({{double(x), double(y), 0.0}});
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    return std::shared_ptr<const Mesh>(mesh);
}

/// From z = 3 to points of the unit square in z = 0, and on.
Ray ray_down(std::uint32_t i) {
    const SampleKey key(stream_key(11, i, 0), 0);
    const auto a = key.two(0, Purpose::test), b = key.two(1, Purpose::test);
    const Vec3 origin{a[0] - 0.5, a[1] - 0.5, 3.0}, target{b[0] - 0.5, b[1] - 0.5, 0.0};
    return {origin, normalised(target - origin), {}};
}

struct Seen {
    std::array<int, 3> first{};  ///< hits of shapes 0, 1, 2
    int nothing = 0, unhidden = 0;
};
Seen look(const Scene& scene, const Opacity& opacity) {
    const Accelerator tree(scene, std::vector<bool>(scene.shapes.size(), false), &opacity);
    Seen seen;
    for (std::uint32_t i = 0; i < kRays; ++i) {
        const Ray ray = ray_down(i);
        const Hit hit = tree.intersect(ray);
        if (hit)
            ++seen.first[std::size_t(hit.shape)];
        else
            ++seen.nothing;
        seen.unhidden += !tree.occluded(ray, 100.0);
    }
    return seen;
}

struct Veil {
    const char* name;
    Geometry geometry;
};
std::vector<Veil> veils() {
    return {{"mesh", quad_mesh()},
            {"rectangle", Rectangle{2.0 * m, 2.0 * m}},
            {"disc", Disc{2.0 * m}},
            {"plane", Plane{}}};
}

/// A lamp behind a veil: what comes through, by rays that find it and by shadow rays.
TEST(Opacity, AVeilLetsThroughItsShare) {
    for (const Veil& veil : veils()) {
        SCOPED_TRACE(veil.name);
        const Scene scene =
            scene_of({{veil.geometry, {}}, {Rectangle{9.0 * m, 9.0 * m}, translation({0, 0, -1})}});
        const Even opacity(kShare, 1);
        const Accelerator tree(scene, {false, false}, &opacity);
        int found = 0, unhidden = 0;
        for (std::uint32_t i = 0; i < kRays; ++i) {
            const Ray ray = ray_down(i);
            found += tree.intersect(ray).shape == 1;
            unhidden += !tree.occluded(ray, -4.0 / ray.direction.z);
        }
        EXPECT_LT(std::abs(sigmas_off(found, 1.0 - kShare)), kSigmas);
        EXPECT_LT(std::abs(sigmas_off(unhidden, 1.0 - kShare)), kSigmas);
    }
}

/// The planted fault: a veil of 0.31 is told from one of 0.3.
TEST(Opacity, TheTestTellsAnOpacityFromAnother) {
    for (const Veil& veil : veils()) {
        const Seen seen = look(scene_of({{veil.geometry, {}}}), Even(kShare + 0.01));
        EXPECT_GT(sigmas_off(seen.first[0], kShare), kSigmas) << veil.name;
        EXPECT_LT(sigmas_off(seen.unhidden, 1.0 - kShare), -kSigmas) << veil.name;
    }
}

TEST(Opacity, LayersMultiply) {
    for (const Veil& veil : veils()) {
        SCOPED_TRACE(veil.name);
        const Seen seen =
            look(scene_of({{veil.geometry, translation({0, 0, 0.1})}, {veil.geometry, {}}}),
                 Even(kShare));
        const double through = 1.0 - kShare;
        EXPECT_LT(std::abs(sigmas_off(seen.first[0], kShare)), kSigmas);
        EXPECT_LT(std::abs(sigmas_off(seen.first[1], through * kShare)), kSigmas);
        EXPECT_LT(std::abs(sigmas_off(seen.nothing, through * through)), kSigmas);
        EXPECT_LT(std::abs(sigmas_off(seen.unhidden, through * through)), kSigmas);
    }
}

/// A ray that found a hole in a body's near side meets the far side from within, independently.
TEST(Opacity, BodiesHaveTwoSides) {
    const std::vector<Veil> bodies{{"sphere", Sphere{2.0 * m}},
                                   {"box", Box{4.0 * m, 4.0 * m, 2.0 * m}},
                                   {"prism", Prism{60.0 * unit::deg, 8.0 * m, 2.0 * m}}};
    for (const Veil& body : bodies) {
        SCOPED_TRACE(body.name);
        const Scene scene = scene_of({{body.geometry, {}}});
        const Even opacity(kShare);
        const Accelerator tree(scene, {false}, &opacity);
        int near = 0, far = 0, unhidden = 0;
        for (std::uint32_t i = 0; i < kRays; ++i) {
            const Ray ray = ray_down(i);
            const Hit hit = tree.intersect(ray);
            if (hit) ++(dot(hit.normal, ray.direction) < 0.0 ? near : far);
            unhidden += !tree.occluded(ray, 100.0);
        }
        const double through = 1.0 - kShare;
        EXPECT_LT(std::abs(sigmas_off(near, kShare)), kSigmas);
        EXPECT_LT(std::abs(sigmas_off(far, through * kShare)), kSigmas);
        EXPECT_LT(std::abs(sigmas_off(unhidden, through * through)), kSigmas);
    }
}

/// Opaque for u < 0.5, so that no chance is left.
class LeftHalf : public Opacity {
public:
    bool tests(int) const override { return true; }
    double at(int, int, double u, double) const override { return u < 0.5 ? 1.0 : 0.0; }
};

TEST(Opacity, ACutOutIsWhereItsCoordinatesSay) {
    constexpr double kEdge = 1e-6;  // coordinates on triangles are floats
    struct Cut {
        Geometry geometry;
        double (*u)(Vec3);
    };
    const std::vector<Cut> cuts{
        // Below the diagonal the weight of the corner (1, -1), above it that of (1, 1).
        {quad_mesh(), [](Vec3 p) { return 0.5 * (p.x > p.y ? p.x - p.y : p.x + 1.0); }},
        {Rectangle{2.0 * m, 2.0 * m}, [](Vec3 p) { return 0.5 + 0.5 * p.x; }},
        {Disc{2.0 * m}, [](Vec3 p) { return 0.5 + 0.25 * p.x; }},
        {Plane{}, [](Vec3 p) { return p.x; }}};
    const LeftHalf half;
    for (const Cut& cut : cuts) {
        SCOPED_TRACE(cut.geometry.index());
        const Scene scene = scene_of({{cut.geometry, {}}});
        const Accelerator tree(scene, {false}, &half);
        for (std::uint32_t i = 0; i < 10'000; ++i) {
            const Ray ray = ray_down(i);
            const double u = cut.u(ray.origin + ray.direction * (-ray.origin.z / ray.direction.z));
            if (std::abs(u - 0.5) < kEdge) continue;
            ASSERT_EQ(bool(tree.intersect(ray)), u < 0.5) << i;
            ASSERT_EQ(tree.occluded(ray, 100.0), u < 0.5) << i;
        }
    }
}

TEST(Opacity, PacketsFindWhatSingleRaysFind) {
    const Scene scene = scene_of({{quad_mesh(), {}},
                                  {Sphere{0.5 * m}, translation({0, 0, 1})},
                                  {Plane{}, translation({0, 0, -1})}});
    const Even opacity(kShare);
    const Accelerator tree(scene, {false, false, false}, &opacity);
    for (std::uint32_t i = 0; i < 2000; ++i) {
        RayLanes rays;
        rays.count = 8;
        for (int k = 0; k < 8; ++k) rays.set(k, ray_down(8 * i + std::uint32_t(k)));
        HitLanes hits;
        tree.intersect(rays, 0xffu, hits);
        for (int k = 0; k < 8; ++k) {
            const Hit alone = tree.intersect(rays.ray(k));
            ASSERT_EQ(hits[std::size_t(k)].shape, alone.shape);
            ASSERT_EQ(hits[std::size_t(k)].t, alone.t);
        }
    }
}

TEST(Opacity, AllAndNothingLeaveNothingToChance) {
    for (std::uint32_t i = 0; i < 100; ++i) {
        const Ray ray = ray_down(i);
        EXPECT_TRUE(is_there(1.0, {ray.origin, ray.direction, 0, int(i), false}));
        EXPECT_FALSE(is_there(0.0, {ray.origin, ray.direction, 0, int(i), false}));
    }
}

}  // namespace
}  // namespace dewbow
