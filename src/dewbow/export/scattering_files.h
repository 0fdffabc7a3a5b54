// SPDX-License-Identifier: Apache-2.0
#pragma once

// A table of phase functions as files for people and programs. Each says what its numbers mean and
// how they were made.
//
// P is normalised to 4π: unpolarised, its integral over the sphere is 4π sr, so that P / 4π is the
// part of the scattered light per sr. Q are cross sections over the drops' geometric ones.

#include <string>

#include "dewbow/image/image.h"
#include "dewbow/rainbow/scattering_table.h"

namespace dewbow {

/// Comments (# key: value) with the facts, the efficiencies by wavelength and the meaning of the
/// columns, then one row for each wavelength and angle:
///
///     wavelength_nm,scattering_angle_deg,angle_from_antisolar_deg,P_unpolarised,P_perpendicular,
///     P_parallel
///
/// Numbers have 9 digits; what a model does not know is "nan".
std::string csv_of(const ScatteringTable& table, const Attributes& facts);

/// {"facts": {…}, "units": {…}, "scattering_angle_deg": […], "wavelengths": [{"wavelength_nm",
/// "Q_…", "g", "P_unpolarised": […], …}]}. What a model does not know is null.
std::string json_of(const ScatteringTable& table, const Attributes& facts);

/// Angle from left to right, wavelength from top to bottom; channels "P.perpendicular" and
/// "P.parallel", and Q_ext, Q_sca, g as layers that are the same at all angles. Floats. What a
/// model does not know is 0.
std::string exr_of(const ScatteringTable& table, const Attributes& facts);

}  // namespace dewbow
