// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/as_bright_as_one.h"

#include "dewbow/spectrum/cie.h"

namespace dewbow {

SpectrumPtr tabulated_as_bright_as_one(const std::vector<double>& lambda_nm,
                                       std::vector<double> values) {
    const double y = xyz_from_spectrum(*make_tabulated(lambda_nm, values, OutsideTable::hold))[1];
    for (double& value : values) value *= cie_y_integral() / y;
    return make_tabulated(lambda_nm, std::move(values), OutsideTable::hold);
}

SpectrumPtr lines_as_bright_as_one(std::vector<Line> lines, Wavelength width) {
    const double y = xyz_from_spectrum(*make_lines(lines, width))[1];
    for (Line& line : lines) line.strength *= cie_y_integral() / y;
    return make_lines(std::move(lines), width);
}

}  // namespace dewbow
