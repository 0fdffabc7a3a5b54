// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/farm/dealer.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dewbow {
namespace {

void finish(const Lease& lease, UnitPlan& plan, Dealer& dealer) {
    for (const UnitRun& run : lease.runs)
        for (std::size_t pass = run.first_pass; pass < run.end_pass; ++pass)
            plan.set_finished(pass, run.number);  // checks that no unit is finished twice
    dealer.close(lease.number);
}

constexpr PixelRect kPicture{0, 0, 70, 40};  // 15 tiles

TEST(Dealer, DealsEveryOpenUnitOnce) {
    UnitPlan plan(kPicture, 130);
    for (const std::size_t pass : {0u, 5u, 6u, 32u}) plan.set_finished(pass, pass % plan.tiles());
    Dealer dealer(plan);
    dealer.join(0, 2);
    dealer.join(1, 3);
    for (int turn = 0; const auto lease = dealer.deal(turn % 2, 0.0); ++turn)
        finish(*lease, plan, dealer);
    EXPECT_EQ(plan.finished_units(), plan.units());
    EXPECT_EQ(dealer.dealt_again(), 0u);
}

TEST(Dealer, DealsLightUnitsOneByOne) {
    UnitPlan plan(kPicture, 130, kTileSide, 5000.0);  // 15 tiles and 3 light units
    ASSERT_EQ(plan.light_units(), 3u);
    for (const std::size_t pass : {0u, 5u, 6u, 32u}) plan.set_finished(pass, 15 + pass % 3);
    Dealer dealer(plan);
    dealer.join(0, 2);
    dealer.join(1, 3);
    for (int turn = 0; const auto lease = dealer.deal(turn % 2, 0.0); ++turn) {
        for (const UnitRun& run : lease->runs)
            EXPECT_TRUE(!plan.is_light(run.number) || run.units() == 1);
        finish(*lease, plan, dealer);
    }
    EXPECT_EQ(plan.finished_units(), plan.units());
    EXPECT_EQ(dealer.dealt_again(), 0u);
}

TEST(Dealer, SendsManyPassesOfATileAsOne) {
    UnitPlan plan(kPicture, 4096);  // 1024 passes of 15 tiles
    Dealer dealer(plan);
    dealer.join(0, 1);
    std::size_t tiles_sent = 0;
    while (const auto lease = dealer.deal(0, 0.0)) {
        tiles_sent += lease->runs.size();
        finish(*lease, plan, dealer);
    }
    // Blocks of 1, 1, 2, 4 … 256 and what is left; as many again for the shrinking ones at the end.
    constexpr std::size_t kMostBlocks = 2 * 11;
    EXPECT_LE(tiles_sent, kMostBlocks * plan.tiles());
    EXPECT_EQ(plan.finished_units(), plan.units());
}

TEST(Dealer, EndsWithSmallLeases) {
    UnitPlan plan(kPicture, 4096);
    Dealer dealer(plan);
    for (int rank = 0; rank < 8; ++rank) dealer.join(rank, 4);
    std::uint64_t last = 0;
    while (const auto lease = dealer.deal(3, 0.0)) {
        last = lease->runs.front().units();
        finish(*lease, plan, dealer);
    }
    EXPECT_EQ(last, 1u);
}

TEST(Dealer, DealsToNobodyWhoHasNotJoined) {
    const UnitPlan plan(kPicture, 4);
    Dealer dealer(plan);
    dealer.join(0, 1);
    EXPECT_FALSE(dealer.deal(1, 0.0));
}

TEST(Dealer, DealsNoPassBeyondTheLimit) {
    UnitPlan plan(kPicture, 12);
    Dealer dealer(plan);
    dealer.join(0, 64);
    dealer.limit_passes(1);
    while (const auto lease = dealer.deal(0, 0.0)) finish(*lease, plan, dealer);
    EXPECT_EQ(plan.finished_units(), plan.tiles());
    dealer.limit_passes(3);
    while (const auto lease = dealer.deal(0, 0.0)) finish(*lease, plan, dealer);
    EXPECT_EQ(plan.finished_units(), plan.units());
}

TEST(Dealer, DealsAgainWhatDoesNotComeBackTheOldestFirst) {
    UnitPlan plan(kPicture, 4);
    Dealer dealer(plan);
    dealer.join(0, 1);
    dealer.join(1, 1);
    const auto lost = dealer.deal(1, 0.0);
    ASSERT_TRUE(lost);
    while (const auto lease = dealer.deal(0, 0.0)) {
        if (dealer.dealt_again() > 0) {
            EXPECT_EQ(lease, lost);
        }
        finish(*lease, plan, dealer);
    }
    EXPECT_EQ(dealer.dealt_again(), 1u);
    EXPECT_EQ(plan.finished_units(), plan.units());
    EXPECT_EQ(dealer.out(lost->number), nullptr);
}

TEST(Dealer, DealsToAThirdRankOnlyAfterAWhile) {
    const UnitPlan plan({0, 0, 16, 16}, 4);  // one unit
    Dealer dealer(plan);
    for (int rank = 0; rank < 4; ++rank) dealer.join(rank, 1);
    EXPECT_TRUE(dealer.deal(0, 0.0));
    EXPECT_FALSE(dealer.deal(0, 100.0)) << "it has the unit already";
    EXPECT_TRUE(dealer.deal(1, 100.0));
    EXPECT_FALSE(dealer.deal(2, 100.0));
    EXPECT_TRUE(dealer.deal(2, 110.0));
    EXPECT_FALSE(dealer.deal(3, 110.0));
}

}  // namespace
}  // namespace dewbow
