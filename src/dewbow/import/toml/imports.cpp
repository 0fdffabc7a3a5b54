// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/imports.h"

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/base/file.h"
#include "dewbow/import/extension.h"
#include "dewbow/import/gltf/gltf.h"
#include "dewbow/import/merge.h"
#include "dewbow/import/mesh/mesh_file.h"
#include "dewbow/import/toml/placement.h"
#include "dewbow/import/toml/tables.h"

namespace dewbow::toml_import {
namespace {

constexpr std::size_t kMaxImports = 1000;

ParsedScene load_guest(const std::filesystem::path& path) {
    const std::string extension = extension_of(path);
    if (extension == ".gltf" || extension == ".glb") return load_gltf(path);
    if (extension == ".toml") {
        throw InputError("a scene file imports no other scene file",
                         "import .gltf, .glb, .obj, .ply or .stl");
    }
    const auto& meshes = mesh_extensions();
    if (std::find(meshes.begin(), meshes.end(), extension) != meshes.end())
        return load_mesh_scene(path);
    throw InputError({path.string(), 0, 0, {}}, "this is of no format that is imported", {},
                     "import .gltf, .glb, .obj, .ply or .stl");
}

std::vector<MaterialOverride> read_overrides(Table& import, const Scene& guest,
                                             const MaterialNames& names) {
    std::vector<MaterialOverride> overrides;
    const TomlValue* value = import.find("materials");
    if (!value) return overrides;
    const TomlDocument& document = import.document();
    Table table(document, *value, "[imports.materials]");
    for (const Material& material : guest.materials) {
        const TomlValue* name = table.find(material.name);
        if (name) overrides.push_back({material.name, names.read(document, *name, material.name)});
    }
    table.finish();
    return overrides;
}

}  // namespace

std::vector<Import> read_imports(const TomlDocument& document, const TomlValue* imports,
                                 const MaterialNames& names, const std::filesystem::path& folder,
                                 Scene& scene, Groups& groups, Diagnostics& diagnostics) {
    std::vector<Import> result;
    for_each_table(document, imports, "imports", [&](const TomlValue& value, std::size_t number) {
        if (number > kMaxImports) fail(document, value.place, "there are more than 1000 imports");
        Table table(document, value, fmt::format("import {}", number));
        const TomlValue& file = table.require("file");
        const std::string& reference = read_text(document, file, "file");
        const ParsedScene guest = at_place(
            document, file.place, [&] { return load_guest(resolve_inside(folder, reference)); });
        const std::string name = table.text("name", reference);
        const bool taken = std::any_of(result.begin(), result.end(),
                                       [&](const Import& other) { return other.name == name; });
        if (taken && table.find("name"))
            table.fail_here(fmt::format("has the name of another: {}", name));
        const Affine placement = read_placement(table, false);
        const Groups::Mark mark = Groups::mark(scene);
        merge(scene, guest.scene, placement, read_overrides(table, guest.scene, names));
        groups.take(table, scene, mark);
        table.finish();

        Import import{name,
                      {},
                      guest.scene.film.white_luminance,
                      brings_light(guest.scene, guest.least_lamp_luminance)};
        for (const CameraView& camera : guest.scene.cameras) {
            import.cameras.push_back(moved(camera, placement));
            import.cameras.back().name = fmt::format("{}/{}", name, camera.name);
        }
        result.push_back(std::move(import));
        diagnostics.insert(diagnostics.end(), guest.diagnostics.begin(), guest.diagnostics.end());
    });
    return result;
}

}  // namespace dewbow::toml_import
