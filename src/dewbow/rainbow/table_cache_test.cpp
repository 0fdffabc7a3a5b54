// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/table_cache.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <set>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"

namespace dewbow {
namespace {

using namespace unit;

class TableCache : public testing::Test {
protected:
    TableCache()
        : folder_(std::filesystem::path(testing::TempDir()) /
                  ("dewbow_cache_" +
                   std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        std::filesystem::remove_all(folder_);
        request_.model = "mie";
        request_.sizes = single_drop_size(5.0 * um);
        request_.optics = {make_dispersion({"constant", {1.333}, IndexReference::vacuum}), vacuum(),
                           0.0};
        request_.wavelengths = {500.0 * nm, 600.0 * nm};
        request_.angles = {0.0 * deg, 90.0 * deg, 180.0 * deg};
    }
    ~TableCache() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path file() const { return folder_ / ("table-" + cache_key(request_)); }
    CachedTable get() const { return cached_scattering_table(request_, folder_); }

    std::filesystem::path folder_;
    TableRequest request_;
};

TEST_F(TableCache, GivesTheSameTableAgain) {
    const CachedTable made = get(), kept = get();
    EXPECT_FALSE(made.from_cache);
    EXPECT_TRUE(kept.from_cache);
    EXPECT_EQ(made.note + kept.note, "");
    ASSERT_EQ(kept.table.phase.size(), made.table.phase.size());
    for (std::size_t k = 0; k < made.table.phase.size(); ++k) {
        EXPECT_EQ(kept.table.phase[k].perpendicular, made.table.phase[k].perpendicular);
        EXPECT_EQ(kept.table.phase[k].parallel, made.table.phase[k].parallel);
    }
    EXPECT_EQ(kept.table.efficiencies[1].asymmetry, made.table.efficiencies[1].asymmetry);
    EXPECT_EQ(kept.table.mean_cross_section, made.table.mean_cross_section);
    EXPECT_EQ(kept.table.report, made.table.report);
    EXPECT_EQ(kept.table.angles, made.table.angles);
}

TEST_F(TableCache, WithoutAFolderKeepsNothing) {
    EXPECT_FALSE(cached_scattering_table(request_, {}).from_cache);
    EXPECT_FALSE(cached_scattering_table(request_, {}).from_cache);
}

TEST_F(TableCache, KnowsBrokenAndForeignFiles) {
    const double right = get().table.phase[1].parallel;
    const std::string whole = read_file(file());
    std::string flipped = whole;
    flipped[whole.size() / 2] ^= 1;
    std::string foreign = whole;
    foreign[30] = foreign[30] == '0' ? '1' : '0';  // in the key
    for (const std::string& bytes :
         {std::string(), std::string("PNG"), whole.substr(0, 40), whole.substr(0, whole.size() - 1),
          whole + "x", flipped, foreign}) {
        write_file_atomically(file(), bytes);
        const CachedTable again = get();
        EXPECT_FALSE(again.from_cache);
        EXPECT_NE(again.note, "");
        EXPECT_EQ(again.table.phase[1].parallel, right);
        EXPECT_TRUE(get().from_cache);  // and is whole again
    }
}

TEST_F(TableCache, AFolderThatCannotBeWrittenIsANote) {
    write_file_atomically(folder_, "a file where the folder should be");
    const CachedTable made = get();
    EXPECT_FALSE(made.from_cache);
    EXPECT_NE(made.note, "");
    EXPECT_EQ(made.table.phase.size(), 6u);
}

TEST_F(TableCache, KeyDependsOnAllThatTheTableDependsOn) {
    std::set<std::string> keys = {cache_key(request_)};
    std::size_t count = 1;
    const auto differs = [&](const std::function<void(TableRequest&)>& change) {
        TableRequest other = request_;
        change(other);
        keys.insert(cache_key(other));
        EXPECT_EQ(keys.size(), ++count);
    };
    differs([](TableRequest& r) { r.model = "auto"; });
    differs([](TableRequest& r) { r.orders = {2}; });
    differs([](TableRequest& r) { r.orders = {2, 3}; });
    differs([](TableRequest& r) { r.tolerance = 0.01; });
    differs([](TableRequest& r) { r.sizes = single_drop_size(5.0000001 * um); });
    differs([](TableRequest& r) { r.sizes = parse_drop_sizes("gamma:mean=5um,width=20%"); });
    differs([](TableRequest& r) { r.optics.drop = air(); });
    differs([](TableRequest& r) { r.optics.around = air(); });
    differs([](TableRequest& r) { r.optics.extinction = 1e-9; });
    differs([](TableRequest& r) { r.wavelengths.pop_back(); });
    differs([](TableRequest& r) { r.angles[1] += 1e-9 * deg; });
    differs([](TableRequest& r) { r.disc.radius = Angle{}; });
    differs([](TableRequest& r) { r.disc.limb_darkening = 0.6; });
    differs([](TableRequest& r) { r.falling = FallingShape{}; });
    differs([](TableRequest& r) { r.falling = FallingShape{{}, {10.0 * deg, Angle{}}}; });
    differs([](TableRequest& r) { r.falling = FallingShape{{}, {Angle{}, 10.0 * deg}}; });
    differs([](TableRequest& r) { r.falling = FallingShape{{0.1, Angle{}}, {}}; });
}

TEST_F(TableCache, BadRequestsAreRefused) {
    request_.sizes = nullptr;
    EXPECT_THROW((void)get(), InputError);
}

}  // namespace
}  // namespace dewbow
