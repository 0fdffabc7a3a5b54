// SPDX-License-Identifier: Apache-2.0

// Meshes that are shared by many shapes against the same meshes, one for each shape.

#include <gtest/gtest.h>

#include "dewbow/base/random.h"
#include "dewbow/math/sampling.h"
#include "dewbow/render/accelerator.h"

namespace dewbow {
namespace {

using unit::deg;

/// Enough of them that the accelerator shares their mesh (200,000 triangles in all).
constexpr int kShapes = 150;
/// Places are in a cube of this side, m.
constexpr double kSide = 10.0;
/// Rounding of distances of up to 20 m: planes of shared meshes are turned into the world one by
/// one, by maps whose condition number is below 10.
constexpr double kDistance = 1e-12;
/// Single precision decides which triangle is met. Of 20000 rays this many may fall within a
/// rounding (1e-6 of 10 m, on edges 0.05 m apart) of an edge and meet its neighbour.
constexpr int kFewAtEdges = 20;

/// A wavy ball of about 1400 triangles, not convex, with or without normals.
std::shared_ptr<const Mesh> wavy_ball(bool smooth) {
    constexpr int kRows = 19;
    constexpr std::uint32_t kColumns = 2 * kRows;
    auto mesh = std::make_shared<Mesh>();
    const auto add = [&](double theta, double phi) {
        const Vec3 p{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                     std::cos(theta)};
        mesh->vertices.push_back(
            {p * (1.0 + 0.15 * std::sin(5.0 * theta) * std::sin(4.0 * phi)) + Vec3{7.0, 0.0, 0.0}});
        if (smooth) mesh->normals.push_back({p});
        mesh->texcoords[0].push_back({float(phi), float(theta)});
    };
    add(0.0, 0.0);
    for (int r = 1; r < kRows; ++r)
        for (std::uint32_t c = 0; c < kColumns; ++c)
            add(3.141592653589793 * r / kRows, 3.141592653589793 * c / kRows);
    add(3.141592653589793, 0.0);
    const auto last = std::uint32_t(mesh->vertices.size() - 1);
    const auto at = [&](int r, std::uint32_t c) {
        return 1 + std::uint32_t(r - 1) * kColumns + c % kColumns;
    };
    for (std::uint32_t c = 0; c < kColumns; ++c) {
        mesh->triangles.push_back({0, at(1, c), at(1, c + 1)});
        mesh->triangles.push_back({last, at(kRows - 1, c + 1), at(kRows - 1, c)});
        for (int r = 1; r + 1 < kRows; ++r) {
            mesh->triangles.push_back({at(r, c), at(r + 1, c), at(r + 1, c + 1)});
            mesh->triangles.push_back({at(r, c), at(r + 1, c + 1), at(r, c + 1)});
        }
    }
    return mesh;
}

Vec3 random_point(std::uint32_t i, std::uint32_t vertex) {
    const SampleKey key(31, i);
    const auto a = key.two(vertex, Purpose::test), b = key.two(vertex + 1, Purpose::test);
    return {a[0] - 0.5, a[1] - 0.5, b[0] - 0.5};
}

/// Stretched, turned, and every other one a mirror image. The mesh lies 7 m off its own origin.
Affine random_place(std::uint32_t i) {
    const Vec3 size = random_point(i, 0) * 0.8 + Vec3{0.7, 0.7, 0.7};
    const double side = i % 2 ? -1.0 : 1.0;
    return translation(random_point(i, 2) * kSide) *
           rotation(normalised(random_point(i, 4)), 360.0 * random_point(i, 6).x * deg) *
           scaling({side * size.x, size.y, size.z}) * translation({-7.0, 0.0, 0.0});
}

Scene scene_of(const std::shared_ptr<const Mesh>& mesh, bool own_meshes) {
    Scene scene = make_empty_scene();
    scene.add({"black", Black{}});
    for (std::uint32_t i = 0; i < kShapes; ++i) {
        const auto own = own_meshes ? std::make_shared<const Mesh>(*mesh) : mesh;
        scene.shapes.push_back({"", own, Transform<World, Object>(random_place(i)), 0});
    }
    return scene;
}

Ray random_ray(std::uint32_t i) {
    const Vec3 origin = 1.5 * kSide * normalised(random_point(i, 8));
    return {origin, normalised(random_point(i, 10) * kSide - origin), {}};
}

struct Pair {
    std::shared_ptr<const Mesh> mesh;
    Scene alone, together;
    Accelerator own, shared;

    explicit Pair(bool smooth, const Opacity* opacity = nullptr)
        : mesh(wavy_ball(smooth)),
          alone(scene_of(mesh, true)),
          together(scene_of(mesh, false)),
          own(alone, std::vector<bool>(kShapes, false), opacity),
          shared(together, std::vector<bool>(kShapes, false), opacity) {}
};

/// The same hits, also of rays that start on a surface, inward and outward.
TEST(AcceleratorInstances, MeetWhatMeshesOfTheirOwnMeet) {
    for (const bool smooth : {false, true}) {
        const Pair pair(smooth);
        int compared = 0, differ = 0;
        for (std::uint32_t i = 0; i < 5000; ++i) {
            Ray ray = random_ray(i);
            for (int k = 0; k < 4; ++k) {
                const Hit a = pair.own.intersect(ray), b = pair.shared.intersect(ray);
                if (a.shape != b.shape || (a && a.primitive != b.primitive)) {
                    ++differ;
                    break;
                }
                if (!a) break;
                ++compared;
                ASSERT_NEAR(a.t, b.t, kDistance / std::abs(dot(a.normal, ray.direction)));
                ASSERT_LT(length(a.normal - b.normal), kDistance);
                ASSERT_LT(length(pair.own.shading_normal(a) - pair.shared.shading_normal(b)),
                          1e-4);  // barycentric coordinates are floats
                const Vec3 point = ray.origin + ray.direction * a.t;
                ASSERT_NEAR(pair.own.coordinates(a, point).uv[0].v,
                            pair.shared.coordinates(b, point).uv[0].v, 1e-9);
                const double reach = a.t * (i % 2 ? 1.001 : 0.999);
                ASSERT_EQ(pair.own.occluded(ray, reach), pair.shared.occluded(ray, reach));
                const bool through = (i + std::uint32_t(k)) % 3 > 0;
                const bool front = dot(a.normal, ray.direction) < 0.0;
                const Vec3 away =
                    through ? ray.direction
                            : ray.direction - a.normal * (2.0 * dot(a.normal, ray.direction));
                ray = {point, normalised(away), {a.shape, a.primitive, front == through}};
            }
        }
        EXPECT_GT(compared, 10000);
        EXPECT_LE(differ, kFewAtEdges);
        EXPECT_EQ(pair.own.flat(0), pair.shared.flat(0));
    }
}

TEST(AcceleratorInstances, PacketsFindWhatSingleRaysFind) {
    const Pair pair(false);
    for (std::uint32_t i = 0; i < 1000; ++i) {
        RayLanes rays;
        rays.count = 8;
        for (int k = 0; k < 8; ++k) rays.set(k, random_ray(8 * i + std::uint32_t(k)));
        HitLanes hits;
        pair.shared.intersect(rays, 0xefu, hits);
        for (int k = 0; k < 8; ++k) {
            if (k == 4) continue;
            const Hit alone = pair.shared.intersect(rays.ray(k));
            ASSERT_EQ(hits[std::size_t(k)].shape, alone.shape);
            ASSERT_EQ(hits[std::size_t(k)].t, alone.t);
            if (!alone) continue;
            ASSERT_EQ(hits[std::size_t(k)].primitive, alone.primitive);
        }
    }
}

/// A third of each triangle is cut out, and every fifth shape is whole.
class Corners : public Opacity {
public:
    bool tests(int shape) const override { return shape % 5 != 0; }
    double at(int, int, double u, double v) const override {
        return u > 0.4 ? 0.0 : v > 0.4 ? 0.5 : 1.0;
    }
};

TEST(AcceleratorInstances, AreCutOutAlike) {
    const Corners opacity;
    const Pair pair(false, &opacity);
    int differ = 0, hits = 0;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const Ray ray = random_ray(i);
        const Hit a = pair.own.intersect(ray), b = pair.shared.intersect(ray);
        hits += bool(a);
        differ += a.shape != b.shape || (a && a.primitive != b.primitive);
        differ += pair.own.occluded(ray, 12.0) != pair.shared.occluded(ray, 12.0);
    }
    EXPECT_GT(hits, 10000);
    EXPECT_LE(differ, kFewAtEdges);
}

TEST(AcceleratorInstances, SeeThroughOnesCastNoShadow) {
    const auto mesh = wavy_ball(false);
    const Scene scene = scene_of(mesh, false);
    const Accelerator clear(scene, std::vector<bool>(kShapes, true));
    for (std::uint32_t i = 0; i < 1000; ++i) ASSERT_FALSE(clear.occluded(random_ray(i), 100.0));
}

}  // namespace
}  // namespace dewbow
