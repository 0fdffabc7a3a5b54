// SPDX-License-Identifier: Apache-2.0
#include "rainbow_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "console.h"
#include "dewbow/base/error.h"
#include "dewbow/rainbow/mixed_table.h"
#include "dewbow/rainbow/models.h"
#include "dewbow/rainbow/table_cache.h"
#include "dewbow/sky/direct_sun.h"
#include "dewbow/spectrum/lamp.h"
#include "rainbow_degrees.h"

namespace dewbow {
namespace {

constexpr const char* kModel = "auto";
/// Knows no orders; beside others that are asked for some it shows what they are parts of.
constexpr const char* kWhole = "mie";
constexpr const char* kLight = "D65";
constexpr Length kRadius = 0.5 * unit::mm;
constexpr Angle kSunAltitude = 20.0 * unit::deg;

/// The radius of drops of this size parameter in the one wavelength that is asked for.
Length radius_of(double size_parameter, const Storm& storm, const DropOptics& optics) {
    if (storm.wavelengths.size() > 1)
        throw UsageError("--size-parameter is of one wavelength, and several are asked for");
    const Wavelength lambda = storm.wavelengths.empty() ? kSodium : storm.wavelengths.front();
    return size_parameter / optics.size_parameter(1.0 * unit::m, lambda) * unit::m;
}

std::vector<DropSizesPtr> showers_of(const RainbowCommand& command, const Storm& storm,
                                     const DropOptics& optics) {
    if (command.size_parameter)
        return {single_drop_size(radius_of(*command.size_parameter, storm, optics))};
    if (storm.sizes.empty()) return {single_drop_size(kRadius)};
    return storm.sizes;
}

/// "0.3mm + 1mm"
std::string described(const std::vector<DropSizesPtr>& showers) {
    std::string text;
    for (const DropSizesPtr& sizes : showers)
        text += (text.empty() ? "" : " + ") + sizes->describe();
    return text;
}

ClearSky sky_of(const Storm& storm) {
    ClearSky sky;
    sky.aerosol_depth_500nm = storm.haze.value_or(sky.aerosol_depth_500nm);
    return sky;
}

/// One size of drops goes to Mie, which knows spheres alone.
void check_shape(const RainbowSetup& setup) {
    if (!setup.request.falling) return;
    const bool one_size = std::any_of(setup.showers.begin(), setup.showers.end(),
                                      [](const DropSizesPtr& sizes) { return sizes->is_single(); });
    for (const std::string& model : setup.models)
        if (model == "mie" || (model == "auto" && one_size))
            throw UsageError(
                fmt::format("model \"{}\" does not know flattened drops{}", model,
                            model == "auto" ? " of one size" : ""),
                "uniform_airy, airy, debye and descartes do, and auto those of many sizes");
}

std::optional<FallingShape> falling_of(const Storm& storm, Angle sun_altitude) {
    if (storm.shape != DropShape::oblate) {
        if (storm.oscillation || storm.tilt)
            throw UsageError("oscillation and tilt are of flattened drops", "add --shape oblate");
        return std::nullopt;
    }
    return FallingShape{{storm.oscillation.value_or(0.0), storm.tilt.value_or(Angle{})},
                        {sun_altitude, storm.clock_angle.value_or(Angle{})}};
}

std::string shown(const std::vector<int>& orders) {
    if (orders.empty()) return "all";
    std::string text;
    for (const int order : orders) text += fmt::format("{}{}", text.empty() ? "" : " ", order);
    return text;
}

}  // namespace

Storm storm_of(const RainbowCommand& command) {
    if (command.storm_file.empty()) return command.options;
    return with_above(load_storm(command.storm_file), command.options);
}

RainbowSetup set_up(const RainbowCommand& command) {
    RainbowSetup setup;
    setup.storm = storm_of(command);
    const Storm& storm = setup.storm;
    setup.models = storm.models.empty() ? std::vector<std::string>{kModel} : storm.models;
    TableRequest& request = setup.request;
    request.model = setup.models.front();
    request.orders = storm.orders;
    request.tolerance = storm.tolerance.value_or(request.tolerance);
    request.optics = drop_optics(storm, storm.wavelengths);
    setup.showers = showers_of(command, storm, request.optics);
    request.sizes = setup.showers.front();
    request.wavelengths = storm.wavelengths;
    request.angles = storm.angles;
    request.disc.radius = storm.sun_radius.value_or(kSunRadius);
    request.disc.limb_darkening = storm.limb_darkening.value_or(0.0);
    const Lamp& lamp = storm.illuminant ? *storm.illuminant : find_lamp(kLight);
    setup.light_name = lamp.name;
    setup.white = setup.light = lamp.spectrum;
    setup.sun_altitude = storm.sun_altitude.value_or(kSunAltitude);
    if (storm.reddened.value_or(false))
        setup.light = make_direct_sunlight(setup.white, setup.sun_altitude, sky_of(storm));
    else if (storm.haze)
        throw UsageError("haze counts where the sun is reddened", "add --redden");
    setup.request.falling = falling_of(storm, setup.sun_altitude);
    setup.polarisation = storm.polarisation.value_or(Polarisation::unpolarised);
    setup.drops = command.size_parameter ? fmt::format("x = {:g}", *command.size_parameter)
                                         : described(setup.showers);
    setup.cache = command.cache;
    check_shape(setup);
    return setup;
}

TableRequest RainbowSetup::request_for(const std::string& model,
                                       const std::vector<Wavelength>& wavelengths,
                                       const std::vector<Angle>& angles) const {
    TableRequest other = request;
    other.model = model;
    if (models.size() > 1 && model == kWhole) other.orders.clear();
    if (other.wavelengths.empty()) other.wavelengths = wavelengths;
    if (other.angles.empty()) other.angles = angles;
    return other;
}

ScatteringTable RainbowSetup::table_of(TableRequest wanted, Keep keep) const {
    const std::filesystem::path folder =
        cache && keep == Keep::on_disk ? default_cache_directory() : std::filesystem::path();
    std::vector<ScatteringTable> tables;
    for (const DropSizesPtr& sizes : showers) {
        wanted.sizes = sizes;
        CachedTable made = cached_scattering_table(wanted, folder);
        if (!made.note.empty()) print_message("note: " + made.note);
        tables.push_back(std::move(made.table));
    }
    return tables.size() == 1 ? std::move(tables.front()) : mixed_evenly(tables);
}

Attributes RainbowSetup::facts() const {
    const SunDisc& disc = request.disc;
    Attributes facts{
        {"dewbow:version", DEWBOW_VERSION},
        {"dewbow:model", request.model},
        {"dewbow:orders", shown(request.orders)},
        {"dewbow:drops", described(showers)},
        {"dewbow:indexAt589nm", request.optics.index(kSodium).value},
        {"dewbow:sunRadiusDegrees", degrees_of(disc.radius)},
        {"dewbow:limbDarkening", disc.limb_darkening},
    };
    if (storm.index) {
        facts.push_back({"dewbow:index", storm.index->n});
        facts.push_back({"dewbow:extinctionCoefficient", storm.index->k});
    } else {
        facts.push_back({"dewbow:water", storm.water ? storm.water->name : kDropWater});
        facts.push_back({"dewbow:air", storm.air ? storm.air->name : kDropAir});
    }
    if (request.falling) {
        facts.push_back({"dewbow:dropShape", "oblate"});
        facts.push_back({"dewbow:dropOscillation", request.falling->spread.oscillation});
        facts.push_back({"dewbow:dropTiltDegrees", degrees_of(request.falling->spread.tilt)});
        facts.push_back({"dewbow:sunAltitudeDegrees", degrees_of(sun_altitude)});
        facts.push_back({"dewbow:clockAngleDegrees", degrees_of(request.falling->place.clock)});
    }
    if (request.model == "auto") facts.push_back({"dewbow:tolerance", request.tolerance});
    return facts;
}

}  // namespace dewbow
