// SPDX-License-Identifier: Apache-2.0
#pragma once

// What `dewbow rainbow` is asked for, as plain values.

#include <optional>
#include <string>
#include <vector>

#include "dewbow/import/toml/storm.h"
#include "plot_request.h"

namespace dewbow {

struct RainbowCommand {
    std::string storm_file;  ///< or empty
    Storm options;           ///< above what the file says
    std::optional<double> size_parameter;
    bool amplitudes = false;
    std::vector<std::string> outputs;
    std::vector<PlotRequest> plots;
    int threads = 0;  ///< 0 = all
    bool cache = true;
    bool quiet = false, json = false, self_test = false;
};

/// Returns the program's exit code.
int run(const RainbowCommand& command);

}  // namespace dewbow
