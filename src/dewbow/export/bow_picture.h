// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pictures of bows: a strip of colours by angle, and the arc in the sky.

#include <optional>
#include <vector>

#include "dewbow/export/bow_colour.h"
#include "dewbow/image/image.h"

namespace dewbow {

/// How much of each polarisation is seen; 1/2 of each without a polariser.
struct PolarisationShares {
    double perpendicular = 0.5, parallel = 0.5;
};

/// Through an ideal polariser whose axis stands `axis` from the vertical, at the clock angle
/// `clock` around the bow, both to the same side: sin²(axis − clock) of the light perpendicular to
/// the scattering plane, which vibrates along the bow, and cos² of the other.
PolarisationShares behind_polariser(Angle axis, Angle clock);

/// What is seen of a bow.
struct BowLook {
    PolarisationShares shares;       ///< where there is no polariser
    std::optional<Angle> polariser;  ///< its axis from the vertical
    PolarisationShares at(Angle clock) const {
        return polariser ? behind_polariser(*polariser, clock) : shares;
    }
};

/// A bow that is not the same all around, as that of flattened drops. One entry: it is.
struct BowAround {
    std::vector<Angle> clocks;  ///< from the bow's top, 0 to 180°, ascending; both sides alike
    std::vector<BowColours> colours;  ///< one for each
    /// At an angle from the antisolar point, under a clock angle of −180 to 180°.
    Colour<Xyz> at(Angle radius, Angle clock, const BowLook& look) const;
};

/// The colours at angles from `left` to `right` from the antisolar point, under one clock angle.
struct StripView {
    Angle left, right;
    Angle clock{};
    int width = 1040, height = 120;
};
/// Without dither: all rows are alike.
Image8 strip_picture(const BowAround& bow, const BowLook& look, const StripView& view,
                     const DisplaySettings& settings);

/// The sky around the antisolar point, which lies `sun_altitude` below the horizon. Distances in
/// the picture are in proportion to angles from that point, so that bows are circles. [equidistant
/// azimuthal projection] What is below the horizon is ground.
struct SkyView {
    Angle sun_altitude;
    Angle half_width = 60.0 * unit::deg;  ///< from the middle to the left and right edges
    Angle top = 60.0 * unit::deg;         ///< of the picture, above the antisolar point
    int width = 1000, height = 560;
};
Image8 sky_picture(const BowAround& bow, const BowLook& look, const SkyView& view,
                   const DisplaySettings& settings);

/// Bows of many drop sizes, one above the other, in the order given from bottom to top, from `left`
/// to `right` from the antisolar point. Each row is as bright as it can be. [Lee 1998]
/// @param bows  at least one.
struct LeeView {
    Angle left, right;
    int width = 360, height = 230;
};
Image8 lee_picture(const std::vector<BowColours>& bows, const PolarisationShares& shares,
                   const LeeView& view, const Spectrum& white);

/// All colours of the bow between two angles from the antisolar point, without a polariser: what
/// settings_for chooses the exposure by.
std::vector<Colour<Xyz>> colours_between(const BowAround& bow, Angle from, Angle to);

}  // namespace dewbow
