// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/unit_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

TEST(UnitPlan, CoversEveryLightPathOnce) {
    // 10 samples of 40 × 40 pixels, of which some are rendered: 3 passes, the last one of 2
    // samples.
    for (const double paths_per_sample : {12.7, 1.0, 0.3 / 6400}) {
        const double light_paths = paths_per_sample * 1600;
        UnitPlan plan({3, 5, 20, 40}, 10, kTileSide, light_paths);
        for (std::size_t pass = 0; pass < plan.passes(); ++pass) {
            const double paths = light_paths * (pass < 2 ? 4 : 2);
            std::uint64_t next = 0;
            for (std::size_t n = plan.tiles(); n < plan.units_per_pass(); ++n) {
                EXPECT_TRUE(plan.is_light(n));
                const LightUnit unit = plan.light_unit(pass, n);
                EXPECT_EQ(unit.pass, pass);
                EXPECT_EQ(unit.first_path, next);
                EXPECT_LE(unit.paths(), kLightPathsPerUnit);
                next = unit.end_path;
            }
            EXPECT_EQ(next, std::uint64_t(std::max(std::llround(paths), 1LL)));
        }
    }
    const UnitPlan without({0, 0, 40, 40}, 10);
    EXPECT_EQ(without.light_units(), 0u);
    EXPECT_EQ(without.finished_light_paths(), 0u);
}

TEST(UnitPlan, CountsTheLightPathsThatAreFinished) {
    UnitPlan plan({0, 0, 40, 40}, 10, kTileSide, 20000.0);  // 10 light units, 3 passes
    std::vector<std::pair<std::size_t, std::size_t>> units;
    for (std::size_t pass = 0; pass < plan.passes(); ++pass)
        for (std::size_t n = 0; n < plan.units_per_pass(); ++n) units.emplace_back(pass, n);
    std::mt19937 engine(4);
    std::shuffle(units.begin(), units.end(), engine);
    std::uint64_t paths = 0;
    std::int64_t samples = 0;
    for (const auto& [pass, n] : units) {
        plan.set_finished(pass, n);
        if (plan.is_light(n)) {
            paths += plan.light_unit(pass, n).paths();
        } else {
            const Unit unit = plan.unit(pass, n);
            samples += unit.tile.area() * (unit.end_sample - unit.first_sample);
        }
        ASSERT_EQ(plan.finished_light_paths(), paths);
        ASSERT_EQ(plan.finished_samples(), samples);
    }
    EXPECT_EQ(plan.first_open_pass(), 3u);
    EXPECT_EQ(paths, 200000u);
}

/// 5 passes of 9 tiles and 2 light units.
UnitPlan untouched_plan() { return UnitPlan({0, 0, 40, 40}, 20, kTileSide, 4000.0); }

/// That plan, of which units are finished with that probability.
UnitPlan random_plan(std::mt19937& engine, double probability) {
    UnitPlan plan = untouched_plan();
    std::bernoulli_distribution finished(probability);
    for (std::size_t pass = 0; pass < plan.passes(); ++pass) {
        const bool whole = engine() % 3 == 0;
        for (std::size_t unit = 0; unit < plan.units_per_pass(); ++unit)
            if (whole || finished(engine)) plan.set_finished(pass, unit);
    }
    return plan;
}

TEST(UnitPlan, CountsWhatItHasInCommonWithAnother) {
    std::mt19937 engine(7);
    for (int repeat = 0; repeat < 200; ++repeat) {
        const UnitPlan a = random_plan(engine, 0.3), b = random_plan(engine, 0.6);
        std::size_t common = 0;
        for (std::size_t pass = 0; pass < a.passes(); ++pass)
            for (std::size_t unit = 0; unit < a.units_per_pass(); ++unit)
                common += a.finished(pass, unit) && b.finished(pass, unit);
        EXPECT_EQ(a.common_units(b), common);
        EXPECT_EQ(b.common_units(a), common);
    }
}

TEST(UnitPlan, TakesOverWhatItLacks) {
    std::mt19937 engine(8);
    for (int repeat = 0; repeat < 200; ++repeat) {
        UnitPlan a = untouched_plan(), b = a, both = a;
        for (std::size_t pass = 0; pass < a.passes(); ++pass)
            for (std::size_t tile = 0; tile < a.units_per_pass(); ++tile) {
                const auto kind = engine() % (1 + pass);
                if (kind == 2) continue;
                (kind == 0 ? a : b).set_finished(pass, tile);
                both.set_finished(pass, tile);
            }
        a.add(b);
        EXPECT_EQ(a, both);
        EXPECT_EQ(a.finished_units(), both.finished_units());
        EXPECT_EQ(a.finished_samples(), both.finished_samples());
        EXPECT_EQ(a.finished_light_paths(), both.finished_light_paths());
    }
}

/// Bytes that are there whole.
class Bytes : public ByteSource {
public:
    explicit Bytes(std::string bytes) : bytes_(std::move(bytes)) {}
    void read(char* to, std::size_t size) override {
        if (size > left()) throw InputError("it ends too early");
        bytes_.copy(to, size, at_);
        at_ += size;
    }
    std::uint64_t left() const override { return bytes_.size() - at_; }

private:
    std::string bytes_;
    std::size_t at_ = 0;
};

TEST(UnitPlan, ComesBackFromItsBytes) {
    std::mt19937 engine(9);
    for (int repeat = 0; repeat < 200; ++repeat) {
        const UnitPlan plan = random_plan(engine, 0.4);
        Bytes bytes([&] {
            std::string text;
            plan.append_bytes(text);
            return text;
        }());
        UnitPlan back = untouched_plan();
        back.read_bytes(bytes);
        EXPECT_EQ(back, plan);
        EXPECT_EQ(back.finished_units(), plan.finished_units());
        EXPECT_EQ(bytes.left(), 0u);
    }
}

TEST(UnitPlan, MillionsOfFinishedPassesAreFewBytes) {
    UnitPlan plan({0, 0, 16, 16}, std::int64_t{1} << 24);
    for (std::size_t pass = 0; pass < 1'000'000; ++pass) plan.set_finished(pass, 0);
    std::string bytes;
    plan.append_bytes(bytes);
    EXPECT_EQ(bytes.size(), 32u);
    EXPECT_EQ(plan.first_open_pass(), 1'000'000u);
}

TEST(UnitPlan, RefusesBytesThatCannotBe) {
    using Numbers = std::vector<std::uint64_t>;
    const auto refused = [](const Numbers& numbers, const std::string& bits = "") {
        std::string text;
        for (const std::uint64_t number : numbers) append_value(text, number);
        Bytes bytes(text + bits);
        UnitPlan plan({0, 0, 40, 40}, 20);
        EXPECT_THROW(plan.read_bytes(bytes), InputError);
    };
    refused({1, 2, 2, 0});                  // an empty run
    refused({1, 3, 2, 0});                  // its end before its start
    refused({1, 0, 6, 0});                  // more passes than there are
    refused({2, 0, 1, 1, 2, 0});            // two runs that are one
    refused({2, 3, 4, 0, 1, 0});            // out of order
    refused({~std::uint64_t{0}});           // more than there are bytes
    refused({0, 1, 5}, {"\1\0", 2});        // a pass that there is not
    refused({0, 1, 0}, {"\0\0", 2});        // begun without a unit
    refused({0, 1, 0}, {"\xff\1", 2});      // begun, and whole
    refused({0, 1, 0}, {"\1\2", 2});        // a tile that there is not
    refused({1, 0, 1, 1, 0}, {"\1\0", 2});  // whole and begun
    refused({0, 2, 1}, {"\1\0\1\0", 4});    // ends too early
}

}  // namespace
}  // namespace dewbow
