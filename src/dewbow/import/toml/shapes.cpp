// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/shapes.h"

#include <fmt/format.h>

#include "dewbow/base/file.h"
#include "dewbow/import/mesh/mesh_file.h"
#include "dewbow/import/toml/placement.h"
#include "dewbow/import/toml/tables.h"
#include "dewbow/import/toml/terrain.h"

namespace dewbow::toml_import {
namespace {

constexpr Range kApexRange_deg{0.01, 179.99};

struct ShapeContext {
    const std::filesystem::path& folder;
    Diagnostics& diagnostics;
    std::unordered_map<std::string, std::shared_ptr<const Mesh>> meshes;  ///< by path
};

Geometry read_sphere(Table& table, ShapeContext&) { return Sphere{table.require_length("radius")}; }
Geometry read_disc(Table& table, ShapeContext&) { return Disc{table.require_length("radius")}; }
Geometry read_rectangle(Table& table, ShapeContext&) {
    return Rectangle{table.require_length("width"), table.require_length("height")};
}
Geometry read_box(Table& table, ShapeContext&) {
    return Box{table.require_length("width"), table.require_length("height"),
               table.require_length("depth")};
}
Geometry read_prism(Table& table, ShapeContext&) {
    return Prism{table.require_number("apex_deg", kApexRange_deg) * unit::deg,
                 table.require_length("side"), table.require_length("length")};
}
Geometry read_plane(Table&, ShapeContext&) { return Plane{}; }
Geometry read_terrain_mesh(Table& table, ShapeContext&) {
    return make_terrain(read_terrain(table));
}

Geometry read_mesh(Table& table, ShapeContext& context) {
    const TomlValue& value = table.require("file");
    const std::string& reference = read_text(table.document(), value, "file");
    return at_place(table.document(), value.place, [&]() -> Geometry {
        const std::filesystem::path path = resolve_inside(context.folder, reference);
        auto& mesh = context.meshes[path.string()];
        if (!mesh) mesh = load_mesh(path, context.diagnostics);
        return mesh;
    });
}

struct ShapeType {
    std::string name;
    Geometry (*read)(Table&, ShapeContext&);
};

const std::vector<ShapeType>& shape_types() {
    static const std::vector<ShapeType> types = {
        {"sphere", read_sphere},       {"disc", read_disc},
        {"rectangle", read_rectangle}, {"box", read_box},
        {"prism", read_prism},         {"plane", read_plane},
        {"mesh", read_mesh},           {"terrain", read_terrain_mesh},
    };
    return types;
}

const ShapeType& read_type(Table& table) {
    std::vector<std::string> names;
    for (const ShapeType& type : shape_types()) names.push_back(type.name);
    const TomlValue& value = table.require("type");
    return shape_types()[read_choice(table.document(), value, "shape type", names)];
}

Shape read_shape(Table& table, std::size_t number, const MaterialNames& names,
                 ShapeContext& context) {
    const ShapeType& type = read_type(table);
    Shape shape;
    shape.name = table.text("name", fmt::format("{} {}", type.name, number));
    shape.geometry = type.read(table, context);
    shape.material = names.read(table.document(), table.require("material"), "material");
    shape.world_from_object = Transform<World, Object>(read_placement(table, true));
    return shape;
}

}  // namespace

void read_shapes(const TomlDocument& document, const TomlValue* shapes, const MaterialNames& names,
                 const std::filesystem::path& folder, Scene& scene, Groups& groups,
                 Diagnostics& diagnostics) {
    ShapeContext context{folder, diagnostics, {}};
    Mirrors mirrors;
    for_each_table(document, shapes, "shapes", [&](const TomlValue& value, std::size_t number) {
        Table table(document, value, fmt::format("shape {}", number));
        const Groups::Mark mark = Groups::mark(scene);
        scene.shapes.push_back(mirrors.upright(read_shape(table, number, names, context)));
        groups.take(table, scene, mark);
        table.finish();
    });
}

}  // namespace dewbow::toml_import
