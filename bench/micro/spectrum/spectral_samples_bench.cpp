// SPDX-License-Identifier: Apache-2.0

// The paper's set of 13 coloured samples: fixed, jittered, with one offset for all. "The cost of
// jittering is reduced to one floating point multiplication […] and the cost of interpolating the
// color of the final sample." [Musgrave 1989, 4.1]

#include "dewbow/spectrum/spectral_samples.h"

#include "numbers.h"

namespace dewbow::bench {
namespace {

void draw(benchmark::State& state, SpectralColours colours, Jitter jitter, bool correlated) {
    SpectralModelSettings settings;
    settings.colours = colours;
    SpectralSampling sampling;
    sampling.jitter = jitter;
    sampling.correlated = correlated;
    const PreparedSpectralSampling prepared(make_spectral_model(settings), sampling);
    const std::vector<double> offsets = numbers(prepared.offset_count(), 0.0, 1.0);
    std::vector<SpectralSample> samples(std::size_t(sampling.samples));
    for (auto _ : state) {
        draw_spectral_samples(prepared, offsets, samples);
        benchmark::DoNotOptimize(samples.data());
        benchmark::ClobberMemory();
    }
    count_items(state, samples.size());
}
BENCHMARK_CAPTURE(draw, fixed, SpectralColours::linear, Jitter::none, false);
BENCHMARK_CAPTURE(draw, index, SpectralColours::linear, Jitter::index, false);
BENCHMARK_CAPTURE(draw, both, SpectralColours::linear, Jitter::both, false);
BENCHMARK_CAPTURE(draw, both_correlated, SpectralColours::linear, Jitter::both, true);
BENCHMARK_CAPTURE(draw, both_empirical, SpectralColours::empirical, Jitter::both, false);
BENCHMARK_CAPTURE(draw, both_cie, SpectralColours::cie, Jitter::both, false);

}  // namespace
}  // namespace dewbow::bench
