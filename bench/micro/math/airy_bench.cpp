// SPDX-License-Identifier: Apache-2.0

// Ai and Ai': the function itself, and the table that rainbows use.

#include "dewbow/math/airy.h"

#include "numbers.h"

namespace dewbow::bench {
namespace {

constexpr std::size_t kCount = 1024;
constexpr double kFrom = -200.0, kTo = 8.0;

void airy_function(benchmark::State& state) {
    const std::vector<double> x = numbers(kCount, kFrom, kTo);
    for (auto _ : state)
        for (const double at : x) benchmark::DoNotOptimize(airy(at));
    count_items(state, kCount);
}
BENCHMARK(airy_function);

void airy_table(benchmark::State& state) {
    const std::vector<double> x = numbers(kCount, kFrom, kTo);
    const AiryTable& table = AiryTable::instance();
    for (auto _ : state)
        for (const double at : x) benchmark::DoNotOptimize(table.inside(at));
    count_items(state, kCount);
}
BENCHMARK(airy_table);

}  // namespace
}  // namespace dewbow::bench
