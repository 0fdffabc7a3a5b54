// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/accelerator.h"

#include <gtest/gtest.h>

#include "dewbow/base/random.h"
#include "dewbow/math/sampling.h"

namespace dewbow {
namespace {

using unit::deg;
using unit::m;

constexpr double kRounding = 1e-12;
const Affine kAskew = translation({0.3, -0.2, 0.1}) * rotation(normalised({1, 2, 3}), 40.0 * deg);

int add(Scene& scene, Geometry geometry, const Affine& place = {}) {
    if (scene.materials.empty()) scene.add({"black", Black{}, nullptr});
    scene.shapes.push_back({"", std::move(geometry), Transform<World, Object>(place), 0});
    return int(scene.shapes.size()) - 1;
}
Accelerator tree_of(const Scene& scene) {
    return Accelerator(scene, std::vector<bool>(scene.shapes.size(), false));
}

std::shared_ptr<Mesh> box_mesh() {
    auto mesh = std::make_shared<Mesh>();
    for (int i = 0; i < 8; ++i)
        mesh->vertices.push_back({{(i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2 & 1) - 0.5}});
    mesh->triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                       {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return mesh;
}

/// A ball of `rows` × 2 `rows` quadrangles.
std::shared_ptr<Mesh> ball_mesh(int rows) {
    auto mesh = std::make_shared<Mesh>();
    const auto columns = std::uint32_t(2 * rows);
    mesh->vertices.push_back({{0, 0, 1}});
    for (int r = 1; r < rows; ++r)
        for (std::uint32_t c = 0; c < columns; ++c) {
            const double theta = 3.141592653589793 * r / rows, phi = 3.141592653589793 * c / rows;
            mesh->vertices.push_back({{std::sin(theta) * std::cos(phi),
                                       std::sin(theta) * std::sin(phi), std::cos(theta)}});
        }
    mesh->vertices.push_back({{0, 0, -1}});
    const auto last = std::uint32_t(mesh->vertices.size() - 1);
    const auto at = [&](int r, std::uint32_t c) {
        return 1 + std::uint32_t(r - 1) * columns + c % columns;
    };
    for (std::uint32_t c = 0; c < columns; ++c) {
        mesh->triangles.push_back({0, at(1, c), at(1, c + 1)});
        mesh->triangles.push_back({last, at(rows - 1, c + 1), at(rows - 1, c)});
        for (int r = 1; r + 1 < rows; ++r) {
            mesh->triangles.push_back({at(r, c), at(r + 1, c), at(r + 1, c + 1)});
            mesh->triangles.push_back({at(r, c), at(r + 1, c + 1), at(r, c + 1)});
        }
    }
    return mesh;
}

Ray random_ray(std::uint32_t i, double distance, double ball) {
    const SampleKey key(4, i);
    const auto a = key.two(0, Purpose::test), b = key.two(1, Purpose::test);
    const Vec3 o = distance * sample_uniform_sphere<World>(a[0], a[1]).v;
    const Vec3 target =
        ball * std::cbrt(key.one(2, Purpose::test)) * sample_uniform_sphere<World>(b[0], b[1]).v;
    return {o, normalised(target - o), {}};
}

/// Embree only chooses the triangle: distances are those of double precision, near and far.
TEST(Accelerator, AMeshBoxIsABox) {
    Scene analytic = make_empty_scene(), mesh = make_empty_scene();
    add(analytic, Box{1.0 * m, 1.0 * m, 1.0 * m}, kAskew);
    add(mesh, box_mesh(), kAskew);
    const Accelerator a = tree_of(analytic), b = tree_of(mesh);
    for (const double distance : {3.0, 3000.0}) {
        int hits = 0, differ = 0;
        for (std::uint32_t i = 0; i < 100000; ++i) {
            const Ray ray = random_ray(i, distance, 1.0);
            const Hit x = a.intersect(ray), y = b.intersect(ray);
            differ += bool(x) != bool(y) || (x && length(x.normal - y.normal) > kRounding);
            if (!x || !y || length(x.normal - y.normal) > kRounding) continue;
            ++hits;
            ASSERT_NEAR(x.t, y.t, kRounding * distance);
            ASSERT_EQ(y.shape, 0);
        }
        EXPECT_GT(hits, 20000);
        EXPECT_LE(differ, 2) << "rays within a float's rounding of an edge";
    }
}

TEST(Accelerator, AFineMeshBallIsNearlyASphere) {
    // Sagitta of the facets: (π / 256)² / 2 in height; up to its root at the rim, which is left
    // out.
    constexpr double kFacets = 8e-4;
    Scene sphere = make_empty_scene(), mesh = make_empty_scene();
    add(sphere, Sphere{1.0 * m}, kAskew);
    add(mesh, ball_mesh(256), kAskew);
    const Accelerator a = tree_of(sphere), b = tree_of(mesh);
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const Ray ray = random_ray(i, 4.0, 1.0);
        const Hit x = a.intersect(ray);
        if (!x || dot(x.normal, ray.direction) > -0.3) continue;
        const Hit y = b.intersect(ray);
        ASSERT_TRUE(y);
        ASSERT_NEAR(x.t, y.t, kFacets);
        ASSERT_GT(dot(x.normal, y.normal), 0.999);
    }
}

/// The packet calls find what single rays find, lane by lane, and leave other lanes alone.
TEST(Accelerator, PacketsFindWhatSingleRaysFind) {
    Scene scene = make_empty_scene();
    add(scene, box_mesh(), kAskew);
    add(scene, ball_mesh(16), translation({0.5, 0, 0}) * scaling({0.4, 0.4, 0.4}));
    add(scene, Sphere{0.5 * m}, translation({-0.6, 0.2, 0}));
    add(scene, Plane{}, translation({0, 0, -0.3}));
    const Accelerator tree = tree_of(scene);
    for (const int count : {1, 4, 8, 16}) {
        for (std::uint32_t i = 0; i < 3000; ++i) {
            RayLanes rays;
            rays.count = count;
            for (int k = 0; k < count; ++k)
                rays.set(k, random_ray(i * 16 + std::uint32_t(k) / 4, 3.0, 1.0));
            const LaneMask mask = (0x5bd1u >> (i % 3)) & ((1u << count) - 1u);
            HitLanes hits;
            for (Hit& hit : hits) hit.t = -7.0;
            tree.intersect(rays, mask, hits);
            for (int k = 0; k < count; ++k) {
                const Hit& found = hits[std::size_t(k)];
                if (!(mask >> k & 1u)) {
                    ASSERT_EQ(found.t, -7.0);
                    continue;
                }
                const Hit alone = tree.intersect(rays.ray(k));
                ASSERT_EQ(found.shape, alone.shape);
                if (!alone) continue;
                ASSERT_EQ(found.t, alone.t);
                ASSERT_EQ(found.primitive, alone.primitive);
                ASSERT_EQ(found.normal, alone.normal);
            }
        }
    }
}

TEST(Accelerator, TenThousandSpheres) {
    Scene scene = make_empty_scene();
    std::vector<Vec3> centres;
    constexpr double kRadius = 0.02;
    for (std::uint32_t i = 0; i < 10000; ++i) {
        const SampleKey key(5, i);
        const auto a = key.two(0, Purpose::test), b = key.two(1, Purpose::test);
        centres.push_back({a[0] - 0.5, a[1] - 0.5, b[0] - 0.5});
        add(scene, Sphere{kRadius * m}, translation(centres.back()));
    }
    const Accelerator tree = tree_of(scene);
    for (std::uint32_t i = 0; i < 2000; ++i) {
        const Ray ray = random_ray(i, 2.0, 0.5);
        double nearest = std::numeric_limits<double>::infinity();
        int which = -1;
        for (std::size_t k = 0; k < centres.size(); ++k) {
            const Vec3 to = centres[k] - ray.origin;
            const double along = dot(to, ray.direction);
            const Vec3 aside = to - ray.direction * along;
            const double d2 = kRadius * kRadius - dot(aside, aside);
            if (d2 < 0.0 || along - std::sqrt(d2) > nearest) continue;
            nearest = along - std::sqrt(d2), which = int(k);
        }
        const Hit hit = tree.intersect(ray);
        ASSERT_EQ(hit.shape, which);
        if (!hit) continue;
        ASSERT_NEAR(hit.t, nearest, 1e-10);
    }
}

/// Rays from inside a closed mesh meet it, through its edges too. (Embree says nothing of corners;
/// to hit one within its precision has a chance of 1e-13.)
TEST(Accelerator, AClosedMeshIsTight) {
    constexpr int kFewAtCorners = 100;  // of 100000
    Scene scene = make_empty_scene();
    const auto ball = ball_mesh(12);
    add(scene, ball, kAskew);
    const Accelerator tree = tree_of(scene);
    int lost_at_corners = 0;
    for (std::uint32_t i = 0; i < 300000; ++i) {
        const SampleKey key(6, i);
        const auto a = key.two(0, Purpose::test);
        const Vec3 inside = kAskew.apply(0.7 * sample_uniform_sphere<World>(a[0], a[1]).v);
        const auto& triangle = ball->triangles[(i / 3) % ball->triangles.size()];
        Vec3 target = ball->vertices[triangle[0]].v;
        if (i % 3 == 1) {
            const double share = key.one(1, Purpose::test);
            target = target * (1.0 - share) + ball->vertices[triangle[1]].v * share;
        }
        if (i % 3 == 2) target = sample_uniform_sphere<World>(a[1], a[0]).v;
        const Hit hit = tree.intersect({inside, normalised(kAskew.apply(target) - inside), {}});
        if (i % 3 == 0 && !hit) {
            ++lost_at_corners;
            continue;
        }
        ASSERT_TRUE(hit) << i;
        ASSERT_GT(hit.t, 0.0);
    }
    EXPECT_LE(lost_at_corners, kFewAtCorners);
}

TEST(Accelerator, ARayDoesNotMeetTheTriangleItStartsOn) {
    constexpr int kFewAtEdges = 20;  // of 100000, at slopes down to 1e-4
    int met_again = 0;
    Scene scene = make_empty_scene();
    add(scene, box_mesh(), kAskew);
    add(scene, Sphere{0.1 * m});  // so that the box is not known to be empty
    const Accelerator tree = tree_of(scene);
    for (std::uint32_t i = 0; i < 100000; ++i) {
        const Ray ray = random_ray(i, 3.0, 0.5);
        const Hit hit = tree.intersect(ray);
        if (hit.shape != 0) continue;
        const Vec3 p = ray.origin + ray.direction * hit.t;
        const SampleKey key(7, i);
        const Tangents frame = tangents_of(hit.normal);
        const double slope = std::pow(10.0, -4.0 * key.one(0, Purpose::test));
        const double turn = 6.283185307179586 * key.one(1, Purpose::test);
        const Vec3 along = frame.t * std::cos(turn) + frame.b * std::sin(turn);
        // The box is convex: outward there is nothing, inward the way out. (Beside an edge, within
        // what a float can tell, a flat ray outward may meet the next face.)
        const Ray outward{p, normalised(along + hit.normal * slope), {0, hit.primitive, false}};
        const Hit none = tree.intersect(outward);
        met_again += bool(none);
        ASSERT_TRUE(!none || none.primitive != hit.primitive);
        const Vec3 inward = normalised(along - hit.normal * slope);
        const Hit out = tree.intersect({p, inward, {0, hit.primitive, true}});
        ASSERT_TRUE(out);
        ASSERT_TRUE(out.shape == 1 || dot(out.normal, inward) > 0.0);
    }
    EXPECT_LE(met_again, kFewAtEdges);
}

/// What lies nearer to a light than a float's rounding may be missed.
constexpr double kFloat = 1e-5;

TEST(Accelerator, ShadowsEndBeforeTheLight) {
    Scene scene = make_empty_scene();
    add(scene, Rectangle{2.0 * m, 2.0 * m}, kAskew);        // the light itself
    add(scene, box_mesh(), translation({0, 0, 40}));        // a light, too
    add(scene, Sphere{0.5 * m}, translation({0, 0, -40}));  // and another
    add(scene, Plane{}, translation({0, 0, -100}));
    const Accelerator tree = tree_of(scene);
    for (std::uint32_t i = 0; i < 30000; ++i) {
        Ray ray = random_ray(i, 5.0, 1.0);
        if (i % 3 == 1) ray.origin += Vec3{0, 0, 40};
        if (i % 3 == 2) ray.origin += Vec3{0, 0, -40};
        const Hit hit = tree.intersect(ray);
        if (!hit || hit.shape == 3) continue;
        ASSERT_FALSE(tree.occluded(ray, hit.t)) << hit.shape;
        ASSERT_TRUE(tree.occluded(ray, hit.t * (1.0 + kFloat))) << hit.shape;
        ASSERT_TRUE(tree.occluded(ray, std::numeric_limits<double>::infinity()));
        ASSERT_FALSE(tree.occluded(ray, hit.t * 0.999));
    }
    // From afar, short of everything, and with a limit before the scene begins.
    EXPECT_FALSE(tree.occluded({{0, 1e6, 0}, {0, -1, 0}, {}}, 10.0));
    EXPECT_TRUE(tree.occluded({{0, 0.1, 1e5}, {0, 0, -1}, {}}, 1e6));
}

TEST(Accelerator, SeeThroughShapesCastNoShadow) {
    Scene scene = make_empty_scene();
    add(scene, Sphere{0.5 * m});
    add(scene, box_mesh(), translation({0, 0, 3}));
    add(scene, Plane{}, translation({0, 0, -3}));
    const Ray down{{0.1, 0.2, 9}, {0, 0, -1}, {}};
    for (const int last : {0, 1, 2}) {
        std::vector<bool> see_through(3, true);
        const Accelerator clear(scene, see_through);
        EXPECT_FALSE(clear.occluded(down, 100.0));
        see_through[std::size_t(last)] = false;
        const Accelerator one(scene, see_through);
        EXPECT_TRUE(one.occluded(down, 100.0));
        EXPECT_EQ(one.intersect(down).shape, 1) << "rays that look meet them all";
    }
}

TEST(Accelerator, InterpolatesNormalsOnTheOutwardSide) {
    Scene scene = make_empty_scene();
    auto smooth = ball_mesh(16);
    for (const auto& v : smooth->vertices) smooth->normals.push_back({v.v});
    add(scene, smooth, scaling({-1, 1, 1}));  // a mirror image: the winding turns round
    add(scene, box_mesh(), translation({5, 0, 0}));
    const Accelerator tree = tree_of(scene);
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const Ray ray = random_ray(i, 3.0, 0.9);
        const Hit hit = tree.intersect(ray);
        if (hit.shape != 0) continue;
        const Vec3 p = normalised(ray.origin + ray.direction * hit.t);
        ASSERT_LT(dot(hit.normal, ray.direction), 0.0);
        ASSERT_GT(dot(tree.shading_normal(hit), p), 0.9999);
        ASSERT_NEAR(length(tree.shading_normal(hit)), 1.0, kRounding);
    }
    EXPECT_FALSE(tree.flat(0));
    EXPECT_TRUE(tree.flat(1));
}

TEST(Accelerator, NothingIsHitInAnEmptyScene) {
    const Scene scene = make_empty_scene();
    const Accelerator tree = tree_of(scene);
    EXPECT_FALSE(tree.intersect({{0, 0, 0}, {0, 0, 1}, {}}));
    EXPECT_FALSE(tree.occluded({{0, 0, 0}, {0, 0, 1}, {}}, 1.0));
}

}  // namespace
}  // namespace dewbow
