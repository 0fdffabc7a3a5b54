// SPDX-License-Identifier: Apache-2.0
#pragma once

// The way of light that comes to the points of a line by way of a level mirror: down from the sun
// to the mirror, and up again.

#include "dewbow/sky/length_pieces.h"

namespace dewbow {

/// Where the light that a line's points see in the direction `towards` (downwards) leaves a level
/// plane: as the point moves on along the line, that place moves along a line, too.
class LineOnPlane {
public:
    LineOnPlane(double height_m, Point<World> origin, Dir<World> direction, Dir<World> towards);

    /// Appends the pieces of `along(origin, direction, interval, out)`, asked for on the plane's
    /// line, as functions of the distance along the first one.
    template <class Along>
    void lengths(const Along& along, LineInterval on, std::vector<LengthPiece>& pieces) const {
        if (speed_ < kStill) {  // one looks along the light, and all of it leaves at one place
            std::vector<LengthPiece> here;
            along(origin_, still_direction_, LineInterval{0.0, 1.0}, here);
            pieces.push_back({on.begin, on.end, here.front().length, 0.0});
            return;
        }
        const std::size_t first = pieces.size();
        along(origin_, direction_, LineInterval{on.begin * speed_, on.end * speed_}, pieces);
        const std::span<LengthPiece> added = std::span(pieces).subspan(first);
        scale_distance(added, 1.0 / speed_);
        if (added.empty()) return;
        added.front().begin = on.begin, added.back().end = on.end;  // no gap by rounding
    }

private:
    /// m per m: what the place moves by over a kilometre is a tenth of a millimetre.
    static constexpr double kStill = 1e-7;
    Point<World> origin_;         ///< for distance 0
    Dir<World> direction_;        ///< unit
    double speed_;                ///< m on the plane per m of the line
    Dir<World> still_direction_;  ///< any
};

}  // namespace dewbow
