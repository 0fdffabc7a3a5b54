// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a cloud of drops does to light: one drop's answer, averaged over sizes, shapes and the sun's
// disc. The table that renderers read.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/rainbow/cloud_scattering.h"
#include "dewbow/rainbow/drop_sizes.h"
#include "dewbow/rainbow/models.h"
#include "dewbow/rainbow/scattering.h"
#include "dewbow/rainbow/sun_disc.h"

namespace dewbow {

struct TableRequest {
    std::string model = "auto";
    Orders orders;            ///< empty: all
    double tolerance = 0.02;  ///< of `auto`
    DropSizesPtr sizes;
    DropOptics optics;
    std::vector<Wavelength> wavelengths;  ///< in vacuum, ascending
    std::vector<Angle> angles;            ///< scattering angles, ascending
    SunDisc disc;
    std::optional<FallingShape> falling;  ///< shapes of falling drops; nothing: spheres
};

/// Phase functions by angle and wavelength, with the cross sections that belong to them.
struct ScatteringTable {
    std::vector<Angle> angles;            ///< scattering angles, ascending
    std::vector<Wavelength> wavelengths;  ///< in vacuum, ascending
    /// [angle][wavelength]: P of light polarised perpendicular and parallel to the scattering
    /// plane; their mean integrates to 4π over the sphere. Per 4π sr: radiance = E σ_sca P / 4π a
    /// drop.
    std::vector<Intensities> phase;
    /// [wavelength]: over all drops, weighted by their geometric cross section.
    std::vector<Efficiencies> efficiencies;
    Area mean_cross_section;  ///< geometric, πa², of a drop on average
    std::string report;       ///< what the model chose, and how wrong that may be
    /// Of the unpolarised P, over the primary bow's peak; NaN of models that state none.
    double stated_error = 0.0;

    const Intensities& at(std::size_t angle, std::size_t wavelength) const {
        return phase[angle * wavelengths.size() + wavelength];
    }
};

/// Throws InputError: what is missing, out of order or out of range in a request.
void check(const TableRequest& request);

/// Throws InputError as check() and for what the model cannot treat.
ScatteringTable make_scattering_table(const TableRequest& request);

}  // namespace dewbow
