// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/rains.h"

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/import/toml/chaos.h"
#include "dewbow/import/toml/rain_region.h"
#include "dewbow/import/toml/storm_drops.h"
#include "dewbow/import/toml/tables.h"
#include "dewbow/rainbow/table_cache.h"
#include "dewbow/sky/drop_cloud.h"

namespace dewbow::toml_import {
namespace {

/// From a haze that nobody sees to what water has no room for.
constexpr Range kRates_mm_per_h{0.0, 1e4, true, false};
constexpr Range kExtinctions_per_km{0.0, 1e6, true, false};
constexpr Range kDepths{0.0, kMostRainDepth, true, false};
constexpr Range kNumbers_per_m3{0.0, 1e15, true, false};

std::optional<Length> thickness_of(const Rain& rain) {
    const auto* region = std::get_if<ConvexRegion>(&rain.region);
    return region ? region->thickness() : std::nullopt;
}

/// The number of drops that the law of their sizes states.
RainAmount stated_amount(Table& table, std::span<const DropSizesPtr> showers) {
    const auto number = showers.size() == 1 ? showers.front()->number_per_m3() : std::nullopt;
    if (!number)
        table.fail_missing(
            {"rate_mm_per_h", "extinction_per_km", "optical_depth", "drops_per_m3"},
            "needs rate_mm_per_h, extinction_per_km, optical_depth or drops_per_m3: how dense it "
            "is");
    return DropsPerVolume{*number};
}

RainAmount read_amount(Table& table, const Rain& rain, std::span<const DropSizesPtr> showers) {
    table.at_most_one_of({"rate_mm_per_h", "extinction_per_km", "optical_depth", "drops_per_m3"});
    if (const auto rate = table.find_number("rate_mm_per_h", kRates_mm_per_h))
        return RainRate{*rate};
    if (const auto per_km = table.find_number("extinction_per_km", kExtinctions_per_km))
        return RainExtinction{*per_km * 1e-3};
    if (const auto number = table.find_number("drops_per_m3", kNumbers_per_m3))
        return DropsPerVolume{*number};
    const auto depth = table.find_number("optical_depth", kDepths);
    if (!depth) return stated_amount(table, showers);
    const auto thickness = thickness_of(rain);
    if (!thickness)
        fail(table.document(), table.require("optical_depth").place,
             "optical_depth is of the way between two parallel faces, which this region has not",
             "write extinction_per_km instead");
    return RainExtinction{*depth / thickness->to(unit::m)};
}

/// Discs of the suns that shine on the rain, each once.
std::vector<SunDisc> discs_of(const Scene& scene) {
    std::vector<SunDisc> discs;
    for (const Light& light : scene.lights) {
        const auto* sun = std::get_if<DistantLight>(&light);
        if (!sun || sun->angular_radius == Angle{}) continue;
        const bool known = std::any_of(discs.begin(), discs.end(), [&](const SunDisc& disc) {
            return disc.radius == sun->angular_radius;
        });
        if (!known) discs.push_back({sun->angular_radius, 0.0});
    }
    return discs;
}

/// Throws for a storm that no rain can be made of.
void check_storm(const Table& table, const Storm& storm) {
    if (storm.sizes.empty())
        table.fail_missing({"drop_sizes", "drop_radius_mm", "drop_radius_um"},
                           "needs drop_sizes, drop_radius_mm or drop_radius_um");
    if (storm.models.size() > 1) table.fail_here("has several models; keep one");
    if (storm.shape == DropShape::oblate || storm.oscillation || storm.tilt)
        table.fail_here("has flattened drops; those of rain in a scene are spheres",
                        "dewbow rainbow knows flattened ones");
}

void check_depth(const Table& table, const Rain& rain) {
    const auto thickness = thickness_of(rain);
    if (!thickness) return;
    const double lambda_nm = kExtinctionWavelength.to(unit::nm);
    double per_m = 0.0;
    rain.drops->extinction_lanes({&lambda_nm, 1}, {&per_m, 1});
    const double depth = per_m * thickness->to(unit::m);
    if (depth > kMostRainDepth)
        table.fail_here(
            fmt::format("has an optical depth of {:.3g} through its thinnest way, {:.6g} m; "
                        "expected at most {:.0f}",
                        depth, thickness->to(unit::m), kMostRainDepth));
}

struct RainContext {
    const std::filesystem::path& folder;
    const std::vector<SunDisc> discs;
    Diagnostics& diagnostics;
};

DropCloudPtr read_drops(Table& table, const Rain& rain, const RainContext& context) {
    Storm storm;
    read_storm_drops(table, context.folder, storm);
    check_storm(table, storm);
    DropCloudRequest request;
    if (!storm.models.empty()) request.model = storm.models.front();
    request.orders = storm.orders;
    request.tolerance = storm.tolerance.value_or(request.tolerance);
    request.showers = storm.sizes;
    request.amount = read_amount(table, rain, storm.sizes);
    request.discs = context.discs;
    return at_place(table.document(), table.place(), [&] {
        request.optics = drop_optics(storm, VisibleGrid::wavelengths());
        return make_drop_cloud(request, default_cache_directory());
    });
}

Rain read_rain(Table& table, std::size_t number, const RainContext& context) {
    Rain rain;
    rain.name = table.text("name", fmt::format("rain {}", number));
    rain.region = read_rain_region(table.document(), table.require("region"), context.folder,
                                   context.diagnostics);
    rain.chaos = find_chaos(table, "size_m");
    rain.drops = read_drops(table, rain, context);
    table.finish();
    check_depth(table, rain);
    if (const std::string& note = rain.drops->note(); !note.empty()) {
        const SourcePlace place{table.document().file, table.place().line, 0, {}};
        context.diagnostics.push_back({place, note});
    }
    return rain;
}

}  // namespace

void read_rains(const TomlDocument& document, const TomlValue* rains,
                const std::filesystem::path& folder, Scene& scene, Diagnostics& diagnostics) {
    const RainContext context{folder, discs_of(scene), diagnostics};
    for_each_table(document, rains, "rain", [&](const TomlValue& value, std::size_t number) {
        Table table(document, value, fmt::format("rain {}", number));
        scene.rains.push_back(read_rain(table, number, context));
    });
}

}  // namespace dewbow::toml_import
