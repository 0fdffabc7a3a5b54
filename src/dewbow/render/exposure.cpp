// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/exposure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

/// Most of the picture lies below this part of white: lamps and highlights, a tenth of the pixels
/// or less, may be brighter. Chosen by eye on rooms, rings and open tables.
constexpr double kTarget = 0.7, kShareBelow = 0.9;
/// Steps of the exposure: noise does not change it from one render to the next.
constexpr double kStep_stops = 0.25;
constexpr double kMostStops = 60.0;
/// A picture is left at exposure 0 if that is at most this much too bright or too dark: scenes that
/// are lit as their format means it stay comparable, and what is dark on purpose stays dark.
constexpr double kTooBright_stops = 2.0, kTooDark_stops = 6.0;

}  // namespace

double automatic_exposure(const FilmSums& film, const Film& settings) {
    const PixelRect& crop = film.crop();
    std::vector<double> y_of_pixels;
    for (int y = crop.y0; y < crop.y1; ++y)
        for (int x = crop.x0; x < crop.x1; ++x) y_of_pixels.push_back(film.xyz(x, y)[1]);
    const auto place =
        y_of_pixels.begin() + std::ptrdiff_t(kShareBelow * double(y_of_pixels.size() - 1));
    std::nth_element(y_of_pixels.begin(), place, y_of_pixels.end());
    const double white = settings.white_luminance / (kLuminousEfficacy * cie_y_integral());
    const double level = *place / white;
    if (!(level > 0.0)) return 0.0;
    const double stops = std::round(std::log2(kTarget / level) / kStep_stops) * kStep_stops;
    return std::clamp(stops, -kMostStops, kMostStops);
}

double exposure_of(const FilmSums& film, const Film& settings) {
    if (settings.exposure == ExposureMode::fixed) return settings.exposure_stops;
    const double stops = automatic_exposure(film, settings);
    const bool near = stops >= -kTooBright_stops && stops <= kTooDark_stops;
    return settings.exposure == ExposureMode::automatic_if_far && near ? 0.0 : stops;
}

}  // namespace dewbow
