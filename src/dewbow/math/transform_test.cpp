// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <type_traits>

namespace dewbow {
namespace {

using unit::deg;
using unit::rad;

// Some ten roundings of numbers of size 1 to 10.
constexpr double kRounding = 1e-14;

void expect_near(Vec3 a, Vec3 b, double tolerance = kRounding) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

double largest_difference(const Affine& a, const Affine& b) {
    double largest = 0.0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j) largest = std::max(largest, std::abs(a.m[i][j] - b.m[i][j]));
    return largest;
}

/// Turned, scaled unevenly, mirrored, moved.
Affine awkward() {
    return translation({1, -2, 3}) * rotation(normalised({1, 2, -1}), 1.1 * rad) *
           scaling({2, -0.5, 3}) * rotation({0, 1, 0}, 0.3 * rad);
}

template <class A, class B>
concept Composable = requires(A a, B b) {
    a* b;
};
static_assert(Composable<Transform<World, Camera>, Transform<Camera, Object>>);
static_assert(!Composable<Transform<World, Camera>, Transform<Object, Camera>>);
static_assert(std::is_invocable_v<Transform<World, Camera>, Point<Camera>>);
static_assert(!std::is_invocable_v<Transform<World, Camera>, Point<World>>);
static_assert(!std::is_invocable_v<Transform<World, Camera>, Dir<Object>>);

TEST(AffineTest, BasicMaps) {
    expect_near(Affine().apply({1, 2, 3}), {1, 2, 3});
    expect_near(translation({1, 2, 3}).apply({10, 20, 30}), {11, 22, 33});
    expect_near(translation({1, 2, 3}).apply_linear({10, 20, 30}), {10, 20, 30});
    expect_near(scaling({2, 3, 4}).apply({1, 1, 1}), {2, 3, 4});
    EXPECT_DOUBLE_EQ(scaling({2, 3, 4}).determinant(), 24.0);
    EXPECT_DOUBLE_EQ(scaling({-1, 1, 1}).determinant(), -1.0);
}

TEST(AffineTest, RotationIsRightHanded) {
    expect_near(rotation({0, 0, 1}, 90.0 * deg).apply({1, 0, 0}), {0, 1, 0});
    expect_near(rotation({1, 0, 0}, 90.0 * deg).apply({0, 1, 0}), {0, 0, 1});
    expect_near(rotation({0, 1, 0}, 90.0 * deg).apply({0, 0, 1}), {1, 0, 0});
    // A third of a turn about the diagonal exchanges the axes.
    expect_near(rotation(normalised({1, 1, 1}), 120.0 * deg).apply({1, 2, 3}), {3, 1, 2});
    EXPECT_NEAR(rotation(normalised({1, 2, 3}), 1.0 * rad).determinant(), 1.0, kRounding);
}

TEST(AffineTest, SmallRotationKeepsItsSecondOrder) {
    // 1 - cos(1e-9) is 0 in doubles if computed so; the (x, y) entry of the turn is half the
    // square.
    const Affine turn = rotation(normalised({1, 1, 0}), 1e-9 * rad);
    EXPECT_NEAR(turn.m[0][1] / 2.5e-19, 1.0, 1e-12);
}

TEST(AffineTest, QuaternionAgreesWithAxisAndAngle) {
    const Vec3 axis = normalised({1, -2, 0.5});
    const double half = 0.35, s = std::sin(half);
    const Affine expected = rotation(axis, 0.7 * rad);
    for (const double scale : {1.0, 1.001, -1.0}) {
        const double k = scale * s;
        EXPECT_LT(largest_difference(rotation_of_quaternion(k * axis.x, k * axis.y, k * axis.z,
                                                            scale * std::cos(half)),
                                     expected),
                  kRounding);
    }
    EXPECT_EQ(largest_difference(rotation_of_quaternion(0, 0, 0, 1), Affine()), 0.0);
}

TEST(AffineTest, ProductAppliesTheRightFactorFirst) {
    const Affine a = awkward(), b = translation({0, 5, 0}) * rotation({1, 0, 0}, 2.0 * rad);
    const Vec3 p{0.3, -0.7, 2.0};
    expect_near((a * b).apply(p), a.apply(b.apply(p)));
    expect_near((a * b).apply_linear(p), a.apply_linear(b.apply_linear(p)));
}

TEST(AffineTest, InverseUndoes) {
    const Affine a = awkward();
    EXPECT_LT(largest_difference(a * a.inverse().value(), Affine()), kRounding);
    EXPECT_LT(largest_difference(a.inverse().value() * a, Affine()), kRounding);
}

TEST(AffineTest, InverseOfRandomMaps) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 1000; ++i) {
        Affine a;
        for (auto& row : a.m)
            for (double& entry : row) entry = normal(random);
        const auto inverse = a.inverse();
        ASSERT_TRUE(inverse);
        // Grows with the condition number, which the inverse's size tells.
        double size = 0.0;
        for (const auto& row : inverse->m)
            for (const double entry : row) size = std::max(size, std::abs(entry));
        ASSERT_LT(largest_difference(a * *inverse, Affine()), 1e-14 * (1.0 + size * size));
    }
}

TEST(AffineTest, SmallnessIsNoSingularity) {
    for (const double scale : {1e-100, 1e-9, 1e9, 1e100})
        EXPECT_TRUE(scaling({scale, scale, scale}).inverse()) << scale;
    // Flat as a sheet of paper, in any position.
    EXPECT_TRUE((rotation(normalised({1, 2, 3}), 1.0 * rad) * scaling({1, 1, 1e-9})).inverse());
    EXPECT_TRUE((scaling({1, 1, 1e-9}) * rotation(normalised({1, 2, 3}), 1.0 * rad)).inverse());
}

TEST(AffineTest, SingularMapsHaveNoInverse) {
    EXPECT_FALSE(scaling({1, 1, 0}).inverse());
    EXPECT_FALSE(scaling({0, 0, 0}).inverse());
    Affine dependent;  // rows in arithmetic progression: of rank 2, but not exactly in doubles
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) dependent.m[i][j] = 0.1 * (3 * i + j + 1);
    EXPECT_FALSE(dependent.inverse());
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Affine a;
        a.m[1][1] = bad;
        EXPECT_FALSE(a.inverse());
        Affine b;
        b.m[0][3] = bad;
        EXPECT_FALSE(b.inverse());
    }
}

TEST(LookingAt, CameraLooksAlongMinusZ) {
    const Affine world_from_camera = looking_at({1, 2, 3}, {1, 2, -7}, {0, 1, 0});
    expect_near(world_from_camera.apply({0, 0, -10}), {1, 2, -7});
    expect_near(world_from_camera.apply_linear({1, 0, 0}), {1, 0, 0});

    const Affine tilted = looking_at({4, 3, 0}, {0, 0, 0}, {0, 1, 0});
    expect_near(tilted.apply({0, 0, 0}), {4, 3, 0});
    expect_near(tilted.apply({0, 0, -5}), {0, 0, 0});
    expect_near(tilted.apply_linear({1, 0, 0}), {0, 0, -1});
    EXPECT_GT(tilted.apply_linear({0, 1, 0}).y, 0.0);
    EXPECT_NEAR(tilted.determinant(), 1.0, kRounding);
}

TEST(TransformTest, InverseUndoes) {
    const Transform<World, Object> world_from_object(awkward());
    const Point<Object> p{{0.3, -0.7, 2.0}};
    const Dir<Object> d{{0.6, 0.8, 0.0}};
    expect_near(world_from_object.inverse()(world_from_object(p)).v, p.v);
    expect_near(world_from_object.inverse()(world_from_object(d)).v, d.v);
}

TEST(TransformTest, CompositionAndItsInverse) {
    const Transform<World, Camera> world_from_camera(looking_at({4, 3, 0}, {0, 0, 0}, {0, 1, 0}));
    const Transform<Camera, Object> camera_from_object(awkward());
    const Transform<World, Object> world_from_object = world_from_camera * camera_from_object;
    const Point<Object> p{{0.3, -0.7, 2.0}};
    expect_near(world_from_object(p).v, world_from_camera(camera_from_object(p)).v);
    expect_near(world_from_object.inverse()(world_from_object(p)).v, p.v);
}

TEST(TransformTest, NormalsStayPerpendicularAndOutside) {
    const Transform<World, Object> world_from_object(awkward());
    const Dir<Object> t{normalised({1, 2, 0.5})}, b{tangents_of(t.v).t};
    const Normal<Object> n{cross(t.v, b.v)};
    const Normal<World> turned = world_from_object(n);
    EXPECT_NEAR(length(turned.v), 1.0, kRounding);
    EXPECT_NEAR(dot(world_from_object(t), turned), 0.0, kRounding);
    EXPECT_NEAR(dot(world_from_object(b), turned), 0.0, kRounding);
    // Also by a map that mirrors: what was outside stays outside.
    EXPECT_GT(dot(world_from_object(Dir<Object>{n.v}), turned), 0.0);
}

TEST(TransformTest, DefaultIsTheIdentity) {
    const Transform<World, Object> same;
    expect_near(same(Point<Object>{{1, 2, 3}}).v, {1, 2, 3}, 0.0);
    expect_near(same(Normal<Object>{{0, 1, 0}}).v, {0, 1, 0}, 0.0);
}

}  // namespace
}  // namespace dewbow
