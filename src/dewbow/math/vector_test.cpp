// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/vector.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <type_traits>

namespace dewbow {
namespace {

// A few roundings of numbers of size 1; measured: up to 6e-16.
constexpr double kRounding = 1e-15;

template <class A, class B>
concept Subtractable = requires(A a, B b) {
    a - b;
};
template <class A, class B>
concept Dottable = requires(A a, B b) {
    dot(a, b);
};
template <class A, class B>
concept Walkable = requires(A a, B b) {
    along(a, b, 1.0);
};

// Frames do not mix, and a normal is not a direction.
static_assert(Subtractable<Point<World>, Point<World>>);
static_assert(!Subtractable<Point<World>, Point<Camera>>);
static_assert(!Subtractable<Point<World>, Dir<World>>);
static_assert(Dottable<Dir<World>, Normal<World>>);
static_assert(!Dottable<Dir<World>, Normal<Local>>);
static_assert(!Dottable<Point<World>, Dir<World>>);
static_assert(Walkable<Point<World>, Dir<World>>);
static_assert(!Walkable<Point<World>, Normal<World>>);
static_assert(!Walkable<Point<World>, Dir<Object>>);
static_assert(!std::is_convertible_v<Normal<World>, Dir<World>>);
static_assert(sizeof(Dir<World>) == 3 * sizeof(double));

static_assert(cross(Vec3{1, 0, 0}, Vec3{0, 1, 0}) == Vec3{0, 0, 1});
static_assert(cross(Vec3{0, 1, 0}, Vec3{0, 0, 1}) == Vec3{1, 0, 0});
static_assert(dot(Vec3{1, 2, 3}, Vec3{4, -5, 6}) == 12.0);
static_assert(2.0 * Vec3{1, 2, 3} - Vec3{1, 1, 1} + -Vec3{0, 1, 2} == Vec3{1, 2, 3});
static_assert(Vec3{2, 4, 6} / 2.0 == Vec3{1, 2, 3});
static_assert(Vec3{1, 2, 3}[0] == 1 && Vec3{1, 2, 3}[1] == 2 && Vec3{1, 2, 3}[2] == 3);
static_assert(min(Vec3{1, 5, 3}, Vec3{4, 2, 6}) == Vec3{1, 2, 3});
static_assert(max(Vec3{1, 5, 3}, Vec3{4, 2, 6}) == Vec3{4, 5, 6});
static_assert(along(Point<World>{{1, 1, 1}}, Dir<World>{{0, 0, 1}}, 2.0).v == Vec3{1, 1, 3});

TEST(Vector, LengthAndFiniteness) {
    EXPECT_DOUBLE_EQ(length({2, 3, 6}), 7.0);
    EXPECT_DOUBLE_EQ(length(normalised({2, 3, 6})), 1.0);
    EXPECT_TRUE(is_finite({1, 2, 3}));
    EXPECT_FALSE(is_finite({1, std::numeric_limits<double>::infinity(), 3}));
    EXPECT_FALSE(is_finite({1, 2, std::numeric_limits<double>::quiet_NaN()}));
}

void expect_orthonormal(Vec3 n) {
    const Tangents frame = tangents_of(n);
    EXPECT_NEAR(length(frame.t), 1.0, kRounding);
    EXPECT_NEAR(length(frame.b), 1.0, kRounding);
    EXPECT_NEAR(dot(frame.t, frame.b), 0.0, kRounding);
    EXPECT_NEAR(dot(frame.t, n), 0.0, kRounding);
    EXPECT_NEAR(dot(frame.b, n), 0.0, kRounding);
    EXPECT_NEAR(length(cross(frame.t, frame.b) - n), 0.0, kRounding) << "not right-handed";
}

TEST(TangentsOf, OrthonormalAtAndNearThePoles) {
    expect_orthonormal({0, 0, 1});
    expect_orthonormal({0, 0, -1});
    // Where n.z changes its sign, with either sign of zero.
    expect_orthonormal({1, 0, 0.0});
    expect_orthonormal({1, 0, -0.0});
    expect_orthonormal({0, -1, -0.0});
    for (const double tilt : {1e-300, 1e-16, 1e-9, 1e-8, 1e-4, 0.1})
        for (const double pole : {1.0, -1.0}) {
            expect_orthonormal(normalised({tilt, 0, pole}));
            expect_orthonormal(normalised({-0.5 * tilt, tilt, pole}));
            expect_orthonormal(normalised({1, tilt, pole * tilt}));
        }
}

TEST(TangentsOf, OrthonormalEverywhere) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 10'000; ++i)
        expect_orthonormal(normalised({normal(random), normal(random), normal(random)}));
}

}  // namespace
}  // namespace dewbow
