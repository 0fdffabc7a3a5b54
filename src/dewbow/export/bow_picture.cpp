// SPDX-License-Identifier: Apache-2.0
#include "dewbow/export/bow_picture.h"

#include <algorithm>
#include <cmath>

#include "dewbow/base/parallel.h"

namespace dewbow {
namespace {

/// What ground looks like: dark, and told from a dark sky.
constexpr std::array<std::uint8_t, 3> kGround{38, 36, 33};

Colour<Xyz> seen(const BowColours& bow, Angle scattering, PolarisationShares shares) {
    return shares.perpendicular * colour_at(bow.angles, bow.perpendicular, scattering) +
           shares.parallel * colour_at(bow.angles, bow.parallel, scattering);
}

Image8 picture(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(std::size_t(width) * height * 3)};
}

void put(Image8& image, int x, int y, const std::array<std::uint8_t, 3>& rgb) {
    std::copy(rgb.begin(), rgb.end(), image.rgb.begin() + (std::size_t(y) * image.width + x) * 3);
}

/// Height over the horizon of what lies `radius` from the antisolar point, `clock` from its top.
Angle elevation(Angle sun_altitude, Angle radius, Angle clock) {
    const double sine = -std::sin(sun_altitude.to(unit::rad)) * cos(radius) +
                        cos(sun_altitude) * sin(radius) * cos(clock);
    return std::asin(std::clamp(sine, -1.0, 1.0)) * unit::rad;
}

}  // namespace

PolarisationShares behind_polariser(Angle axis, Angle clock) {
    const double s = sin(axis - clock), c = cos(axis - clock);
    return {0.5 * s * s, 0.5 * c * c};
}

Colour<Xyz> BowAround::at(Angle radius, Angle clock, const BowLook& look) const {
    const Angle scattering = 180.0 * unit::deg - radius;
    const PolarisationShares shares = look.at(clock);
    const Angle side = abs(clock);
    if (side <= clocks.front()) return seen(colours.front(), scattering, shares);
    if (side >= clocks.back()) return seen(colours.back(), scattering, shares);
    const auto above = std::upper_bound(clocks.begin(), clocks.end(), side);
    const auto i = static_cast<std::size_t>(above - clocks.begin()) - 1;
    const double t = (side - clocks[i]).to(clocks[i + 1] - clocks[i]);
    return (1.0 - t) * seen(colours[i], scattering, shares) +
           t * seen(colours[i + 1], scattering, shares);
}

Image8 strip_picture(const BowAround& bow, const BowLook& look, const StripView& view,
                     const DisplaySettings& settings) {
    Image8 image = picture(view.width, view.height);
    DisplaySettings plain = settings;
    plain.dither = false;
    for (int x = 0; x < view.width; ++x) {
        const Angle radius = view.left + (x + 0.5) / view.width * (view.right - view.left);
        const auto rgb = srgb8_from_xyz(bow.at(radius, view.clock, look), plain, x, 0);
        for (int y = 0; y < view.height; ++y) put(image, x, y, rgb);
    }
    return image;
}

Image8 lee_picture(const std::vector<BowColours>& bows, const PolarisationShares& shares,
                   const LeeView& view, const Spectrum& white) {
    Image8 image = picture(view.width, view.height);
    std::vector<Colour<Xyz>> row(static_cast<std::size_t>(view.width));
    for (int y = 0; y < view.height; ++y) {
        const double up = (view.height - y - 0.5) / view.height;
        const auto i = static_cast<std::size_t>(up * static_cast<double>(bows.size()));
        for (int x = 0; x < view.width; ++x) {
            const Angle radius = view.left + (x + 0.5) / view.width * (view.right - view.left);
            row[std::size_t(x)] = seen(bows[i], 180.0 * unit::deg - radius, shares);
        }
        DisplaySettings settings = settings_for(row, white);
        settings.dither = false;
        for (int x = 0; x < view.width; ++x)
            put(image, x, y, srgb8_from_xyz(row[std::size_t(x)], settings, x, y));
    }
    return image;
}

Image8 sky_picture(const BowAround& bow, const BowLook& look, const SkyView& view,
                   const DisplaySettings& settings) {
    Image8 image = picture(view.width, view.height);
    const double degrees_per_pixel = 2.0 * view.half_width.to(unit::deg) / view.width;
    parallel_for(std::size_t(view.height), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < view.width; ++x) {
            const double right = (x + 0.5 - 0.5 * view.width) * degrees_per_pixel;
            const double up = view.top.to(unit::deg) - (y + 0.5) * degrees_per_pixel;
            const Angle radius = std::hypot(right, up) * unit::deg;
            const Angle clock = std::atan2(right, up) * unit::rad;
            const bool sky = elevation(view.sun_altitude, radius, clock).to(unit::rad) > 0.0;
            put(image, x, y,
                sky ? srgb8_from_xyz(bow.at(radius, clock, look), settings, x, y) : kGround);
        }
    });
    return image;
}

std::vector<Colour<Xyz>> colours_between(const BowAround& bow, Angle from, Angle to) {
    std::vector<Colour<Xyz>> shown;
    for (const BowColours& colours : bow.colours)
        for (std::size_t i = 0; i < colours.angles.size(); ++i) {
            const Angle radius = 180.0 * unit::deg - colours.angles[i];
            if (radius >= from && radius <= to) shown.push_back(colours.unpolarised(i));
        }
    return shown;
}

}  // namespace dewbow
