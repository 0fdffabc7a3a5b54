// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/analytic_shape.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <type_traits>

#include "dewbow/base/random.h"
#include "dewbow/math/sampling.h"

namespace dewbow {
namespace {

using unit::deg;
using unit::m;

/// Rounding of a hit point a few metres off.
constexpr double kOnSurface = 1e-13;

const Affine kAskew = translation({0.3, -0.2, 0.1}) * rotation(normalised({1, 2, 3}), 40.0 * deg);

Shape shape_of(Geometry geometry, const Affine& place = kAskew) {
    return {"", std::move(geometry), Transform<World, Object>(place), 0};
}

/// For rays that start on no other shape.
AnalyticShape analytic(const Shape& shape) { return AnalyticShape(shape, 0.0); }

struct Body {
    const char* name;
    Shape shape;
    /// How far outside of the surface a point of the object frame is, by |gradient| = 1 or so.
    double (*outside)(Vec3 p);
};
std::vector<Body> bodies() {
    return {
        {"sphere", shape_of(Sphere{1.0 * m}), [](Vec3 p) { return length(p) - 1.0; }},
        {"ellipsoid", shape_of(Sphere{1.0 * m}, kAskew * scaling({1.0, 0.3, 2.0})),
         [](Vec3 p) { return length(p) - 1.0; }},
        {"mirrored", shape_of(Sphere{1.0 * m}, kAskew * scaling({-1.0, 1.0, 1.0})),
         [](Vec3 p) { return length(p) - 1.0; }},
        {"box", shape_of(Box{1.0 * m, 2.0 * m, 0.5 * m}),
         [](Vec3 p) {
             return std::max({std::abs(p.x) - 0.5, std::abs(p.y) - 1.0, std::abs(p.z) - 0.25});
         }},
        {"prism", shape_of(Prism{60.0 * deg, 2.0 * m, 1.0 * m}),
         [](Vec3 p) {
             const double h = std::sqrt(3.0), c = h / 2.0;
             return std::max({-h / 3.0 - p.y, std::abs(p.z) - 0.5,
                              c * std::abs(p.x) + 0.5 * (p.y - 2.0 / 3.0 * h)});
         }},
    };
}

TEST(AnalyticShape, HitsLieOnTheSurfaceAndTheNormalPointsOut) {
    for (const Body& body : bodies()) {
        SCOPED_TRACE(body.name);
        const AnalyticShape shape = analytic(body.shape);
        const Affine local = body.shape.world_from_object.inverse().affine();
        int hits = 0;
        for (std::uint32_t i = 0; i < 50000; ++i) {
            const SampleKey key(2, i);
            const auto a = key.two(0, Purpose::test), b = key.two(1, Purpose::test);
            const Vec3 o = 4.0 * sample_uniform_sphere<World>(a[0], a[1]).v;
            const Vec3 target = 0.8 * sample_uniform_sphere<World>(b[0], b[1]).v;
            const Vec3 d = normalised(target - o);
            double t = 0.0;
            int face = 0;
            const double inf = std::numeric_limits<double>::infinity();
            if (!shape.intersect(o, d, false, false, inf, t, face)) continue;
            ++hits;
            const Vec3 p = o + d * t;
            ASSERT_NEAR(body.outside(local.apply(p)), 0.0, 10.0 * kOnSurface);
            const Vec3 n = shape.normal(p, face);
            ASSERT_NEAR(length(n), 1.0, kOnSurface);
            ASSERT_LT(dot(n, d), 0.0) << "from outside";
            ASSERT_GT(body.outside(local.apply(p + n * 1e-6)), 0.0);
            ASSERT_LT(body.outside(local.apply(p - n * 1e-6)), 0.0);
            // Nothing on the way: the nearest hit.
            for (int step = 1; step < 10; ++step)
                ASSERT_GT(body.outside(local.apply(o + d * (t * step / 10.0))), -1e-9);
            // A ray that starts there inward meets the far side, one outward nothing.
            double again = 0.0;
            int far = 0;
            ASSERT_TRUE(shape.intersect(p, d, true, true, inf, again, far));
            ASSERT_NEAR(body.outside(local.apply(p + d * again)), 0.0, 10.0 * kOnSurface);
            ASSERT_GT(dot(shape.normal(p + d * again, far), d), 0.0);
            ASSERT_FALSE(shape.intersect(p, d, true, false, inf, again, far));
            // Short of the hit there is none.
            ASSERT_FALSE(shape.intersect(p - d * t, d, false, false, t * (1.0 - 1e-9), again, far));
        }
        EXPECT_GT(hits, 5000);
    }
}

/// From a surface at angles down to 1e-12 rad: inward there is always a way out, and outward
/// nothing.
TEST(AnalyticShape, GrazingRaysNeverGetLost) {
    for (const Body& body : bodies()) {
        SCOPED_TRACE(body.name);
        const AnalyticShape shape = analytic(body.shape);
        const double inf = std::numeric_limits<double>::infinity();
        for (std::uint32_t i = 0; i < 50000; ++i) {
            const SampleKey key(3, i);
            const auto a = key.two(0, Purpose::test), b = key.two(1, Purpose::test);
            const Vec3 o = 4.0 * sample_uniform_sphere<World>(a[0], a[1]).v;
            const Vec3 d =
                normalised(kAskew.apply({}) - o + 0.1 * sample_uniform_sphere<World>(b[0], b[1]).v);
            double t = 0.0;
            int face = 0;
            ASSERT_TRUE(shape.intersect(o, d, false, false, inf, t, face));
            const Vec3 p = o + d * t, n = shape.normal(p, face);
            const Tangents frame = tangents_of(n);
            const double turn = 6.283185307179586 * key.one(2, Purpose::test);
            const Vec3 along = frame.t * std::cos(turn) + frame.b * std::sin(turn);
            const double slope = std::pow(10.0, -12.0 * key.one(3, Purpose::test));
            const Vec3 inward = normalised(along - n * slope);
            ASSERT_TRUE(shape.intersect(p, inward, true, true, inf, t, face));
            ASSERT_GE(t, 0.0);
            ASSERT_FALSE(
                shape.intersect(p, normalised(along + n * slope), true, false, inf, t, face));
        }
    }
}

TEST(AnalyticShape, FlatShapesHaveTheirOutline) {
    const double inf = std::numeric_limits<double>::infinity();
    const auto hit = [&](const Shape& shape, double x, double y) {
        double t = 0.0;
        int face = 0;
        return analytic(shape).intersect({x, y, 3}, {0, 0, -1}, false, false, inf, t, face) &&
               t == 3.0;
    };
    const Shape disc = shape_of(Disc{1.0 * m}, {});
    EXPECT_TRUE(hit(disc, 0.7, 0.7));
    EXPECT_FALSE(hit(disc, 0.72, 0.72));
    const Shape rectangle = shape_of(Rectangle{2.0 * m, 1.0 * m}, {});
    EXPECT_TRUE(hit(rectangle, 0.99, -0.49));
    EXPECT_FALSE(hit(rectangle, 0.99, -0.51));
    EXPECT_FALSE(hit(rectangle, 1.01, 0.0));
    EXPECT_TRUE(hit(shape_of(Plane{}, {}), 1e6, -1e6));
    EXPECT_TRUE(analytic(shape_of(Plane{}, {})).infinite());
}

/// The triangles of a body cover its surface, outwards.
TEST(AnalyticShape, TrianglesCloseTheBody) {
    const auto check = [](const std::vector<std::array<Vec3, 3>>& triangles, double volume,
                          double area) {
        double six_volumes = 0.0, twice_area = 0.0;
        for (const auto& [a, b, c] : triangles) {
            six_volumes += dot(a, cross(b, c));
            twice_area += length(cross(b - a, c - a));
        }
        EXPECT_NEAR(six_volumes / 6.0, volume, kOnSurface);
        EXPECT_NEAR(0.5 * twice_area, area, kOnSurface);
    };
    check(triangles_of(Box{1.0 * m, 2.0 * m, 3.0 * m}), 6.0, 22.0);
    const double section = std::sqrt(3.0);  // of an equilateral triangle with side 2
    check(triangles_of(Prism{60.0 * deg, 2.0 * m, 5.0 * m}), 5.0 * section, 2.0 * section + 30.0);
}

/// Coordinates on surfaces against closed forms: pictures stand upright, seen from outside.
TEST(AnalyticShape, ChartsShowPicturesUprightFromOutside) {
    constexpr double kStep = 1e-6, kCurved = 1e-9;  // error of central differences: step²
    std::vector<Body> all = bodies();
    all.push_back({"disc", shape_of(Disc{2.0 * m}), nullptr});
    all.push_back({"rectangle", shape_of(Rectangle{2.0 * m, 3.0 * m}), nullptr});
    all.push_back({"plane", shape_of(Plane{}), nullptr});
    for (const Body& body : all) {
        SCOPED_TRACE(body.name);
        const AnalyticShape shape = analytic(body.shape);
        const bool mirrored = body.shape.world_from_object.affine().determinant() < 0.0;
        std::set<int> faces;
        for (std::uint32_t i = 0; i < 3000; ++i) {
            const SampleKey key(9, i);
            const auto a = key.two(0, Purpose::test), b = key.two(1, Purpose::test);
            const Vec3 o = 5.0 * sample_uniform_sphere<World>(a[0], a[1]).v;
            const Vec3 target = 0.5 * sample_uniform_sphere<World>(b[0], b[1]).v;
            const Vec3 d = normalised(target - o);
            double t = 0.0;
            int face = 0;
            if (!shape.intersect(o, d, false, false, 100.0, t, face)) continue;
            faces.insert(face);
            const Vec3 p = o + d * t, n = shape.normal(p, face);
            const SurfaceChart at = shape.chart(p, face);
            if (!shape.infinite()) {
                ASSERT_TRUE(at.u >= 0.0 && at.u <= 1.0 && at.v >= 0.0 && at.v <= 1.0);
            }
            // To the right times up is outwards, and both lie in the surface.
            ASSERT_GT(dot(cross(at.du, -at.dv), n) * (mirrored ? -1.0 : 1.0), 0.0);
            ASSERT_NEAR(dot(at.du, n), 0.0, 1e-12 * length(at.du));
            ASSERT_NEAR(dot(at.dv, n), 0.0, 1e-12 * length(at.dv));
            // Going along du changes u alone, and by as much.
            const Vec3 step_u = at.du * kStep, step_v = at.dv * kStep;
            const SurfaceChart right = shape.chart(p + step_u, face),
                               left = shape.chart(p - step_u, face);
            const SurfaceChart down = shape.chart(p + step_v, face),
                               up = shape.chart(p - step_v, face);
            if (std::abs(at.u - 0.5) > 0.49) continue;  // across the seam
            ASSERT_NEAR(right.u - left.u, 2.0 * kStep, kCurved);
            ASSERT_NEAR(right.v - left.v, 0.0, kCurved);
            ASSERT_NEAR(down.u - up.u, 0.0, kCurved);
            ASSERT_NEAR(down.v - up.v, 2.0 * kStep, kCurved);
        }
        EXPECT_EQ(faces.size(), body.name == std::string("box")     ? 6u
                                : body.name == std::string("prism") ? 5u
                                                                    : 1u);
    }
}

TEST(AnalyticShape, ChartsBeginWhereTheConventionsSay) {
    const auto expect = [](Geometry geometry, Vec3 p, int face, double u, double v) {
        const SurfaceChart at = analytic(shape_of(std::move(geometry), {})).chart(p, face);
        EXPECT_NEAR(at.u, u, kOnSurface);
        EXPECT_NEAR(at.v, v, kOnSurface);
    };
    expect(Rectangle{2.0 * m, 4.0 * m}, {-1, 2, 0}, 0, 0.0, 0.0);  // the upper left corner
    expect(Disc{2.0 * m}, {2, 0, 0}, 0, 1.0, 0.5);
    expect(Plane{}, {3.5, 2, 0}, 0, 3.5, -2.0);
    expect(Sphere{2.0 * m}, {0, 0, 2}, 0, 0.5, 0.5);  // the middle faces +z
    expect(Sphere{2.0 * m}, {2, 0, 0}, 0, 0.75, 0.5);
    expect(Sphere{2.0 * m}, {0, 2, 0}, 0, 0.5, 0.0);
    expect(Box{2.0 * m, 4.0 * m, 6.0 * m}, {1, 2, 3}, 3, 0.0, 0.0);    // +x: left is the front
    expect(Box{2.0 * m, 4.0 * m, 6.0 * m}, {-1, 2, -3}, 4, 0.0, 0.0);  // +y: the top is behind
    expect(Box{2.0 * m, 4.0 * m, 6.0 * m}, {-1, 2, 3}, 5, 0.0, 0.0);   // +z
    const double apex = 2.0 / 3.0 * std::sqrt(3.0);  // of an equilateral cross-section of side 2
    expect(Prism{60.0 * deg, 2.0 * m, 1.0 * m}, {0, apex, -0.5}, 0, 0.0, 0.0);
    expect(Prism{60.0 * deg, 2.0 * m, 1.0 * m}, {0, apex, 0.5}, 1, 0.0, 0.0);
    expect(Prism{60.0 * deg, 2.0 * m, 1.0 * m}, {0, apex, 0.5}, 3, 0.5, 0.0);
}

}  // namespace
}  // namespace dewbow
