// SPDX-License-Identifier: Apache-2.0
#pragma once

// Arguments for the programs of bench/micro, the same in each run.

#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

#include "dewbow/base/random.h"

namespace dewbow::bench {

/// `count` numbers in [low, high), in no order.
inline std::vector<double> numbers(std::size_t count, double low, double high,
                                   std::uint32_t which = 0) {
    std::vector<double> all;
    for (std::size_t i = 0; i < count; ++i) {
        const SampleKey key(stream_key(1, std::uint32_t(i), which), 0);
        all.push_back(low + (high - low) * key.one(0, Purpose::test));
    }
    return all;
}

/// States what was done `each` times in every round, so that rates are a second's of one.
inline void count_items(benchmark::State& state, std::size_t each) {
    state.SetItemsProcessed(std::int64_t(state.iterations()) * std::int64_t(each));
}

}  // namespace dewbow::bench
