// SPDX-License-Identifier: Apache-2.0
#include "film_wavelengths.h"

#include <algorithm>

#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::bench {
namespace {

constexpr std::size_t kWavelengths = 4096;

}  // namespace

Colour<LinearSrgb> film_weight(double lambda_nm, double pdf_per_nm, double film_from_xyz) {
    return rgb_from_xyz<LinearSrgb>(Colour<Xyz>{cie_xyz_bar(lambda_nm)}) *
           (film_from_xyz / pdf_per_nm);
}

std::vector<FilmWavelength> film_wavelengths(double film_from_xyz) {
    constexpr double kStep_nm = 0.05, kEverywhere = 0.02;
    std::vector<double> cumulative{0.0};
    const auto density = [](double nm) {
        const auto bar = cie_xyz_bar(nm);
        return bar[0] + bar[1] + bar[2] + kEverywhere;
    };
    const auto steps = std::size_t((kLambdaMax_nm - kLambdaMin_nm) / kStep_nm + 0.5);
    for (std::size_t i = 0; i < steps; ++i)
        cumulative.push_back(cumulative.back() +
                             kStep_nm * density(kLambdaMin_nm + kStep_nm * (double(i) + 0.5)));
    std::vector<FilmWavelength> wavelengths;
    for (std::size_t k = 0; k < kWavelengths; ++k) {
        const double wanted = (double(k) + 0.5) / double(kWavelengths) * cumulative.back();
        const auto above = std::upper_bound(cumulative.begin(), cumulative.end(), wanted);
        const double within = (wanted - above[-1]) / (above[0] - above[-1]);
        const double nm =
            kLambdaMin_nm + kStep_nm * (double(above - cumulative.begin() - 1) + within);
        const double pdf = (above[0] - above[-1]) / kStep_nm / cumulative.back();
        wavelengths.push_back({nm, pdf, film_weight(nm, pdf, film_from_xyz)});
    }
    return wavelengths;
}

}  // namespace dewbow::bench
