// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "dewbow/base/check.h"

#ifdef __linux__
#include <sched.h>
#endif
#ifdef __SSE2__
#include <xmmintrin.h>
#endif
#ifndef DEWBOW_PARALLEL_JTHREAD
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif

namespace dewbow {

namespace {

using Body = std::function<void(std::size_t)>;

/// While it lives, denormal results and operands of this thread are zero: they cost a hundred
/// cycles each and mean nothing to a renderer.
class FlushDenormals {
public:
#ifdef __SSE2__
    FlushDenormals() : saved_(_mm_getcsr()) {
        _mm_setcsr(saved_ | kFlushToZero | kDenormalsAreZero);
    }
    ~FlushDenormals() { _mm_setcsr(saved_); }

private:
    // Bits of MXCSR: Intel SDM vol. 1, §10.2.3.
    static constexpr unsigned kFlushToZero = 1u << 15;
    static constexpr unsigned kDenormalsAreZero = 1u << 6;
    const unsigned saved_;
#else
    FlushDenormals() {}
    ~FlushDenormals() {}
#endif
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;
};

/// An exception that leaves `body` must not unwind half a loop: noexcept ends the program instead.
void run_range(const Body& body, std::size_t begin, std::size_t end) noexcept {
    const FlushDenormals flush;
    for (std::size_t i = begin; i < end; ++i) body(i);
}

/// 0: all.
std::atomic<int> requested_threads{0};

}  // namespace

int hardware_threads() {
#ifdef __linux__
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0)
        return std::max(1, CPU_COUNT(&allowed));
#endif
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int thread_count() {
    const int requested = requested_threads.load();
    return requested > 0 ? requested : hardware_threads();
}

#ifndef DEWBOW_PARALLEL_JTHREAD

namespace {

// Indices are handed out one by one, because tiles cost very different times; only a loop of very
// many indices hands out small runs of them.
constexpr std::size_t kMostTasksPerThread = 1024;

}  // namespace

void set_thread_count(int threads) {
    DEWBOW_CHECK(threads >= 0, "a number of threads is not negative");
    // The control also binds libraries that use oneTBB themselves (Embree builds its trees with
    // it).
    static std::unique_ptr<tbb::global_control> control;
    requested_threads = threads;
    control.reset();
    control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<std::size_t>(thread_count()));
}

void parallel_for(std::size_t count, const Body& body) {
    if (count == 0) return;
    const auto threads = static_cast<std::size_t>(thread_count());
    const std::size_t grain = std::max<std::size_t>(1, count / (kMostTasksPerThread * threads));
    // An arena for this loop alone: the default one never has more threads than the machine, and a
    // thread that waits in an inner loop's arena does not take up an iteration of the outer loop.
    tbb::task_arena arena(static_cast<int>(threads));
    arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, grain),
            [&](const tbb::blocked_range<std::size_t>& range) {
                run_range(body, range.begin(), range.end());
            },
            tbb::simple_partitioner());
    });
}

bool parallel_backend_is_jthread() { return false; }

#else

void set_thread_count(int threads) {
    DEWBOW_CHECK(threads >= 0, "a number of threads is not negative");
    requested_threads = threads;
}

void parallel_for(std::size_t count, const Body& body) {
    // An inner loop runs on the thread that reaches it: the outer one keeps the others busy.
    thread_local bool inside_loop = false;
    const std::size_t threads =
        inside_loop ? 1 : std::min(count, static_cast<std::size_t>(thread_count()));
    std::atomic<std::size_t> next{0};
    const auto work = [&]() noexcept {
        const bool was_inside = inside_loop;
        inside_loop = true;
        for (std::size_t i = next++; i < count; i = next++) run_range(body, i, i + 1);
        inside_loop = was_inside;
    };
    std::vector<std::jthread>
        others;  // joined, and so synchronised with, when it goes out of scope
    for (std::size_t t = 1; t < threads; ++t) others.emplace_back(work);
    work();
}

bool parallel_backend_is_jthread() { return true; }

#endif

}  // namespace dewbow
