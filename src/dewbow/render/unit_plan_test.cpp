// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/unit_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

TEST(UnitPlan, CoversEverySampleOnce) {
    const PixelRect crop{3, 5, 70, 40};
    const UnitPlan plan(crop, 10);
    EXPECT_EQ(plan.passes(), 3u);
    EXPECT_EQ(plan.units(), plan.passes() * plan.tiles());
    std::set<std::tuple<int, int, std::int64_t>> seen;
    for (std::size_t pass = 0; pass < plan.passes(); ++pass)
        for (std::size_t tile = 0; tile < plan.tiles(); ++tile) {
            const Unit unit = plan.unit(pass, tile);
            for (int y = unit.tile.y0; y < unit.tile.y1; ++y)
                for (int x = unit.tile.x0; x < unit.tile.x1; ++x)
                    for (std::int64_t i = unit.first_sample; i < unit.end_sample; ++i)
                        EXPECT_TRUE(seen.insert({x, y, i}).second);
        }
    EXPECT_EQ(seen.size(), std::size_t(crop.width() * crop.height() * 10));
    EXPECT_EQ(std::get<0>(*seen.begin()), crop.x0);
    EXPECT_EQ(std::get<0>(*seen.rbegin()), crop.x1 - 1);
}

TEST(UnitPlan, RemembersUnitsFinishedInAnyOrder) {
    UnitPlan plan({0, 0, 40, 40}, 20);  // 5 passes of 9 tiles
    std::vector<std::pair<std::size_t, std::size_t>> units;
    for (std::size_t pass = 0; pass < plan.passes(); ++pass)
        for (std::size_t tile = 0; tile < plan.tiles(); ++tile) units.emplace_back(pass, tile);
    std::mt19937 engine(3);
    std::shuffle(units.begin(), units.end(), engine);
    for (std::size_t n = 0; n < units.size(); ++n) {
        for (std::size_t i = 0; i < units.size(); ++i)
            ASSERT_EQ(plan.finished(units[i].first, units[i].second), i < n);
        plan.set_finished(units[n].first, units[n].second);
        EXPECT_EQ(plan.finished_units(), n + 1);
    }
    for (const auto& [pass, tile] : units) EXPECT_TRUE(plan.finished(pass, tile));
}

TEST(UnitPlan, MillionsOfPassesTakeNoMemory) {
    UnitPlan plan({0, 0, 960, 540}, std::int64_t{1} << 24);
    EXPECT_EQ(plan.units(), (std::size_t{1} << 22) * 60 * 34);
    plan.set_finished(plan.passes() - 1, 7);
    EXPECT_TRUE(plan.finished(plan.passes() - 1, 7));
    EXPECT_FALSE(plan.finished(plan.passes() - 2, 7));
}

}  // namespace
}  // namespace dewbow
