// SPDX-License-Identifier: Apache-2.0

// A place by tabulated weights, by the number of weights, against the search alone.

#include "dewbow/math/distribution.h"

#include <algorithm>

#include "numbers.h"

namespace dewbow::bench {
namespace {

constexpr std::size_t kCount = 1024;

void sample_distribution(benchmark::State& state) {
    const Distribution1D distribution(numbers(std::size_t(state.range(0)), 0.0, 1.0));
    const std::vector<double> u = numbers(kCount, 0.0, 1.0, 1);
    for (auto _ : state)
        for (const double at : u) benchmark::DoNotOptimize(distribution.sample(at));
    count_items(state, kCount);
}
BENCHMARK(sample_distribution)->RangeMultiplier(32)->Range(32, 1 << 20);

void search_alone(benchmark::State& state) {
    std::vector<double> sorted = numbers(std::size_t(state.range(0)), 0.0, 1.0);
    std::sort(sorted.begin(), sorted.end());
    const std::vector<double> u = numbers(kCount, 0.0, 1.0, 1);
    for (auto _ : state)
        for (const double at : u)
            benchmark::DoNotOptimize(std::upper_bound(sorted.begin(), sorted.end(), at));
    count_items(state, kCount);
}
BENCHMARK(search_alone)->RangeMultiplier(32)->Range(32, 1 << 20);

}  // namespace
}  // namespace dewbow::bench
