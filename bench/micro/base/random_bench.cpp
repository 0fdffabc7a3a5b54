// SPDX-License-Identifier: Apache-2.0

// Two random numbers by key, stratified and without memory, against two of a generator with a
// state.

#include <benchmark/benchmark.h>

#include <random>

#include "dewbow/base/random.h"

namespace dewbow::bench {
namespace {

void two_by_key(benchmark::State& state) {
    std::uint32_t index = 0;
    for (auto _ : state) {
        const SampleKey key(stream_key(0, 3, 5), index++);
        benchmark::DoNotOptimize(key.two(2, Purpose::test));
    }
}
BENCHMARK(two_by_key);

void two_by_mersenne_twister(benchmark::State& state) {
    std::mt19937_64 generator;
    std::uniform_real_distribution<double> uniform;
    for (auto _ : state) {
        benchmark::DoNotOptimize(uniform(generator));
        benchmark::DoNotOptimize(uniform(generator));
    }
}
BENCHMARK(two_by_mersenne_twister);

}  // namespace
}  // namespace dewbow::bench
