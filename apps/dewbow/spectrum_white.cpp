// SPDX-License-Identifier: Apache-2.0
#include "spectrum_white.h"

#include <algorithm>
#include <cmath>

#include "dewbow/base/random.h"

namespace dewbow {
namespace {

/// Sums of samples that are white but for rounding do not count as above 1.
constexpr double kRounding = 1e-12;

WhiteChannel channel_of(const std::vector<MonitorRgb>& sums, std::size_t c) {
    WhiteChannel channel;
    channel.least = channel.greatest = sums.front()[c];
    const double share = 1.0 / double(sums.size());
    for (const MonitorRgb& sum : sums) {
        channel.mean += share * sum[c];
        channel.clamped += share * std::min(1.0, sum[c]);
        channel.above_one += share * (sum[c] > 1.0 + kRounding);
        channel.least = std::min(channel.least, sum[c]);
        channel.greatest = std::max(channel.greatest, sum[c]);
    }
    double variance = 0.0;
    for (const MonitorRgb& sum : sums)
        variance += share * (sum[c] - channel.mean) * (sum[c] - channel.mean);
    channel.sd = std::sqrt(variance);
    return channel;
}

}  // namespace

SpectrumWhite measure_white(const SpectrumSetup& setup) {
    const SpectrumCommand& command = setup.command();
    const int sets = colours_move(command.sampling.jitter) ? command.sets : 1;
    const std::uint64_t stream = stream_key(command.seed, 0, 0);
    std::vector<double> offsets(setup.prepared().offset_count());
    std::vector<SpectralSample> samples(std::size_t(command.sampling.samples));
    SpectrumWhite white;
    for (int i = 0; i < sets; ++i) {
        if (command.sampling.correlated) {
            offsets[0] = (i + 0.5) / sets;
        } else {
            for (std::size_t k = 0; k < offsets.size(); ++k)
                offsets[k] =
                    SampleKey(stream, std::uint32_t(i)).one(std::uint32_t(k), Purpose::wavelength);
        }
        draw_spectral_samples(setup.prepared(), offsets, samples);
        MonitorRgb sum;
        for (const SpectralSample& sample : samples) sum = sum + sample.rgb;
        white.sums.push_back(sum);
        const double most = std::max({sum[0], sum[1], sum[2]});
        white.any_above_one += (most > 1.0 + kRounding) / double(sets);
    }
    for (std::size_t c = 0; c < 3; ++c) white.channels[c] = channel_of(white.sums, c);
    return white;
}

}  // namespace dewbow
