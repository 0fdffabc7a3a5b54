// SPDX-License-Identifier: Apache-2.0
#pragma once

// Relative spectra, scaled so that their Y is that of the constant 1.

#include <vector>

#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// Piecewise linear; the first and last value hold outside, as CIE 167:2005 recommends.
SpectrumPtr tabulated_as_bright_as_one(const std::vector<double>& lambda_nm,
                                       std::vector<double> values);

/// Boxes of `width`, as make_lines makes them.
SpectrumPtr lines_as_bright_as_one(std::vector<Line> lines, Wavelength width);

}  // namespace dewbow
