// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/spectral_coordinate.h"

namespace dewbow {

const std::vector<std::string>& spectral_spacing_names() {
    static const std::vector<std::string> kNames{"frequency", "wavelength"};
    return kNames;
}

Wavelength SpectralCoordinate::wavelength(double f) const {
    const double red_nm = red.to(unit::nm), violet_nm = violet.to(unit::nm);
    if (spacing == SpectralSpacing::wavelength)
        return (red_nm + f * (violet_nm - red_nm)) * unit::nm;
    return 1.0 / (1.0 / red_nm + f * (1.0 / violet_nm - 1.0 / red_nm)) * unit::nm;
}

double SpectralCoordinate::at(Wavelength lambda) const {
    if (spacing == SpectralSpacing::wavelength) return (red - lambda) / (red - violet);
    const double red_nm = red.to(unit::nm), violet_nm = violet.to(unit::nm);
    return (1.0 / lambda.to(unit::nm) - 1.0 / red_nm) / (1.0 / violet_nm - 1.0 / red_nm);
}

double SpectralCoordinate::nm_per_f(double f) const {
    const double red_nm = red.to(unit::nm), violet_nm = violet.to(unit::nm);
    if (spacing == SpectralSpacing::wavelength) return red_nm - violet_nm;
    const double lambda_nm = wavelength(f).to(unit::nm);
    return lambda_nm * lambda_nm * (1.0 / violet_nm - 1.0 / red_nm);
}

}  // namespace dewbow
