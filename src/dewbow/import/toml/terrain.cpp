// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/terrain.h"

#include <fmt/format.h>

#include <limits>

namespace dewbow::toml_import {
namespace {

constexpr Range kAzimuthRange_deg{-360.0, 360.0};
constexpr Range kFinerRange{1.0, 1000.0};
constexpr int kLeastCells = 2;

Valley read_valley(const TomlDocument& document, const TomlValue& value) {
    Table table(document, value, "valley");
    Valley valley;
    valley.azimuth = table.number("azimuth_deg", kAzimuthRange_deg, 0.0) * unit::deg;
    valley.width = table.require_length("width");
    valley.depth = table.number("depth", kShareRange, valley.depth);
    table.finish();
    return valley;
}

std::vector<std::array<float, 3>> read_colours(const TomlDocument& document,
                                               const TomlValue& value) {
    const TomlValue::Array* array = value.array();
    if (!array || array->empty())
        fail(document, value.place,
             fmt::format("colours is {}; expected [[r, g, b], …]", describe(value)));
    std::vector<std::array<float, 3>> colours;
    for (std::size_t i = 0; i < array->size(); ++i) {
        const auto rgb =
            read_numbers(document, (*array)[i], fmt::format("colours[{}]", i), kShareRange, 3);
        colours.push_back({float(rgb[0]), float(rgb[1]), float(rgb[2])});
    }
    return colours;
}

}  // namespace

Terrain read_terrain(Table& table) {
    Terrain terrain;
    terrain.size = table.require_length("size");
    terrain.height = table.require_length("height");
    terrain.feature = table.find_length("feature").value_or(terrain.size * 0.25);
    terrain.roughness = table.number("roughness", kShareRange, terrain.roughness);
    terrain.seed =
        std::uint64_t(table.integer("seed", 0, std::numeric_limits<std::int64_t>::max(), 0));
    terrain.cells = int(table.integer("cells", kLeastCells, kMostTerrainCells, terrain.cells));
    terrain.middle_finer = table.number("middle_finer", kFinerRange, terrain.middle_finer);
    terrain.island = table.boolean("island", false);
    if (const TomlValue* valley = table.find("valley"))
        terrain.valley = read_valley(table.document(), *valley);
    if (const TomlValue* colours = table.find("colours"))
        terrain.colours = read_colours(table.document(), *colours);
    terrain.mottling = table.number("mottling", kShareRange, terrain.mottling);
    return terrain;
}

}  // namespace dewbow::toml_import
