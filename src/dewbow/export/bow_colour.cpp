// SPDX-License-Identifier: Apache-2.0
#include "dewbow/export/bow_colour.h"

#include <algorithm>
#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/math/interpolation.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

/// Step of the integrals, as that of xyz_from_spectrum.
constexpr double kStep_nm = 0.5;

/// What each wavelength of a table contributes to X, Y, Z: hat functions between neighbours.
std::vector<Colour<Xyz>> weights_of(const std::vector<Wavelength>& wavelengths,
                                    const Spectrum& light) {
    const auto part = [&](double nm) {
        const auto bar = cie_xyz_bar(nm);
        return light(nm * unit::nm) * Colour<Xyz>{{bar[0], bar[1], bar[2]}};
    };
    std::vector<Colour<Xyz>> weights(wavelengths.size());
    if (wavelengths.size() == 1) return {part(wavelengths.front().to(unit::nm))};
    for (std::size_t i = 0; i + 1 < wavelengths.size(); ++i) {
        const double from = wavelengths[i].to(unit::nm), to = wavelengths[i + 1].to(unit::nm);
        const auto steps = static_cast<int>(std::ceil((to - from) / kStep_nm));
        const double step = (to - from) / steps;
        for (int k = 0; k < steps; ++k) {  // midpoints
            const double t = (k + 0.5) / steps;
            const Colour<Xyz> colour = step * part(from + t * (to - from));
            weights[i] = weights[i] + (1.0 - t) * colour;
            weights[i + 1] = weights[i + 1] + t * colour;
        }
    }
    return weights;
}

double known(double value) { return std::isfinite(value) ? value : 0.0; }

double highest_channel(Colour<Xyz> xyz, const std::array<double, 2>& white) {
    const Colour<Xyz> adapted = adapt_white(xyz, white, primaries_of<LinearSrgb>().white);
    const auto rgb = map_gamut(rgb_from_xyz<LinearSrgb>(adapted), DisplaySettings{}.gamut);
    return std::max({rgb[0], rgb[1], rgb[2]});
}

}  // namespace

BowColours bow_colours(const ScatteringTable& table, const Spectrum& light, const Spectrum& white) {
    double brightness = 0.0;
    for (const Colour<Xyz>& weight : weights_of(table.wavelengths, white)) brightness += weight[1];
    if (!(brightness > 0.0))
        throw InputError("none of the wavelengths is visible, so that there is no picture",
                         "pictures need wavelengths between 360 and 830 nm in the illuminant");
    const std::vector<Colour<Xyz>> weights = weights_of(table.wavelengths, light);

    BowColours bow{table.angles, {}, {}};
    for (std::size_t i = 0; i < table.angles.size(); ++i) {
        Colour<Xyz> perpendicular, parallel;
        for (std::size_t j = 0; j < weights.size(); ++j) {
            const double scale = table.efficiencies[j].scattering / brightness;
            const Intensities& p = table.at(i, j);
            perpendicular = perpendicular + known(scale * p.perpendicular) * weights[j];
            parallel = parallel + known(scale * p.parallel) * weights[j];
        }
        bow.perpendicular.push_back(perpendicular);
        bow.parallel.push_back(parallel);
    }
    return bow;
}

Colour<Xyz> colour_at(const std::vector<Angle>& angles, const std::vector<Colour<Xyz>>& colours,
                      Angle angle) {
    if (angle <= angles.front()) return colours.front();
    if (angle >= angles.back()) return colours.back();
    const auto above = std::upper_bound(angles.begin(), angles.end(), angle);
    const auto i = static_cast<std::size_t>(above - angles.begin()) - 1;
    const double t = (angle - angles[i]).to(angles[i + 1] - angles[i]);
    return (1.0 - t) * colours[i] + t * colours[i + 1];
}

DisplaySettings settings_for(const std::vector<Colour<Xyz>>& shown, const Spectrum& white) {
    DisplaySettings settings;
    const Colour<Xyz> xyz = xyz_from_spectrum(white);
    const double sum = xyz[0] + xyz[1] + xyz[2];
    settings.white = {xyz[0] / sum, xyz[1] / sum};
    double highest = 0.0;
    for (const Colour<Xyz>& colour : shown)
        highest = std::max(highest, highest_channel(colour, settings.white));
    if (highest > 0.0) settings.exposure_stops = -std::log2(highest);
    return settings;
}

}  // namespace dewbow
