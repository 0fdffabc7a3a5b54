// SPDX-License-Identifier: Apache-2.0
#pragma once

// Parallel loops. oneTBB stands behind them, or std::jthread in builds for the thread sanitizer.

#include <cstddef>
#include <functional>

namespace dewbow {

/// Number of hardware threads that this process may use, at least 1.
int hardware_threads();

/// Limits the threads that parallel loops use from now on; 0 = all. Call it once, before the first
/// loop.
void set_thread_count(int threads);
int thread_count();

/// Calls body(i) for i in [0, count), each once, in any order and on any thread. Every worker runs
/// with denormals flushed to zero. `body` must not throw: an exception that escapes it ends the
/// program.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// True in the build whose loops run on std::jthread.
bool parallel_backend_is_jthread();

}  // namespace dewbow
