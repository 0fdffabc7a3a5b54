// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/lights.h"

#include <fmt/format.h>

#include "dewbow/base/file.h"
#include "dewbow/import/environment_picture.h"
#include "dewbow/import/toml/spectra.h"
#include "dewbow/import/toml/tables.h"

namespace dewbow::toml_import {
namespace {

constexpr Range kOuterRange_deg{0.0, 90.0, true, false};
constexpr Range kRadiusRange_deg{0.0, 90.0};
constexpr Range kTurnRange_deg{-1e6, 1e6};

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

Dir<World> spot_direction(Table& table, Vec3 position) {
    if (const auto target = table.find_point("look_at")) {
        if (table.find("direction")) table.fail_here("has both direction and look_at; keep one");
        if (!(length(*target - position) > 0.0)) table.fail_here("looks at its own position");
        return {normalised(*target - position)};
    }
    const TomlValue* direction = table.find("direction");
    if (!direction) table.fail_here("needs direction or look_at");
    return {read_direction(table.document(), *direction, "direction")};
}

Light read_spot(Table& table, LightContext&) {
    SpotLight spot;
    spot.position = {table.require_point("position")};
    spot.direction = spot_direction(table, spot.position.v);
    const double outer_deg = table.require_number("outer_deg", kOuterRange_deg);
    spot.outer = outer_deg * unit::deg;
    spot.inner = table.number("inner_deg", {0.0, outer_deg, false, true}, 0.0) * unit::deg;
    spot.intensity = require_spectrum(table, "intensity", SpectrumUse::intensity);
    return spot;
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
        {"point", read_point},     {"spot", read_spot},
        {"distant", read_distant}, {"environment", read_environment},
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
