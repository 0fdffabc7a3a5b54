// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/sky.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "dewbow/import/toml/table.h"
#include "dewbow/sky/clear_sky.h"
#include "dewbow/sky/cloud_bank.h"
#include "dewbow/sky/night.h"
#include "dewbow/sky/overcast.h"
#include "dewbow/sky/sight_line.h"
#include "dewbow/sky/sun_position.h"
#include "dewbow/sky/sunlight.h"
#include "dewbow/spectrum/illuminant.h"

namespace dewbow::toml_import {
namespace {

enum class SkyKind { clear, overcast, night };
const std::array<std::string, 3> kKindWords = {"clear", "overcast", "night"};

constexpr Range kAltitudes_deg{-90.0, 90.0};
constexpr Range kAzimuths_deg{-360.0, 360.0};
constexpr Range kLatitudes_deg{-90.0, 90.0};
constexpr Range kLongitudes_deg{-180.0, 180.0};
constexpr Range kUtcOffsets_h{-14.0, 14.0};
constexpr Range kPhases_deg{0.0, 97.0};
constexpr Range kVisibilities_km{1.0, 330.0};
constexpr Range kWidths_deg{0.0, 360.0, true, false};

/// Sun or moon, as it is asked for.
struct Body {
    SkyPosition position;
    SpectrumPtr above_atmosphere;
    Angle radius;
};

SkyPosition read_position(Table& table) {
    const double altitude = table.require_number("altitude_deg", kAltitudes_deg);
    const double azimuth = table.require_number("azimuth_deg", kAzimuths_deg);
    return {altitude * unit::deg, azimuth * unit::deg};
}

SkyPosition read_date_and_place(Table& table) {
    const std::string& date = read_text(table.document(), table.require("date"), "date");
    const TomlValue& clock = table.require("time");
    const std::string& time = read_text(table.document(), clock, "time");
    const double offset = table.number("utc_offset_h", kUtcOffsets_h, 0.0);
    const Place place{table.require_number("latitude_deg", kLatitudes_deg) * unit::deg,
                      table.require_number("longitude_deg", kLongitudes_deg) * unit::deg};
    return at_place(table.document(), table.require("date").place,
                    [&] { return sun_position(parse_date_time(date, time, offset), place); });
}

[[noreturn]] void fail_below_horizon(const Table& table, const SkyPosition& position) {
    const std::string who = table.title() == "sky.moon" ? "the moon" : "the sun";
    table.fail_here(
        fmt::format("puts {} {:.2f}° below the horizon", who, -position.altitude.to(unit::deg)),
        who == "the sun" ? "for moonlight or starlight write kind = \"night\" and no sun"
                         : "without a moon the stars and the airglow are left");
}

Body read_sun(const TomlDocument& document, const TomlValue& value) {
    Table table(document, value, "sky.sun");
    table.at_most_one_of({"date", "altitude_deg"});
    Body sun;
    const bool by_date = table.find("date") || table.find("time") || table.find("latitude_deg") ||
                         table.find("longitude_deg");
    sun.position = by_date ? read_date_and_place(table) : read_position(table);
    table.finish();
    if (sun.position.altitude < Angle{}) fail_below_horizon(table, sun.position);
    sun.above_atmosphere = make_sunlight_above(sun.position.distance);
    sun.radius = kSunRadius;
    return sun;
}

Body read_moon(const TomlDocument& document, const TomlValue& value) {
    Table table(document, value, "sky.moon");
    Body moon;
    moon.position = read_position(table);
    const double phase_deg = table.number("phase_deg", kPhases_deg, 0.0);
    table.finish();
    if (moon.position.altitude < Angle{}) fail_below_horizon(table, moon.position);
    moon.above_atmosphere = make_moonlight_above(phase_deg * unit::deg);
    moon.radius = kMoonRadius;
    return moon;
}

ClearSky read_air(Table& table) {
    ClearSky air;
    air.pressure_hPa = table.number("pressure_hPa", {100.0, 1100.0}, air.pressure_hPa);
    air.angstrom_exponent = table.number("angstrom_exponent", {-1.0, 4.0}, air.angstrom_exponent);
    air.aerosol_albedo = table.number("aerosol_albedo", kShareRange, air.aerosol_albedo);
    air.aerosol_asymmetry = table.number("aerosol_asymmetry", {0.0, 0.8}, air.aerosol_asymmetry);
    air.ozone_dobson = table.number("ozone_dobson", {0.0, 700.0}, air.ozone_dobson);
    air.ground_albedo = table.number("ground_albedo", kShareRange, air.ground_albedo);
    air.eye_height_m = table.number("eye_height_m", {0.0, 12e3}, air.eye_height_m);
    table.at_most_one_of({"visibility_km", "aerosol_depth"});
    air.aerosol_depth_500nm = table.number("aerosol_depth", {0.0, 5.0}, air.aerosol_depth_500nm);
    if (const TomlValue* visibility = table.find("visibility_km")) {
        const double km =
            read_number(table.document(), *visibility, "visibility_km", kVisibilities_km);
        air.aerosol_depth_500nm = at_place(table.document(), visibility->place, [&] {
            return aerosol_depth_from_visibility(1000.0 * km * unit::m, air);
        });
    }
    return air;
}

CloudBank read_cloud(const TomlDocument& document, const TomlValue& value) {
    Table table(document, value, "sky.cloud");
    CloudBank cloud;
    cloud.width = table.number("width_deg", kWidths_deg, cloud.width.to(unit::deg)) * unit::deg;
    const bool all_around = cloud.width == 360.0 * unit::deg;
    cloud.azimuth = (all_around ? table.number("azimuth_deg", kAzimuths_deg, 0.0)
                                : table.require_number("azimuth_deg", kAzimuths_deg)) *
                    unit::deg;
    cloud.bottom = table.number("bottom_deg", kAltitudes_deg, -90.0) * unit::deg;
    cloud.top = table.number("top_deg", kAltitudes_deg, 90.0) * unit::deg;
    cloud.softness =
        table.number("softness_deg", {0.0, 60.0}, cloud.softness.to(unit::deg)) * unit::deg;
    cloud.luminance_share = table.number("luminance_share", {0.0, 2.0}, cloud.luminance_share);
    cloud.cover = table.number("cover", kShareRange, cloud.cover);
    cloud.texture = table.number("texture", kShareRange, cloud.texture);
    cloud.seed =
        std::uint64_t(table.integer("seed", 0, std::numeric_limits<std::int64_t>::max(), 0));
    table.finish();
    at_place(document, value.place, [&] {
        validate(cloud);
        return 0;
    });
    return cloud;
}

/// A sky without its sun or moon, and the air that belongs to it.
struct Dome {
    SkyDomePtr light;
    AerialPtr aerial;
    SpectrumPtr on_cloud;  ///< the colour of what falls on a cloud
};

/// On a ball, on average: a quarter of the direct light and half of what falls on level ground from
/// the sky; in steps that are coarser than the sun's lines.
SpectrumPtr light_on_cloud(const Body& body, const ClearSky& air, const Spectrum& diffuse) {
    const SpectrumPtr direct =
        make_direct_sunlight(body.above_atmosphere, body.position.altitude, air);
    constexpr double kStep_nm = 10.0;
    std::vector<double> lambda_nm, values;
    for (double nm = kLambdaMin_nm; nm <= kLambdaMax_nm; nm += kStep_nm) {
        lambda_nm.push_back(nm);
        values.push_back(0.25 * (*direct)(nm * unit::nm) + 0.5 * diffuse(nm * unit::nm));
    }
    return make_tabulated(std::move(lambda_nm), std::move(values), OutsideTable::hold);
}

Dome make_dome(SkyKind kind, const std::optional<Body>& body, const ClearSky& air) {
    if (kind == SkyKind::overcast)
        return {make_overcast_dome(body->position.altitude, air.ground_albedo), nullptr,
                find_illuminant("D65")};
    if (!body) return {make_moonless_dome(air), nullptr, find_illuminant("D65")};
    const auto clear = make_clear_sky_dome(
        air, direction_to(body->position.altitude, body->position.azimuth), body->above_atmosphere);
    const SpectrumPtr on_cloud = light_on_cloud(*body, air, *clear->diffuse_irradiance());
    if (kind == SkyKind::clear) return {clear, clear->aerial(), on_cloud};
    return {make_sum_of_domes(clear, make_moonless_dome(air)), clear->aerial(), on_cloud};
}

class SkyReader {
public:
    SkyReader(const TomlDocument& document, const TomlValue& value)
        : document_(document), table_(document, value, "[sky]") {}

    void read(Scene& scene) {
        read_body();
        ClearSky air;
        if (kind_ == SkyKind::overcast)
            air.ground_albedo = table_.number("ground_albedo", kShareRange, air.ground_albedo);
        else
            air = read_air(table_);
        Dome dome =
            at_place(document_, table_.place(), [&] { return make_dome(kind_, body_, air); });
        std::optional<CloudBank> cloud;
        if (const TomlValue* value = table_.find("cloud")) {
            cloud = read_cloud(document_, *value);
            if (kind_ != SkyKind::overcast)
                cloud->horizon = -dip_of_horizon(air.eye_height_m) * unit::rad;
            dome.light = make_cloud_bank_dome(dome.light, *cloud, dome.on_cloud);
        }
        read_aerial(dome.aerial, scene);
        table_.finish();
        scene.lights.push_back(dome.light);
        if (body_ && kind_ != SkyKind::overcast) add_disc(air, cloud, scene);
    }

private:
    /// `kind`, and the sun or moon that it has.
    void read_body() {
        table_.at_most_one_of({"sun", "moon"});
        const TomlValue* sun = table_.find("sun");
        const TomlValue* moon = table_.find("moon");
        kind_ = moon ? SkyKind::night : SkyKind::clear;
        table_.word("kind", kKindWords, kind_);
        if (kind_ == SkyKind::night && sun)
            table_.fail_here("is a night and has a sun", "write moon = {…}, or neither");
        if (kind_ != SkyKind::night && moon)
            table_.fail_here(fmt::format("is {} and has a moon", kKindWords[std::size_t(kind_)]),
                             "write kind = \"night\"");
        if (kind_ != SkyKind::night && !sun)
            table_.fail_missing({"sun"},
                                "needs sun = { altitude_deg, azimuth_deg } or sun = { "
                                "date, time, latitude_deg, longitude_deg }");
        if (sun) body_ = read_sun(document_, *sun);
        if (moon) body_ = read_moon(document_, *moon);
    }

    void read_aerial(const AerialPtr& aerial, Scene& scene) {
        if (!table_.boolean("aerial_perspective", aerial != nullptr)) return;
        if (!aerial)
            table_.fail_here("has no air whose veil is known",
                             "aerial_perspective is for clear skies with a sun or a moon");
        scene.aerial = aerial;
    }

    /// Sun or moon, as much of it as the air and a bank of cloud before it let through.
    void add_disc(const ClearSky& air, const std::optional<CloudBank>& cloud, Scene& scene) const {
        const SkyPosition& at = body_->position;
        const Dir<World> towards = direction_to(at.altitude, at.azimuth);
        const double share = cloud ? 1.0 - cover_towards(*cloud, towards) : 1.0;
        if (share == 0.0) return;
        const SpectrumPtr arrives = make_direct_sunlight(body_->above_atmosphere, at.altitude, air);
        scene.lights.push_back(DistantLight{-towards, body_->radius, make_scaled(arrives, share)});
    }

    const TomlDocument& document_;
    Table table_;
    SkyKind kind_ = SkyKind::clear;
    std::optional<Body> body_;
};

}  // namespace

void read_sky(const TomlDocument& document, const TomlValue& value, Scene& scene) {
    SkyReader(document, value).read(scene);
}

}  // namespace dewbow::toml_import
