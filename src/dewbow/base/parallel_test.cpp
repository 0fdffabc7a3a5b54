// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace dewbow {
namespace {

/// Loops on a given number of threads, and on all of them again afterwards.
class Threads {
public:
    explicit Threads(int count) { set_thread_count(count); }
    ~Threads() { set_thread_count(0); }
};

TEST(Parallel, CountsThreads) {
    EXPECT_GE(hardware_threads(), 1);
    EXPECT_EQ(thread_count(), hardware_threads());
    const Threads threads(7);
    EXPECT_EQ(thread_count(), 7);
}

TEST(Parallel, EachIndexRunsOnce) {
    for (const int count : {1, 2, 8}) {
        const Threads threads(count);
        for (const std::size_t size : {0u, 1u, 2u, 3u, 1000u, 100'000u}) {
            std::vector<std::atomic<int>> runs(size);
            parallel_for(size, [&](std::size_t i) { ++runs[i]; });
            for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(runs[i], 1) << i;
        }
    }
}

TEST(Parallel, WhatTheBodyWroteIsThereAfterwards) {
    std::vector<std::size_t> squares(10'000);
    parallel_for(squares.size(), [&](std::size_t i) { squares[i] = i * i; });
    for (std::size_t i = 0; i < squares.size(); ++i) ASSERT_EQ(squares[i], i * i);
}

/// The ids of the threads that a loop of slow bodies ran on.
std::size_t threads_seen() {
    std::mutex mutex;
    std::set<std::thread::id> ids;
    parallel_for(64, [&](std::size_t) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const std::scoped_lock lock(mutex);
        ids.insert(std::this_thread::get_id());
    });
    return ids.size();
}

TEST(Parallel, UsesAsManyThreadsAsAsked) {
    {
        const Threads threads(1);
        EXPECT_EQ(threads_seen(), 1u);
    }
    // More than one thread even on one core, and never more than asked for.
    const Threads threads(4);
    const std::size_t seen = threads_seen();
    EXPECT_GT(seen, 1u);
    EXPECT_LE(seen, 4u);
}

TEST(Parallel, InnerLoopsWork) {
    const Threads threads(4);
    std::vector<std::atomic<int>> runs(32 * 32);
    parallel_for(
        32, [&](std::size_t i) { parallel_for(32, [&](std::size_t j) { ++runs[32 * i + j]; }); });
    for (const auto& run : runs) ASSERT_EQ(run, 1);
}

TEST(Parallel, WaitingForAnInnerLoopTakesUpNoOuterIteration) {
    const Threads threads(4);
    std::atomic<int> faults{0};
    parallel_for(64, [&](std::size_t) {
        thread_local int depth = 0;
        if (++depth > 1) ++faults;
        parallel_for(
            16, [](std::size_t) { std::this_thread::sleep_for(std::chrono::microseconds(100)); });
        --depth;
    });
    EXPECT_EQ(faults, 0);
}

#ifdef __SSE2__
double halved_smallest_normal() {
    volatile double smallest = std::numeric_limits<double>::min();
    return smallest * 0.5;
}
double doubled_denormal() {
    volatile double denormal = std::numeric_limits<double>::denorm_min();
    return denormal * 0x1p1000;
}

TEST(Parallel, DenormalsAreZeroInsideAndAsBeforeOutside) {
    ASSERT_NE(halved_smallest_normal(), 0.0);
    std::atomic<int> kept{0};
    parallel_for(1000, [&](std::size_t) {
        if (halved_smallest_normal() != 0.0 || doubled_denormal() != 0.0) ++kept;
    });
    EXPECT_EQ(kept, 0);
    EXPECT_NE(halved_smallest_normal(), 0.0);
    EXPECT_NE(doubled_denormal(), 0.0);
}
#endif

TEST(ParallelDeathTest, AnExceptionEndsTheProgram) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(parallel_for(4, [](std::size_t) { throw std::runtime_error("escaped"); }),
                testing::KilledBySignal(SIGABRT), "escaped");
    EXPECT_EXIT(set_thread_count(-1), testing::KilledBySignal(SIGABRT), "not negative");
}

}  // namespace
}  // namespace dewbow
