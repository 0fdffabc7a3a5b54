// SPDX-License-Identifier: Apache-2.0
#pragma once

// What `dewbow spectrum` is asked for, as plain values.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dewbow/spectrum/spectral_samples.h"
#include "plot_request.h"

namespace dewbow {

struct SpectrumCommand {
    SpectralModelSettings model;
    SpectralSampling sampling;
    int sets = 16384;  ///< of samples, whose sums are measured
    std::uint64_t seed = 0;
    std::optional<double> gamma;  ///< of the display; without it sRGB's curve
    std::vector<std::string> outputs;
    std::vector<PlotRequest> plots;
    bool quiet = false, json = false;
};

/// Returns the program's exit code.
int run(const SpectrumCommand& command);

}  // namespace dewbow
