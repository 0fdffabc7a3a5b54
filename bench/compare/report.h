// SPDX-License-Identifier: Apache-2.0
#pragma once

// What people read of a comparison.

#include <string>

#include "machine.h"
#include "measurement.h"

namespace dewbow::bench {

/// How the benchmark was called, and where.
struct Circumstances {
    Machine machine;
    std::string command;
    double load_before = 0.0, load_after = 0.0;
    std::vector<std::string> absent;  ///< contestants whose program is not here
};

/// Markdown: circumstances, the summary, and a table for each scene.
std::string report_of(const Measurements& all, const Plan& plan, const Circumstances& where);

/// Part of it: what `path` has of the errors of the others at equal time and at 16 times that, and
/// what jitter and correlation buy.
std::string summary_of(const Measurements& all);

/// Of scenes of caustics: what `caustics` has of the errors of the others at equal time.
std::string caustics_of(const Measurements& all);

/// SVG: error over CPU time against the truth, against contestants' own limits, of the coloured
/// pixels, and FLIP.
std::string plot_of(const Measurements& all, const SceneFacts& scene);

/// One JSON object a line: circumstances, scenes, runs.
std::string json_lines_of(const Measurements& all, const Plan& plan, const Circumstances& where);

}  // namespace dewbow::bench
