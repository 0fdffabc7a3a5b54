// SPDX-License-Identifier: Apache-2.0

// The index at a packet's wavelengths: the paper's straight line, which is "in general quicker to
// evaluate" [Musgrave 1989, 4.1], against real media; and its multiplication and addition alone.

#include "dewbow/optics/catalogue.h"
#include "dewbow/optics/paper_index.h"
#include "numbers.h"

namespace dewbow::bench {
namespace {

constexpr std::size_t kLanes = 8, kPackets = 128;

void index_of_packets(benchmark::State& state, const DispersionPtr& dispersion) {
    const std::vector<double> lambda_nm = numbers(kLanes * kPackets, 380.0, 800.0);
    std::vector<double> n(kLanes);
    for (auto _ : state)
        for (std::size_t i = 0; i < lambda_nm.size(); i += kLanes) {
            dispersion->eval_lanes(std::span(lambda_nm).subspan(i, kLanes), n);
            benchmark::DoNotOptimize(n.data());
            benchmark::ClobberMemory();
        }
    count_items(state, lambda_nm.size());
}
void glass(benchmark::State& state, const char* name) {
    index_of_packets(state, make_dispersion(find_glass(name).data));
}
void formula(benchmark::State& state, const DispersionData& data) {
    index_of_packets(state, make_dispersion(data));
}
BENCHMARK_CAPTURE(formula, constant, {"constant", {1.5}, IndexReference::vacuum});
BENCHMARK_CAPTURE(formula, cauchy_in_vacuum, {"cauchy", {1.5, 0.004}, IndexReference::vacuum});
BENCHMARK_CAPTURE(formula, cauchy_in_air, {"cauchy", {1.5, 0.004}, IndexReference::air});
BENCHMARK_CAPTURE(formula, sellmeier_in_vacuum,
                  {"sellmeier",
                   {1.03961212, 0.00600069867, 0.231792344, 0.0200179144, 1.01046945, 103.560653},
                   IndexReference::vacuum});
BENCHMARK_CAPTURE(glass, n_bk7, "schott/N-BK7");
BENCHMARK_CAPTURE(glass, water, "water");

void paper(benchmark::State& state) {
    index_of_packets(state, paper_index(1.5, 0.02, IndexReading::intended));
}
BENCHMARK(paper);

/// What 1989 had to do: f is known, and air has no index.
void paper_line_alone(benchmark::State& state) {
    const std::vector<double> f = numbers(kLanes * kPackets, 0.0, 1.0);
    const LinearIndex line = linear_index(1.5, 0.02, IndexReading::intended);
    std::vector<double> n(kLanes);
    for (auto _ : state)
        for (std::size_t i = 0; i < f.size(); i += kLanes) {
            for (std::size_t k = 0; k < kLanes; ++k) n[k] = line.at(f[i + k]);
            benchmark::DoNotOptimize(n.data());
            benchmark::ClobberMemory();
        }
    count_items(state, f.size());
}
BENCHMARK(paper_line_alone);

}  // namespace
}  // namespace dewbow::bench
