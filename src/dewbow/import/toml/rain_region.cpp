// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/rain_region.h"

#include <fmt/format.h>

#include "dewbow/base/file.h"
#include "dewbow/import/mesh/mesh_file.h"
#include "dewbow/import/toml/placement.h"
#include "dewbow/import/toml/table.h"

namespace dewbow::toml_import {
namespace {

using Region = std::variant<ConvexRegion, MeshRegion>;

/// From below the Dead Sea to above all weather.
constexpr Range kHeights_m{-1e5, 1e5};

struct RegionContext {
    const std::filesystem::path& folder;
    Diagnostics& diagnostics;
};

struct Heights {
    Length bottom, top;
};
Heights read_heights(Table& table) {
    const double bottom = table.require_number("bottom_m", kHeights_m);
    const double top = table.require_number("top_m", kHeights_m);
    if (!(bottom < top))
        table.fail_here(fmt::format(
            "goes from bottom_m = {} up to top_m = {}: no rain fits between", bottom, top));
    return {bottom * unit::m, top * unit::m};
}

Region read_layer(Table& table, RegionContext&) {
    const Heights heights = read_heights(table);
    return ConvexRegion::layer(heights.bottom, heights.top);
}

Region read_box(Table& table, RegionContext&) {
    const Vec3 half{0.5 * table.require_length("width").to(unit::m),
                    0.5 * table.require_length("height").to(unit::m),
                    0.5 * table.require_length("depth").to(unit::m)};
    const Affine placed = read_placement(table, true);
    // A scale belongs to the box, not to its frame.
    const Vec3 scale{length(placed.apply_linear({1.0, 0.0, 0.0})),
                     length(placed.apply_linear({0.0, 1.0, 0.0})),
                     length(placed.apply_linear({0.0, 0.0, 1.0}))};
    const Affine rigid = placed * scaling({1.0 / scale.x, 1.0 / scale.y, 1.0 / scale.z});
    return ConvexRegion::box(Transform<World, Object>(rigid),
                             {half.x * scale.x, half.y * scale.y, half.z * scale.z});
}

Region read_curtain(Table& table, RegionContext&) {
    const Vec3 from = table.require_point("from"), to = table.require_point("to");
    const Length thickness = table.require_length("thickness");
    const Heights heights = read_heights(table);
    if (from.x == to.x && from.z == to.z)
        table.fail_here("goes from a point to the same point of the map");
    return ConvexRegion::curtain({from}, {to}, thickness, heights.bottom, heights.top);
}

Region read_mesh(Table& table, RegionContext& context) {
    const TomlValue& value = table.require("file");
    const std::string& reference = read_text(table.document(), value, "file");
    auto mesh = at_place(table.document(), value.place, [&] {
        return load_mesh(resolve_inside(context.folder, reference), context.diagnostics);
    });
    return MeshRegion{std::move(mesh), Transform<World, Object>(read_placement(table, true))};
}

struct RegionType {
    std::string name;
    Region (*read)(Table&, RegionContext&);
};
const std::vector<RegionType>& region_types() {
    static const std::vector<RegionType> types = {
        {"layer", read_layer}, {"box", read_box}, {"curtain", read_curtain}, {"mesh", read_mesh}};
    return types;
}

}  // namespace

Region read_rain_region(const TomlDocument& document, const TomlValue& value,
                        const std::filesystem::path& folder, Diagnostics& diagnostics) {
    static const std::vector<std::string> kWords = {"everywhere"};
    if (!value.table()) {
        read_choice(document, value, "region", kWords);
        return ConvexRegion::everywhere();
    }
    Table table(document, value, "region");
    std::vector<std::string> names;
    for (const RegionType& type : region_types()) names.push_back(type.name);
    const TomlValue& type = table.require("type");
    RegionContext context{folder, diagnostics};
    Region region =
        region_types()[read_choice(document, type, "region type", names)].read(table, context);
    table.finish();
    return region;
}

}  // namespace dewbow::toml_import
