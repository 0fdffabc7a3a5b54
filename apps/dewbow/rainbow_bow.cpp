// SPDX-License-Identifier: Apache-2.0
#include "rainbow_bow.h"

#include "dewbow/sky/direct_sun.h"
#include "rainbow_degrees.h"

namespace dewbow {
namespace {

/// Where the bow of flattened drops is computed; between, colours are mixed. From one to the next a
/// drop of 1 mm across moves its bow by at most 0.23°, which is half the sun. A bow meets the
/// horizon at 90°, or nearer to its top.
constexpr double kClockStep_deg = 7.5, kLastClock_deg = 90.0;

}  // namespace

BowAround bow_of(RainbowTables& tables, const std::vector<Angle>& angles) {
    const RainbowSetup& setup = tables.setup();
    const ScatteringTable& table = tables.get(visible_wavelengths(), angles);
    return {{Angle{}}, {bow_colours(table, *setup.light, *setup.white)}};
}

BowAround bow_all_around(RainbowTables& tables, const std::vector<Angle>& angles) {
    const RainbowSetup& setup = tables.setup();
    if (!setup.request.falling) return bow_of(tables, angles);
    BowAround bow;
    TableRequest request = setup.request_for(setup.models.front(), visible_wavelengths(), angles);
    for (const double degrees : stepped(0.0, kLastClock_deg, kClockStep_deg)) {
        request.falling->place.clock = degrees * unit::deg;
        bow.clocks.push_back(request.falling->place.clock);
        bow.colours.push_back(bow_colours(setup.table_of(request, RainbowSetup::Keep::nowhere),
                                          *setup.light, *setup.white));
    }
    return bow;
}

BowLook look_of(const RainbowSetup& setup) {
    BowLook look;
    look.polariser = setup.storm.polariser;
    if (setup.polarisation == Polarisation::perpendicular) look.shares.parallel = 0.0;
    if (setup.polarisation == Polarisation::parallel) look.shares.perpendicular = 0.0;
    return look;
}

DisplaySettings display_of(const BowAround& bow, Angle from, Angle to, const RainbowSetup& setup) {
    return settings_for(colours_between(bow, from, to), *setup.white);
}

Attributes picture_facts(const RainbowSetup& setup, const DisplaySettings& settings) {
    Attributes facts = setup.facts();
    facts.push_back({"dewbow:illuminant", setup.light_name});
    if (!setup.request.falling)  // else it is there
        facts.push_back({"dewbow:sunAltitudeDegrees", degrees_of(setup.sun_altitude)});
    if (setup.light != setup.white) {
        facts.push_back({"dewbow:sunReddened", std::string("yes")});
        facts.push_back(
            {"dewbow:hazeDepth", setup.storm.haze.value_or(ClearSky{}.aerosol_depth_500nm)});
    }
    if (setup.storm.polariser)
        facts.push_back({"dewbow:polariserDegrees", degrees_of(*setup.storm.polariser)});
    facts.push_back({"dewbow:exposureStops", settings.exposure_stops});
    return facts;
}

}  // namespace dewbow
