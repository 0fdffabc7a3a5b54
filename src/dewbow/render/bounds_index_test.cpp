// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/bounds_index.h"

#include <gtest/gtest.h>

#include <set>

#include "dewbow/base/random.h"

namespace dewbow {
namespace {

Bounds random_box(std::uint32_t i) {
    const SampleKey key(41, i);
    const auto a = key.two(0, Purpose::test), b = key.two(1, Purpose::test);
    const double size = 0.2 * key.one(2, Purpose::test);
    const Vec3 low{a[0], a[1], b[0]};
    return {low, low + Vec3{size, size * b[1], size}};
}

TEST(BoundsIndex, AsksAboutThoseThatOverlapAndNoOthers) {
    std::vector<Bounds> boxes;
    for (std::uint32_t i = 0; i < 1000; ++i) boxes.push_back(random_box(i));
    boxes.push_back({});         // empty: a plane's
    boxes.push_back(boxes[17]);  // twice the same
    boxes.push_back({{-1e300, -1e300, -1e300}, {1e300, 1e300, 1e300}});
    const BoundsIndex index(boxes);
    for (std::uint32_t i = 0; i < 500; ++i) {
        const Bounds box = random_box(5000 + i);
        std::set<std::size_t> expected, asked;
        for (std::size_t k = 0; k < boxes.size(); ++k)
            if (!boxes[k].empty() && boxes[k].overlaps(box)) expected.insert(k);
        EXPECT_FALSE(index.any(box, [&](std::size_t k) {
            EXPECT_TRUE(asked.insert(k).second);
            return false;
        }));
        ASSERT_EQ(asked, expected);
    }
}

TEST(BoundsIndex, EndsWithTheFirstThatIsIt) {
    const BoundsIndex index({{{0, 0, 0}, {1, 1, 1}}, {{1, 1, 1}, {2, 2, 2}}});
    int asked = 0;
    EXPECT_TRUE(index.any({{1, 1, 1}, {1, 1, 1}}, [&](std::size_t) { return ++asked == 1; }));
    EXPECT_EQ(asked, 1);
    EXPECT_FALSE(BoundsIndex({}).any({{0, 0, 0}, {1, 1, 1}}, [](std::size_t) { return true; }));
}

}  // namespace
}  // namespace dewbow
