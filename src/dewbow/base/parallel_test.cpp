// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <limits>
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

/// Largest number of bodies that ran at once, in a loop whose bodies wait for `wanted` of them.
int bodies_at_once(int wanted) {
    constexpr std::chrono::seconds kPatience{5};
    const auto start = std::chrono::steady_clock::now();
    std::atomic<int> inside{0}, most{0};
    parallel_for(static_cast<std::size_t>(wanted), [&](std::size_t) {
        const int now = ++inside;
        for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
        }
        while (most < wanted && std::chrono::steady_clock::now() - start < kPatience)
            std::this_thread::yield();
        --inside;
    });
    return most;
}

TEST(Parallel, UsesAsManyThreadsAsAsked) {
    // Also more than the machine has: pictures must not depend on it, and tests must be able to see
    // that.
    for (const int count : {1, 2, hardware_threads() + 2}) {
        const Threads threads(count);
        EXPECT_EQ(bodies_at_once(count), count);
    }
}

TEST(Parallel, UsesNoMoreThreadsThanAsked) {
    const Threads threads(2);
    std::atomic<int> inside{0}, most{0};
    parallel_for(64, [&](std::size_t) {
        const int now = ++inside;
        for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        --inside;
    });
    EXPECT_LE(most, 2);
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
    // One thread only: of two that end the program at once neither says what escaped.
    const auto body = [](std::size_t i) {
        if (i == 2) throw std::runtime_error("escaped");
    };
    EXPECT_EXIT(parallel_for(4, body), testing::KilledBySignal(SIGABRT), "escaped");
    EXPECT_EXIT(set_thread_count(-1), testing::KilledBySignal(SIGABRT), "not negative");
}

}  // namespace
}  // namespace dewbow
