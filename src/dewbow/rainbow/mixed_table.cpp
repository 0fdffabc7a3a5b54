// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mixed_table.h"

#include <algorithm>

namespace dewbow {
namespace {

Efficiencies mean_efficiencies(std::span<const ScatteringTable> tables, std::size_t wavelength) {
    const double share = 1.0 / static_cast<double>(tables.size());
    Efficiencies mean;
    for (const ScatteringTable& table : tables) {
        const Efficiencies& q = table.efficiencies[wavelength];
        mean.extinction += share * q.extinction;
        mean.scattering += share * q.scattering;
        mean.asymmetry += share * q.scattering * q.asymmetry;
    }
    mean.asymmetry /= mean.scattering;
    return mean;
}

/// Of a drop on average, where there are as many of each kind as make the same cross section.
Area mean_cross_section(std::span<const ScatteringTable> tables) {
    double per_area = 0.0;
    for (const ScatteringTable& table : tables)
        per_area += unit::m * unit::m / table.mean_cross_section;
    return static_cast<double>(tables.size()) / per_area * unit::m * unit::m;
}

}  // namespace

ScatteringTable mixed_evenly(std::span<const ScatteringTable> tables) {
    ScatteringTable mixed;
    mixed.angles = tables.front().angles;
    mixed.wavelengths = tables.front().wavelengths;
    mixed.mean_cross_section = mean_cross_section(tables);
    mixed.phase.resize(tables.front().phase.size());
    const std::size_t wavelengths = mixed.wavelengths.size();
    for (std::size_t j = 0; j < wavelengths; ++j)
        mixed.efficiencies.push_back(mean_efficiencies(tables, j));
    for (const ScatteringTable& table : tables) {
        for (std::size_t k = 0; k < mixed.phase.size(); ++k) {
            const std::size_t j = k % wavelengths;
            const double weight = table.efficiencies[j].scattering /
                                  mixed.efficiencies[j].scattering /
                                  static_cast<double>(tables.size());
            mixed.phase[k].perpendicular += weight * table.phase[k].perpendicular;
            mixed.phase[k].parallel += weight * table.phase[k].parallel;
        }
        mixed.report += (mixed.report.empty() ? "" : "; ") + table.report;
        mixed.stated_error = std::max(table.stated_error, mixed.stated_error);
    }
    return mixed;
}

}  // namespace dewbow
