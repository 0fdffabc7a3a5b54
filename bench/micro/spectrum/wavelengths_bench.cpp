// SPDX-License-Identifier: Apache-2.0

// A packet of wavelengths, by the eye's sensitivity or evenly, and what it is as a colour.

#include "dewbow/spectrum/wavelengths.h"

#include "dewbow/spectrum/cie.h"
#include "numbers.h"

namespace dewbow::bench {
namespace {

constexpr std::size_t kCount = 256;

void sample(benchmark::State& state, WavelengthSampling sampling) {
    const std::vector<double> u = numbers(kCount, 0.0, 1.0);
    const int lanes = int(state.range(0));
    for (auto _ : state)
        for (const double at : u) benchmark::DoNotOptimize(sample_wavelengths(sampling, lanes, at));
    count_items(state, kCount);
}
BENCHMARK_CAPTURE(sample, visual, WavelengthSampling::visual)->Arg(1)->Arg(8)->Arg(16);
BENCHMARK_CAPTURE(sample, uniform, WavelengthSampling::uniform)->Arg(1)->Arg(8)->Arg(16);

void packet_to_xyz(benchmark::State& state) {
    std::vector<WavelengthPacket> packets;
    for (const double u : numbers(kCount, 0.0, 1.0))
        packets.push_back(sample_wavelengths(WavelengthSampling::visual, int(state.range(0)), u));
    const std::vector<double> radiance(kMaxLanes, 1.0);
    for (auto _ : state)
        for (const WavelengthPacket& packet : packets)
            benchmark::DoNotOptimize(
                xyz_from_lanes(packet, std::span(radiance).first(std::size_t(packet.count))));
    count_items(state, kCount);
}
BENCHMARK(packet_to_xyz)->Arg(1)->Arg(8)->Arg(16);

}  // namespace
}  // namespace dewbow::bench
