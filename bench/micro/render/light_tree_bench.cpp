// SPDX-License-Identifier: Apache-2.0

// The choice of one lamp of many by the light tree, by the number of lamps, against a choice by
// their power alone.

#include "dewbow/render/light_tree.h"

#include "dewbow/math/distribution.h"
#include "numbers.h"

namespace dewbow::bench {
namespace {

constexpr std::size_t kCount = 512;

std::vector<LightBounds> lamps(std::size_t count) {
    const auto x = numbers(count, -20.0, 20.0, 0), z = numbers(count, -20.0, 20.0, 1);
    const auto intensity = numbers(count, 1.0, 20.0, 2);
    std::vector<LightBounds> all;
    for (std::size_t i = 0; i < count; ++i) {
        LightBounds lamp;
        lamp.box.add({x[i], 4.0, z[i]});
        lamp.intensity = intensity[i];
        lamp.normals = DirectionCone::all();
        all.push_back(lamp);
    }
    return all;
}

void by_tree(benchmark::State& state) {
    const LightTree tree(lamps(std::size_t(state.range(0))));
    const auto x = numbers(kCount, -20.0, 20.0, 3), u = numbers(kCount, 0.0, 1.0, 4);
    for (auto _ : state)
        for (std::size_t i = 0; i < kCount; ++i)
            benchmark::DoNotOptimize(tree.sample({{x[i], 0.0, 1.0}, {0.0, 1.0, 0.0}}, u[i]));
    count_items(state, kCount);
}
BENCHMARK(by_tree)->RangeMultiplier(10)->Range(10, 10000);

void by_power(benchmark::State& state) {
    std::vector<double> power;
    for (const LightBounds& lamp : lamps(std::size_t(state.range(0))))
        power.push_back(lamp.intensity);
    const Distribution1D distribution(power);
    const auto u = numbers(kCount, 0.0, 1.0, 4);
    for (auto _ : state)
        for (const double at : u) benchmark::DoNotOptimize(distribution.sample(at));
    count_items(state, kCount);
}
BENCHMARK(by_power)->RangeMultiplier(10)->Range(10, 10000);

}  // namespace
}  // namespace dewbow::bench
