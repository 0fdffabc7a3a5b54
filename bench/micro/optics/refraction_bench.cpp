// SPDX-License-Identifier: Apache-2.0

// Fresnel's reflectances and Snell's angle, one at a time, in double and in float.

#include "dewbow/optics/refraction.h"

#include "numbers.h"

namespace dewbow::bench {
namespace {

constexpr std::size_t kCount = 1024;

template <class T>
void fresnel(benchmark::State& state) {
    const std::vector<double> cosines = numbers(kCount, 0.0, 1.0);
    const std::vector<T> at(cosines.begin(), cosines.end());
    for (auto _ : state)
        for (const T cos_i : at)
            benchmark::DoNotOptimize(fresnel_dielectric(cos_i, T(1.5)).unpolarised());
    count_items(state, kCount);
}
BENCHMARK(fresnel<double>);
BENCHMARK(fresnel<float>);

void snell_by_angle(benchmark::State& state) {
    const std::vector<double> angles = numbers(kCount, 0.0, 90.0);
    for (auto _ : state)
        for (const double deg : angles)
            benchmark::DoNotOptimize(refraction_angle(deg * unit::deg, {1.5}));
    count_items(state, kCount);
}
BENCHMARK(snell_by_angle);

}  // namespace
}  // namespace dewbow::bench
