// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/check.h"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

namespace dewbow {
namespace {

TEST(Check, PassesInSilence) {
    const int triangles = 1;
    DEWBOW_CHECK(triangles > 0, "a mesh has at least one triangle");
}

TEST(CheckDeathTest, NamesConditionPlaceAndReplay) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const int triangles = 0;
    EXPECT_EXIT(DEWBOW_CHECK(triangles > 0, "a mesh has at least one triangle"),
                testing::KilledBySignal(SIGABRT),
                "check_test.cpp:[0-9]+: check failed: a mesh has at least one triangle "
                ".triangles > 0.");
    const auto fail_in_a_sample = [] {
        set_replay_command("dewbow render scene.toml");
        replay_context() = {12, 7, 3, 5};
        DEWBOW_CHECK(false, "a mesh has at least one triangle");
    };
    EXPECT_EXIT(fail_in_a_sample(), testing::KilledBySignal(SIGABRT),
                "replay with: dewbow render scene.toml --pixel 12,7 --sample 3 --seed 5");
}

TEST(Describe, SaysWhatRepeatsTheSample) {
    set_replay_command("");
    EXPECT_EQ(describe({}), "");
    EXPECT_EQ(describe({12, 7, 3, 0}), "pixel 12,7 sample 3 seed 0");
    set_replay_command("dewbow render scene.toml");
    EXPECT_EQ(describe({12, 7, 3, 0}),
              "pixel 12,7 sample 3 seed 0; replay with: dewbow render scene.toml --pixel 12,7 "
              "--sample 3 --seed 0");
    EXPECT_EQ(describe({12, 7, -1, 0}),
              "pixel 12,7 seed 0; replay with: dewbow render scene.toml --pixel 12,7 --seed 0");
    set_replay_command("");
}

TEST(ReplayContextTest, EachThreadHasItsOwn) {
    replay_context() = {1, 2, 3, 4};
    std::thread([] {
        EXPECT_EQ(replay_context().pixel_x, -1);
        replay_context().pixel_x = 99;
    }).join();
    EXPECT_EQ(replay_context().pixel_x, 1);
    replay_context() = {};
}

}  // namespace
}  // namespace dewbow
