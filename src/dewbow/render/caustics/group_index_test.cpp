// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/group_index.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dewbow/base/random.h"
#include "dewbow/math/sampling.h"

namespace dewbow::caustics {
namespace {

std::array<double, 2> numbers(int i, std::uint32_t which) {
    return SampleKey(stream_key(9, which, 0), std::uint32_t(i)).two(0, Purpose::test);
}
Vec3 place(int i, std::uint32_t which) {
    const auto a = numbers(i, which), b = numbers(i, which + 1);
    return {4.0 * a[0] - 2.0, 4.0 * a[1] - 2.0, 4.0 * b[0] - 2.0};
}
Vec3 direction(int i, std::uint32_t which) {
    const auto u = numbers(i, which);
    return sample_uniform_sphere<World>(u[0], u[1]).v;
}

/// Balls and boxes, many of which overlap, and a plane.
std::vector<CasterBounds> bodies(int count) {
    std::vector<CasterBounds> all;
    for (int i = 0; i < count; ++i) {
        if (i == count / 2) {
            all.emplace_back(EndlessPlane{{0, -3, 0}, normalised(Vec3{0.1, 1, 0}), 1.0});
        } else if (i % 2) {
            all.emplace_back(Ball{place(i, 0), 0.3 * numbers(i, 2)[0]});
        } else {
            OrientedBox box;
            box.centre = place(i, 0);
            const Vec3 axis = direction(i, 3);
            const Tangents other = tangents_of(axis);
            box.axes = {axis, other.t, other.b};
            box.half = 0.1 * (place(i, 5) + Vec3{2, 2, 2});
            all.emplace_back(box);
        }
    }
    return all;
}

/// By a look at each.
int first_of_all(const std::vector<CasterBounds>& all, Vec3 o, Vec3 d, double from) {
    int first = -1;
    double nearest = 1e300;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto crossing = all[i].crossing(o, d);
        if (!crossing || crossing->t_out <= from) continue;
        const double at = std::max(from, crossing->t_in);
        if (at < nearest) nearest = at, first = int(i);
    }
    return first;
}

TEST(GroupIndex, FindsWhatALookAtEachFinds) {
    for (const int count : {1, 2, 3, 40, 600}) {
        const std::vector<CasterBounds> all = bodies(count);
        const GroupIndex index(all);
        for (int i = 0; i < 2000; ++i) {
            const Vec3 o = place(i, 10) * 1.5, d = direction(i, 12);
            ASSERT_EQ(index.first_from(o, d), first_of_all(all, o, d, 0.0)) << count << " " << i;
            ASSERT_EQ(index.first_on_line(o, d), first_of_all(all, o, d, -1e300));
        }
    }
    EXPECT_EQ(GroupIndex({}).first_from({}, {0, 0, 1}), -1);
}

/// Two boxes with faces in one plane: wherever the ray starts, the first of them is met.
TEST(GroupIndex, TellsFacesInOnePlaneAlikeFromEverywhere) {
    OrientedBox a, b;
    a.half = {1, 1, 1};
    b.centre = {0.5, 0.5, 0.3};
    b.half = {1, 1, 0.7};
    const std::vector<CasterBounds> all{CasterBounds(a), CasterBounds(b)};
    const GroupIndex index(all);
    for (int i = 0; i < 1000; ++i) {
        const auto u = numbers(i, 20), v = numbers(i, 21);
        const Vec3 on_face{u[0] - 0.4, u[1] - 0.4, 1.0};
        const Vec3 d = normalised(Vec3{v[0] - 0.5, v[1] - 0.5, -1.0});
        EXPECT_EQ(index.first_from(on_face - d * (3.0 + v[0]), d), 0);
        EXPECT_EQ(index.first_on_line(on_face + d * v[1], d), 0);
    }
}

}  // namespace
}  // namespace dewbow::caustics
