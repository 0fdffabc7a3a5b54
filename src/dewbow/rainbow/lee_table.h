// SPDX-License-Identifier: Apache-2.0
#pragma once

// Phase functions by drop radius, angle and wavelength: what a Lee diagram shows, and what a
// renderer interpolates in where the drops are not the same everywhere.
//                                                          [Lee, Appl. Opt. 37 (1998) 1506]

#include <string>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/rainbow/cloud_scattering.h"
#include "dewbow/rainbow/scattering.h"
#include "dewbow/rainbow/sun_disc.h"

namespace dewbow {

struct LeeRequest {
    std::vector<Length> radii;  ///< mean radii of the drops, ascending
    /// Standard deviation of the radii over their mean: a gamma distribution around each. 0: drops
    /// of one size, which Mie theory computes one by one.
    double width = 0.05;
    double tolerance = 0.02;  ///< see scatter_automatically
    DropOptics optics;
    std::vector<Wavelength> wavelengths;  ///< in vacuum, ascending
    std::vector<Angle> angles;            ///< scattering angles, ascending
    SunDisc disc;
};

struct LeeTable {
    std::vector<Length> radii;
    std::vector<Angle> angles;
    std::vector<Wavelength> wavelengths;
    std::vector<Intensities> phase;  ///< [radius][angle][wavelength], as in ScatteringTable
    std::string report;
    double stated_error = 0.0;  ///< as in ScatteringTable

    const Intensities& at(std::size_t radius, std::size_t angle, std::size_t wavelength) const {
        return phase[(radius * angles.size() + angle) * wavelengths.size() + wavelength];
    }
    /// Linear in the angle, the wavelength and the logarithm of the radius; end values beyond the
    /// ends.
    Intensities lookup(Length radius, Angle theta, Wavelength lambda) const;
};

/// By `auto`. Throws InputError as make_scattering_table does, and for radii that do not ascend.
LeeTable make_lee_table(const LeeRequest& request);

}  // namespace dewbow
