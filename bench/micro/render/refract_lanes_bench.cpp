// SPDX-License-Identifier: Apache-2.0

// Lanes at a smooth boundary: one SIMD call for a packet, against a call for each lane.

#include "dewbow/render/refract_lanes.h"

#include "numbers.h"

namespace dewbow::bench {
namespace {

constexpr std::size_t kBoundaries = 256;

struct Boundary {
    RayLanes rays;
    BoundaryLanes lanes;
};

std::vector<Boundary> boundaries(int count) {
    const std::vector<double> sines = numbers(kBoundaries, 0.0, 0.99);
    std::vector<Boundary> all(kBoundaries);
    for (std::size_t i = 0; i < kBoundaries; ++i) {
        Boundary& at = all[i];
        at.rays.count = count;
        for (int k = 0; k < count; ++k) {
            const double s = sines[i];
            at.rays.set(k, {{}, {s, 0.0, -std::sqrt(1.0 - s * s)}, {}});
            at.lanes.nx[k] = 0.0, at.lanes.ny[k] = 0.0, at.lanes.nz[k] = 1.0;
            at.lanes.eta[k] = 1.7 + 0.01 * k;
        }
    }
    return all;
}

void together(benchmark::State& state) {
    const int count = int(state.range(0));
    std::vector<Boundary> all = boundaries(count);
    for (auto _ : state)
        for (Boundary& at : all) {
            refract_or_reflect_lanes(count, 0.3, at.rays, at.lanes);
            benchmark::DoNotOptimize(at.lanes);
        }
    count_items(state, kBoundaries * std::size_t(count));
}
BENCHMARK(together)->Arg(1)->Arg(4)->Arg(8)->Arg(16);

}  // namespace
}  // namespace dewbow::bench
