// SPDX-License-Identifier: Apache-2.0

// A sample into the film's sums of integers, against the same sums in floating point, whose last
// bits depend on the order.

#include "dewbow/render/film.h"

#include "dewbow/spectrum/cie.h"
#include "numbers.h"

namespace dewbow::bench {
namespace {

constexpr int kSize = 64;
constexpr std::size_t kSamples = 256;

std::vector<PixelSample> samples() {
    std::vector<PixelSample> all;
    for (const double u : numbers(kSamples, 0.0, 1.0)) {
        PixelSample sample;
        sample.wavelengths = sample_wavelengths(WavelengthSampling::visual, 8, u);
        sample.radiance.fill(0.7);
        sample.hit = true, sample.depth = 2.0, sample.normal = {0.0, 0.0, 1.0};
        all.push_back(sample);
    }
    return all;
}

void film_add(benchmark::State& state) {
    const std::vector<PixelSample> all = samples();
    FilmSums film(kSize, kSize, {0, 0, kSize, kSize}, int(state.range(0)), 1.0);
    for (auto _ : state)
        for (std::size_t i = 0; i < all.size(); ++i)
            film.add(int(i % kSize), int(i / kSize), all[i], std::int64_t(i));
    count_items(state, kSamples);
}
BENCHMARK(film_add)->Arg(0)->Arg(30);

void add_in_floating_point(benchmark::State& state) {
    const std::vector<PixelSample> all = samples();
    std::vector<std::array<double, 12>> sums(kSize * kSize);
    for (auto _ : state)
        for (std::size_t i = 0; i < all.size(); ++i) {
            const PixelSample& s = all[i];
            const Colour<Xyz> c = xyz_from_lanes(s.wavelengths, std::span(s.radiance).first(8));
            const double terms[] = {c[0],        c[1],        c[2],        c[1] * c[1],
                                    s.albedo[0], s.albedo[1], s.albedo[2], s.normal.x,
                                    s.normal.y,  s.normal.z,  s.depth,     1.0};
            for (std::size_t k = 0; k < 12; ++k) sums[i][k] += terms[k];
            benchmark::DoNotOptimize(sums[i]);
        }
    count_items(state, kSamples);
}
BENCHMARK(add_in_floating_point);

}  // namespace
}  // namespace dewbow::bench
