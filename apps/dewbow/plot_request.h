// SPDX-License-Identifier: Apache-2.0
#pragma once

// `--plot KIND=FILE`.

#include <string>
#include <vector>

namespace dewbow {

struct PlotRequest {
    std::string kind;
    std::string file;
};

/// What a subcommand can plot.
struct PlotKind {
    std::string name;
    std::vector<std::string> endings;  ///< of its files: ".svg"
};

}  // namespace dewbow
