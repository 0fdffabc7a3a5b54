// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/lights.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "dewbow/base/file.h"
#include "dewbow/import/environment_picture.h"
#include "dewbow/import/ies/ies.h"
#include "dewbow/import/toml/spectra.h"
#include "dewbow/import/toml/tables.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"

namespace dewbow::toml_import {
namespace {

constexpr Range kOuterRange_deg{0.0, 90.0, true, false};
constexpr Range kRadiusRange_deg{0.0, 90.0};
constexpr Range kTurnRange_deg{-1e6, 1e6};
constexpr Range kPowerRange{0.0, kHuge};
/// Larger than any photometric file, which takes some hundred kilobytes.
constexpr std::uint64_t kMaxIesBytes = std::uint64_t{64} << 20;

struct LightContext {
    const std::filesystem::path& folder;
    Diagnostics& diagnostics;
};

SpectrumPtr require_spectrum(Table& table, std::string_view key, SpectrumUse use) {
    return read_spectrum(table.document(), table.require(key), key, use);
}

Light read_point(Table& table, LightContext&) {
    const Vec3 position = table.require_point("position");
    return PointLight{{position}, require_spectrum(table, "intensity", SpectrumUse::intensity)};
}

/// From `direction` or `look_at`, if one of them is there.
std::optional<Dir<World>> find_aim(Table& table, Vec3 position) {
    const TomlValue* direction = table.find("direction");
    if (const auto target = table.find_point("look_at")) {
        if (direction) table.fail_here("has both direction and look_at; keep one");
        if (!(length(*target - position) > 0.0)) table.fail_here("looks at its own position");
        return Dir<World>{normalised(*target - position)};
    }
    if (!direction) return std::nullopt;
    return Dir<World>{read_direction(table.document(), *direction, "direction")};
}

Dir<World> require_aim(Table& table, Vec3 position) {
    const std::optional<Dir<World>> aim = find_aim(table, position);
    if (!aim) table.fail_here("needs direction or look_at");
    return *aim;
}

/// `spectrum`, of which only the shape counts, or D65.
SpectrumPtr shape_of_light(Table& table) {
    const TomlValue* value = table.find("spectrum");
    return value ? read_spectrum(table.document(), *value, "spectrum", SpectrumUse::intensity)
                 : find_illuminant("D65");
}

Light read_spot(Table& table, LightContext&) {
    SpotLight spot;
    spot.position = {table.require_point("position")};
    spot.direction = require_aim(table, spot.position.v);
    const double outer_deg = table.require_number("outer_deg", kOuterRange_deg);
    spot.outer = outer_deg * unit::deg;
    spot.inner = table.number("inner_deg", {0.0, outer_deg, false, true}, 0.0) * unit::deg;
    spot.intensity = require_spectrum(table, "intensity", SpectrumUse::intensity);
    return spot;
}

/// A rotation that turns a web's nadir (−y) to `nadir`, after a turn about its axis.
Affine web_rotation(Vec3 nadir, Angle turn) {
    const Vec3 down{0.0, -1.0, 0.0}, across = cross(down, nadir);
    const double sine = length(across), cosine = dot(down, nadir);
    // Straight up or down any level axis will do.
    const Vec3 axis = sine > 0.0 ? across / sine : Vec3{1.0, 0.0, 0.0};
    return rotation(axis, std::atan2(sine, cosine) * unit::rad) * rotation({0.0, 1.0, 0.0}, turn);
}

IesFile read_ies(Table& table, LightContext& context) {
    const TomlValue& file = table.require("file");
    const std::string& reference = read_text(table.document(), file, "file");
    IesFile ies = at_place(table.document(), file.place, [&] {
        const std::filesystem::path path = resolve_inside(context.folder, reference);
        return parse_ies(reference, read_file(path, kMaxIesBytes));
    });
    context.diagnostics.insert(context.diagnostics.end(), ies.diagnostics.begin(),
                               ies.diagnostics.end());
    return ies;
}

Light read_profile(Table& table, LightContext& context) {
    ProfileLight light;
    light.position = {table.require_point("position")};
    const Dir<World> nadir = find_aim(table, light.position.v).value_or(Dir<World>{{0, -1, 0}});
    const double turn_deg = table.number("rotate_deg", kTurnRange_deg, 0.0);
    light.world_from_object = Transform<World, Object>(web_rotation(nadir.v, turn_deg * unit::deg));
    light.web = read_ies(table, context).web;
    const SpectrumPtr shape = shape_of_light(table);
    const double own = kLuminousEfficacy * xyz_from_spectrum(*shape)[1];
    if (!(own > 0.0)) table.fail_here("has a spectrum that is black");
    table.at_most_one_of({"scale", "luminous_flux_lm"});
    double factor = table.number("scale", kAmountRange, 1.0);
    if (const auto flux = table.find_number("luminous_flux_lm", kAmountRange))
        factor = *flux / light.web->flux_lm();
    light.intensity_per_cd = make_scaled(shape, factor / own);
    return light;
}

/// ∫ over the visible range. Steps of a fifth of the narrowest line that scene files write.
double integral_over_lambda_nm(const Spectrum& spectrum) {
    constexpr double kStep_nm = 0.002;
    constexpr int kBlock = 500,
                  kBlocks = int((kLambdaMax_nm - kLambdaMin_nm) / (kStep_nm * kBlock));
    std::array<double, kBlock> lambda_nm, value;
    double sum = 0.0;
    for (int block = 0; block < kBlocks; ++block) {
        for (int i = 0; i < kBlock; ++i)
            lambda_nm[std::size_t(i)] = kLambdaMin_nm + (block * kBlock + i + 0.5) * kStep_nm;
        spectrum.eval_lanes(lambda_nm, value);
        for (const double v : value) sum += v * kStep_nm;
    }
    return sum;
}

Light read_beam(Table& table, LightContext&) {
    BeamLight beam;
    beam.position = {table.require_point("position")};
    beam.direction = require_aim(table, beam.position.v);
    beam.radius = table.require_length("radius");
    table.at_most_one_of({"irradiance", "power_W"});
    const auto power_W = table.find_number("power_W", kPowerRange);
    if (!power_W) {
        if (!table.find("irradiance")) table.fail_here("needs irradiance or power_W");
        beam.irradiance = require_spectrum(table, "irradiance", SpectrumUse::irradiance);
        return beam;
    }
    const SpectrumPtr shape = shape_of_light(table);
    const double own = integral_over_lambda_nm(*shape);
    if (!(own > 0.0)) table.fail_here("has a spectrum that is black");
    const double area_m2 = std::numbers::pi * std::pow(beam.radius.to(unit::m), 2.0);
    beam.irradiance = make_scaled(shape, *power_W / (own * area_m2));
    return beam;
}

Light read_distant(Table& table, LightContext&) {
    const Vec3 direction =
        read_direction(table.document(), table.require("direction"), "direction");
    const double radius_deg = table.number("angular_radius_deg", kRadiusRange_deg, 0.0);
    return DistantLight{{direction},
                        radius_deg * unit::deg,
                        require_spectrum(table, "irradiance", SpectrumUse::irradiance)};
}

void read_picture_settings(Table& table, ImageEnvironment& picture) {
    picture.scale = table.number("scale", kAmountRange, 1.0);
    const double turn_deg = table.number("rotate_y_deg", kTurnRange_deg, 0.0);
    picture.world_from_object =
        Transform<World, Object>(rotation({0.0, 1.0, 0.0}, turn_deg * unit::deg));
}

Light read_environment(Table& table, LightContext& context) {
    table.at_most_one_of({"radiance", "file"});
    const TomlValue* file = table.find("file");
    if (!file)
        return UniformEnvironment{require_spectrum(table, "radiance", SpectrumUse::radiance)};
    const std::string& reference = read_text(table.document(), *file, "file");
    const auto picture = at_place(table.document(), file->place, [&] {
        return load_environment(resolve_inside(context.folder, reference), context.diagnostics);
    });
    read_picture_settings(table, *picture);
    return std::shared_ptr<const ImageEnvironment>(picture);
}

Light read_studio(Table& table, LightContext&) {
    auto studio = std::make_shared<ImageEnvironment>(*make_studio_environment());
    read_picture_settings(table, *studio);
    return std::shared_ptr<const ImageEnvironment>(studio);
}

struct LightType {
    std::string name;
    Light (*read)(Table&, LightContext&);
};

const std::vector<LightType>& light_types() {
    static const std::vector<LightType> types = {
        {"point", read_point},   {"spot", read_spot},       {"profile", read_profile},
        {"beam", read_beam},     {"distant", read_distant}, {"environment", read_environment},
        {"studio", read_studio},
    };
    return types;
}

Light read_light(Table& table, LightContext& context) {
    std::vector<std::string> names;
    for (const LightType& type : light_types()) names.push_back(type.name);
    const TomlValue& value = table.require("type");
    return light_types()[read_choice(table.document(), value, "light type", names)].read(table,
                                                                                         context);
}

}  // namespace

void read_lights(const TomlDocument& document, const TomlValue* lights,
                 const std::filesystem::path& folder, Scene& scene, Diagnostics& diagnostics) {
    LightContext context{folder, diagnostics};
    for_each_table(document, lights, "lights", [&](const TomlValue& value, std::size_t number) {
        Table table(document, value, fmt::format("light {}", number));
        scene.lights.push_back(read_light(table, context));
        table.finish();
    });
}

}  // namespace dewbow::toml_import
