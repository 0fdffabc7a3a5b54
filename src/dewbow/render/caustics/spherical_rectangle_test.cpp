// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/spherical_rectangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/math/vector.h"

namespace dewbow::caustics {
namespace {

constexpr double kPi = std::numbers::pi;
/// Mostly of the formula for triangles, whose denominator cancels where they are wide.
constexpr double kRounding = 1e-12;

/// Solid angle of a triangle. [Van Oosterom & Strackee, "The Solid Angle of a Plane Triangle",
/// 1983]
double solid_angle(Vec3 a, Vec3 b, Vec3 c) {
    const double la = length(a), lb = length(b), lc = length(c);
    return 2.0 * std::atan2(std::abs(dot(a, cross(b, c))),
                            la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}
double solid_angle(double x0, double x1, double y0, double y1, double z) {
    return solid_angle({x0, y0, z}, {x1, y0, z}, {x1, y1, z}) +
           solid_angle({x0, y0, z}, {x1, y1, z}, {x0, y1, z});
}

struct Rect {
    double x0, x1, y0, y1, z;
};
/// Before the point, aside, near, wide and thin, small and far.
constexpr Rect kRects[]{{-1, 1, -1, 1, 1},      {2, 3, -1, 5, 0.5},        {-7, -6, 1, 2, 3},
                        {-1, 1, -1, 1, 0.01},   {-40, 50, 0.5, 0.6, 2},    {3, 3.01, 4, 4.02, 5},
                        {0.1, 0.4, -9, 8, 0.2}, {-1e3, 1e3, -1e3, 1e3, 1}, {-0.1, 2, -3, -1, 1}};

TEST(SphericalRectangle, HasTheSolidAngleOfItsTwoTriangles) {
    for (const Rect& r : kRects)
        EXPECT_NEAR(SphericalRectangle(r.x0, r.x1, r.y0, r.y1, r.z).solid_angle(),
                    solid_angle(r.x0, r.x1, r.y0, r.y1, r.z), kRounding);
    EXPECT_NEAR(SphericalRectangle(-1, 1, -1, 1, 1).solid_angle(), 4.0 * kPi / 6.0, kRounding)
        << "a side of a cube";
}

/// The part of the rectangle up to (x, y) = sample(u) has the share u0 of the solid angle up to x,
/// and of that about any one x the share u1 up to y.
TEST(SphericalRectangle, GivesDirectionsAlike) {
    constexpr int kGrid = 9;
    for (const Rect& r : kRects) {
        const SphericalRectangle seen(r.x0, r.x1, r.y0, r.y1, r.z);
        const double all = seen.solid_angle();
        for (int i = 1; i < kGrid; ++i) {
            const double u = double(i) / kGrid;
            const auto p = seen.sample({u, u});
            EXPECT_NEAR(solid_angle(r.x0, p.x, r.y0, r.y1, r.z), u * all, kRounding);
            // A strip so thin that y hardly differs across it, so wide that it is not rounding.
            const double thin = 1e-5 * std::min(r.x1 - r.x0, r.z);
            constexpr double kStrip = 1e-6;
            const double strip = solid_angle(p.x - thin, p.x + thin, r.y0, r.y1, r.z);
            const double below = solid_angle(p.x - thin, p.x + thin, r.y0, p.y, r.z);
            EXPECT_NEAR(below / strip, u, kStrip);
        }
    }
}

TEST(SphericalRectangle, FindsBackTheNumbers) {
    constexpr int kGrid = 10;
    for (const Rect& r : kRects) {
        const SphericalRectangle seen(r.x0, r.x1, r.y0, r.y1, r.z);
        const double found_back = kRounding / seen.solid_angle() + 1e-9;
        for (int i = 0; i < kGrid * kGrid; ++i) {
            const std::array<double, 2> u{(i % kGrid + 0.5) / kGrid, (i / kGrid + 0.5) / kGrid};
            const auto back = seen.place_of(seen.sample(u));
            EXPECT_NEAR(back[0], u[0], found_back);
            EXPECT_NEAR(back[1], u[1], found_back);
        }
    }
}

}  // namespace
}  // namespace dewbow::caustics
