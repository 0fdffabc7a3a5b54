// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/linear_model.h"

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
    return SpectralCoordinate{kPaperRed, kPaperViolet, spacing}.wavelength(f);
}

double paper_coordinate(Wavelength lambda, SpectralSpacing spacing) {
    return SpectralCoordinate{kPaperRed, kPaperViolet, spacing}.at(lambda);
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
