// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/caster_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dewbow/base/random.h"

namespace dewbow::caustics {
namespace {

Bounds cube_at(Vec3 centre, double half) {
    Bounds box;
    box.add(centre - Vec3{half, half, half});
    box.add(centre + Vec3{half, half, half});
    return box;
}

/// Each box is in one group, which holds it.
void expect_partition(const std::vector<Bounds>& boxes, const std::vector<BoxGroup>& groups) {
    std::vector<int> times(boxes.size(), 0);
    for (const BoxGroup& group : groups)
        for (const std::uint32_t i : group.members) {
            ++times[i];
            EXPECT_EQ(min(group.bounds.low, boxes[i].low), group.bounds.low);
            EXPECT_EQ(max(group.bounds.high, boxes[i].high), group.bounds.high);
        }
    EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
}

double surface(const std::vector<BoxGroup>& groups) {
    double sum = 0.0;
    for (const BoxGroup& group : groups) sum += surface_of(group.bounds);
    return sum;
}

TEST(CasterTree, PartsWhatIsFarApart) {
    const std::vector<Bounds> boxes{cube_at({0, 0, 0}, 1), cube_at({9, 0, 0}, 1),
                                    cube_at({0.5, 0, 0}, 1), cube_at({9, 9, 9}, 1)};
    const auto groups = group_boxes(boxes, 64);
    expect_partition(boxes, groups);
    EXPECT_EQ(groups.size(), 3u);
}

TEST(CasterTree, KeepsAHeapTogether) {
    std::vector<Bounds> boxes;
    for (int i = 0; i < 1000; ++i)
        boxes.push_back(cube_at({double(i % 10), double(i / 10 % 10), double(i / 100)}, 0.5));
    const auto groups = group_boxes(boxes, 64);
    expect_partition(boxes, groups);
    EXPECT_EQ(groups.size(), 1u);
}

/// Parting a lattice of small cubes once gains nothing, parting it wholly does.
TEST(CasterTree, PartsALattice) {
    std::vector<Bounds> boxes;
    for (int i = 0; i < 64; ++i)
        boxes.push_back(cube_at({double(i % 4), double(i / 4 % 4), double(i / 16)}, 0.01));
    EXPECT_EQ(group_boxes(boxes, 64).size(), 64u);
    const auto groups = group_boxes(boxes, 20);
    expect_partition(boxes, groups);
    EXPECT_EQ(groups.size(), 20u);
    EXPECT_LT(surface(groups), surface(group_boxes(boxes, 1)));
}

TEST(CasterTree, HasNoMoreGroupsThanIsSaid) {
    std::vector<Bounds> boxes;
    for (int i = 0; i < 10000; ++i) {
        const SampleKey key(stream_key(3, 0, 0), std::uint32_t(i));
        const auto u = key.two(0, Purpose::test);
        boxes.push_back(cube_at({u[0], u[1], key.third(0, Purpose::test)}, 1e-4));
    }
    for (const std::size_t most : {1, 2, 63, 64}) {
        const auto groups = group_boxes(boxes, most);
        expect_partition(boxes, groups);
        EXPECT_LE(groups.size(), most);
    }
    EXPECT_TRUE(group_boxes({}, 64).empty());
    // All in one place: there is no plane that parts them.
    EXPECT_EQ(group_boxes(std::vector<Bounds>(50, cube_at({}, 1)), 64).size(), 1u);
}

}  // namespace
}  // namespace dewbow::caustics
