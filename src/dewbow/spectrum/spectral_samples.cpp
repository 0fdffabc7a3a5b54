// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/spectral_samples.h"

#include <cmath>
#include <utility>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"

namespace dewbow {
namespace {

/// Cells of the tailored distribution: 256 in each of the linear model's pieces, 0.14 nm of the
/// widest range. Within a cell the density is constant, which costs variance and no bias.
constexpr int kTailoredCells = 256 * kPaperSamples;

Distribution1D tailored_to(const SpectralModel& model) {
    std::vector<double> weights;
    for (int i = 0; i < kTailoredCells; ++i) {
        const MonitorRgb rgb = model.density((i + 0.5) / kTailoredCells);
        weights.push_back(std::abs(rgb[0]) + std::abs(rgb[1]) + std::abs(rgb[2]));
    }
    return Distribution1D(weights);
}

}  // namespace

const std::vector<std::string>& jitter_names() {
    static const std::vector<std::string> kNames{"none", "index", "colour", "both"};
    return kNames;
}

PreparedSpectralSampling::PreparedSpectralSampling(SpectralModelPtr model,
                                                   const SpectralSampling& sampling)
    : model_(std::move(model)), sampling_(sampling) {
    DEWBOW_CHECK(sampling.samples >= 1, "a set of samples has at least one");
    if (sampling.tailored) tailored_ = tailored_to(*model_);
    for (int k = 0; k < sampling.samples; ++k) {
        const Place middle = place(k, 0.5);
        fixed_.push_back({middle.f, middle.f, colour(middle)});
    }
    if (colours_move(sampling.jitter)) return;
    const MonitorRgb tint = raw_tint();
    for (std::size_t c = 0; c < 3; ++c) {
        if (!(tint[c] > 0.0))
            throw InputError(
                "spectral samples of fixed colour: " + std::to_string(sampling.samples) +
                " leave red, green or blue without light; expected more of them, or "
                "jitter of the colour");
        for (SpectralSample& sample : fixed_) sample.rgb[c] /= tint[c];
    }
}

std::size_t PreparedSpectralSampling::offset_count() const {
    if (sampling_.jitter == Jitter::none) return 0;
    return sampling_.correlated ? 1 : std::size_t(sampling_.samples);
}

MonitorRgb PreparedSpectralSampling::raw_tint() const {
    MonitorRgb sum;
    for (int k = 0; k < sampling_.samples; ++k) sum = sum + colour(place(k, 0.5));
    return sum;
}

PreparedSpectralSampling::Place PreparedSpectralSampling::place(int k, double u) const {
    const double quantile = (k + u) / sampling_.samples;
    if (!tailored_) return {quantile, 1.0};
    const Distribution1D::Sample at = tailored_->sample(quantile);
    return {(double(at.index) + at.offset) / kTailoredCells, at.pdf};
}

MonitorRgb PreparedSpectralSampling::colour(const Place& at) const {
    return model_->density(at.f) * (1.0 / (sampling_.samples * at.pdf));
}

SpectralSample PreparedSpectralSampling::sample(int k, double u) const {
    SpectralSample sample = fixed_[std::size_t(k)];
    if (sampling_.jitter == Jitter::none) return sample;
    const Place moved = place(k, u);
    if (sampling_.jitter != Jitter::colour) sample.f_index = moved.f;
    if (sampling_.jitter == Jitter::index) return sample;
    sample.f_colour = moved.f;
    sample.rgb = colour(moved);
    return sample;
}

void draw_spectral_samples(const PreparedSpectralSampling& prepared,
                           std::span<const double> offsets, std::span<SpectralSample> out) {
    DEWBOW_CHECK(offsets.size() == prepared.offset_count(), "0, 1 or N random numbers for a set");
    DEWBOW_CHECK(out.size() == std::size_t(prepared.sampling().samples), "a place a sample");
    for (std::size_t k = 0; k < out.size(); ++k) {
        const double u = offsets.empty() ? 0.5 : offsets[offsets.size() == 1 ? 0 : k];
        out[k] = prepared.sample(int(k), u);
    }
}

}  // namespace dewbow
