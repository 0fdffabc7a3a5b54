// SPDX-License-Identifier: Apache-2.0
#include "spectrum_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/spectrum/display.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

/// Steps in which the brightest colour is looked for.
constexpr int kSteps = 2000;

PreparedSpectralSampling prepare(const SpectrumCommand& command) {
    try {
        return {make_spectral_model(command.model), command.sampling};
    } catch (const InputError& error) {
        throw UsageError("--samples: " + error.sentence(), error.hint());
    }
}

}  // namespace

SpectrumSetup::SpectrumSetup(const SpectrumCommand& command)
    : command_(command), prepared_(prepare(command)) {
    double most = 0.0;
    for (const double f : steps(kSteps))
        for (const double channel : screen(f)) most = std::max(most, channel);
    brightest_ = most;
}

PlotAxis SpectrumSetup::axis() const {
    if (!over_wavelength()) return {"spectral coordinate f, from red to violet", 0.0, 1.0};
    return {"vacuum wavelength λ (nm)", place(1.0), place(0.0)};
}

double SpectrumSetup::place(double f) const {
    return over_wavelength() ? model().wavelength(f).to(unit::nm) : f;
}

MonitorRgb SpectrumSetup::height(double f) const {
    if (!over_wavelength()) return {linear_spectrum_colour(f).v};
    return model().density(f) * (1.0 / model().nm_per_f(f));
}

std::vector<double> SpectrumSetup::steps(int count) const {
    std::vector<double> all;
    for (int i = 0; i <= count; ++i) {
        const double share = double(i) / count;
        if (!over_wavelength()) {
            all.push_back(share);
            continue;
        }
        const double lambda_nm = place(1.0) + share * (place(0.0) - place(1.0));
        all.push_back(std::clamp(model().coordinate(lambda_nm * unit::nm), 0.0, 1.0));
    }
    return all;
}

std::array<double, 3> SpectrumSetup::screen(double f) const {
    const auto rgb =
        map_gamut(rgb_from_xyz<LinearSrgb>(model().xyz(height(f))), GamutMapping::clip);
    return rgb.v;
}

std::array<std::uint8_t, 3> SpectrumSetup::shown(double f) const {
    std::array<std::uint8_t, 3> codes{};
    const auto linear = screen(f);
    for (std::size_t c = 0; c < 3; ++c) {
        const double value = std::min(1.0, linear[c] / brightest_);
        const double encoded =
            command_.gamma ? std::pow(value, 1.0 / *command_.gamma) : srgb_encode(value);
        codes[c] = std::uint8_t(std::lround(255.0 * encoded));
    }
    return codes;
}

std::string SpectrumSetup::title() const {
    const SpectralModelSettings& m = command_.model;
    std::string text = spectral_colours_names()[std::size_t(m.colours)] + " spectrum, " + m.monitor;
    if (m.colours == SpectralColours::empirical)
        text += ", " + negative_colours_names()[std::size_t(m.negative)];
    return text;
}

std::string SpectrumSetup::sampling_title() const {
    const SpectralSampling& s = command_.sampling;
    std::string text = fmt::format("{} samples{}", s.samples, s.tailored ? ", tailored" : "");
    if (s.jitter == Jitter::none) return text + ", fixed";
    text += ", jitter of " +
            (s.jitter == Jitter::both ? "index and colour" : jitter_names()[std::size_t(s.jitter)]);
    return text + (s.correlated ? ", correlated" : ", independent");
}

}  // namespace dewbow
