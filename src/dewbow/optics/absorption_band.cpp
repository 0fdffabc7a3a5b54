// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/absorption_band.h"

namespace dewbow {

std::complex<double> index_near(const AbsorptionBand& band, Wavelength lambda) {
    const double x = band.c / lambda;
    return std::sqrt(1.0 + band.b / std::complex<double>(1.0 - x * x, -band.damping * x));
}

}  // namespace dewbow
