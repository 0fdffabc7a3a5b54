// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where the sun stands, by date, time and place.

#include <string_view>

#include "dewbow/base/quantity.h"
#include "dewbow/math/vector.h"

namespace dewbow {

/// A moment of the Gregorian calendar, by a clock that is `utc_offset_h` ahead of UTC.
struct DateTime {
    int year = 2000, month = 1, day = 1;
    int hour = 0, minute = 0;
    double second = 0.0;
    double utc_offset_h = 0.0;
};

/// A place on Earth, near sea level.
struct Place {
    Angle latitude;   ///< north positive
    Angle longitude;  ///< east positive
};

/// "2026-06-21" and "18:40" or "18:40:30.5".
/// @throws InputError  where they do not read like this, or there is no such date or time: "there
/// is no 29 February in 2026".
DateTime parse_date_time(std::string_view date, std::string_view time, double utc_offset_h = 0.0);

/// A place in the sky: apparent, as seen through the air.
struct SkyPosition {
    Angle altitude;         ///< above the horizon, −90 to 90°
    Angle azimuth;          ///< from north clockwise, 0 to 360°
    double distance = 1.0;  ///< of the sun, in astronomical units
};

/// The sun from the elements of the Earth's orbit, with its largest terms of nutation, parallax and
/// refraction.                 [Meeus, Astronomical Algorithms, 2nd ed. 1998, ch. 12, 13, 22, 25]
/// Error from 1950 to 2050: 0.01°. Refraction at 1010 hPa and 10 °C, by the sun's true altitude,
/// from −1° on; what stands lower is not lifted.
/// @throws InputError  a year outside 1900 to 2100, where the clock's drift against the sky is
/// known; a latitude or longitude that is none.
SkyPosition sun_position(const DateTime& when, const Place& where);

/// How far the air lifts what stands at `true_altitude`: 1.02′ / tan(h + 10.3° / (h/° + 5.11)),
/// 0.48° on the horizon; 0 below −1°.        [Sæmundsson, Sky & Telescope 72, 70 (1986)]
Angle refraction(Angle true_altitude);

/// Unit vector towards a place in the sky: north is −z, east +x, up +y.
Dir<World> direction_to(Angle altitude, Angle azimuth);

}  // namespace dewbow
