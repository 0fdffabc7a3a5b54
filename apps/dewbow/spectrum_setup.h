// SPDX-License-Identifier: Apache-2.0
#pragma once

// The model and the samples that `dewbow spectrum` was asked for, as its plots and files show them.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "dewbow/export/plot.h"
#include "spectrum_command.h"

namespace dewbow {

class SpectrumSetup {
public:
    /// Throws UsageError for samples that cannot be made white.
    explicit SpectrumSetup(const SpectrumCommand& command);

    const SpectrumCommand& command() const { return command_; }
    const SpectralModel& model() const { return prepared_.model(); }
    const PreparedSpectralSampling& prepared() const { return prepared_; }

    /// Linear colours are shown over f, as numbers for the monitor from 0 to 1; the others over the
    /// wavelength, as shares of white per nm.
    bool over_wavelength() const { return command_.model.colours != SpectralColours::linear; }
    PlotAxis axis() const;
    double place(double f) const;
    MonitorRgb height(double f) const;
    /// f at even steps along the axis, from its left to its right.
    std::vector<double> steps(int count) const;

    /// As an sRGB screen shows `height(f)` on the monitor, the brightest of all at full strength;
    /// what the screen does not have is clipped.
    std::array<std::uint8_t, 3> shown(double f) const;

    /// "empirical, rogers, clamp": the curves in a few words.
    std::string title() const;
    /// "13 samples, jitter both, correlated"
    std::string sampling_title() const;

private:
    std::array<double, 3> screen(double f) const;

    SpectrumCommand command_;
    PreparedSpectralSampling prepared_;
    double brightest_ = 1.0;
};

}  // namespace dewbow
