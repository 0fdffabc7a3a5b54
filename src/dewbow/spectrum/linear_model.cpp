// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/linear_model.h"

#include <cmath>

namespace dewbow {
namespace {

/// Values at f = j / 13, rebuilt from the text around the paper's Fig. 4.1.
constexpr double kNodes[3][kPaperSamples + 1] = {
    {0, 1, 1, 1, 0.5, 0, 0, 0, 0, 0, 0.5, 1, 1, 0},
    {0, 0, 0.5, 1, 1, 1, 1, 1, 0.5, 0, 0, 0, 0, 0},
    {0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0},
};

}  // namespace

Wavelength paper_wavelength(double f, SpectralSpacing spacing) {
    const double red = kPaperRed.to(unit::nm), violet = kPaperViolet.to(unit::nm);
    if (spacing == SpectralSpacing::wavelength) return (red + f * (violet - red)) * unit::nm;
    return 1.0 / (1.0 / red + f * (1.0 / violet - 1.0 / red)) * unit::nm;
}

double paper_coordinate(Wavelength lambda, SpectralSpacing spacing) {
    if (spacing == SpectralSpacing::wavelength)
        return (kPaperRed - lambda) / (kPaperRed - kPaperViolet);
    const double red = kPaperRed.to(unit::nm), violet = kPaperViolet.to(unit::nm);
    return (1.0 / lambda.to(unit::nm) - 1.0 / red) / (1.0 / violet - 1.0 / red);
}

Colour<LinearSrgb> linear_spectrum_colour(double f) {
    if (!(f > 0.0 && f < 1.0)) return {};
    const double at = f * kPaperSamples;
    const int j = static_cast<int>(at);
    const double t = at - j;
    Colour<LinearSrgb> colour;
    for (std::size_t c = 0; c < 3; ++c) colour[c] = (1.0 - t) * kNodes[c][j] + t * kNodes[c][j + 1];
    return colour;
}

std::array<Colour<LinearSrgb>, kPaperSamples> linear_spectrum_samples() {
    std::array<Colour<LinearSrgb>, kPaperSamples> samples;
    for (int k = 0; k < kPaperSamples; ++k)
        samples[std::size_t(k)] = linear_spectrum_colour((k + 0.5) / kPaperSamples);
    return samples;
}

}  // namespace dewbow
