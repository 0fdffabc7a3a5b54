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

/// What the import's file holds; read from it unless it has been.
ParsedScene guest_of(const TomlDocument& document, const TomlValue& file,
                     const ImportContext& context, bool is_first) {
    if (is_first && context.first) return *context.first;
    const std::string& reference = read_text(document, file, "file");
    return at_place(document, file.place,
                    [&] { return load_guest(resolve_inside(context.folder, reference)); });
}

/// The import's own part: its name, and its cameras where they stand.
Import describe_import(const std::string& name, const ParsedScene& guest, const Affine& placement,
                       bool alone) {
    Import import{name,
                  {},
                  guest.scene.film.white_luminance,
                  brings_light(guest.scene, guest.least_lamp_luminance)};
    for (const CameraView& camera : guest.scene.cameras) {
        import.cameras.push_back(moved(camera, placement));
        if (!alone) import.cameras.back().name = fmt::format("{}/{}", name, camera.name);
    }
    return import;
}

}  // namespace

std::vector<Import> read_imports(const TomlDocument& document, const TomlValue* imports,
                                 const ImportContext& context, Scene& scene, Groups& groups,
                                 Diagnostics& diagnostics) {
    std::vector<Import> result;
    for_each_table(document, imports, "imports", [&](const TomlValue& value, std::size_t number) {
        if (number > kMaxImports) fail(document, value.place, "there are more than 1000 imports");
        Table table(document, value, fmt::format("import {}", number));
        const TomlValue& file = table.require("file");
        const ParsedScene guest = guest_of(document, file, context, number == 1);
        const std::string name = table.text("name", read_text(document, file, "file"));
        const bool taken = std::any_of(result.begin(), result.end(),
                                       [&](const Import& other) { return other.name == name; });
        if (taken && table.find("name"))
            table.fail_here(fmt::format("has the name of another: {}", name));
        const Affine placement = read_placement(table, false);
        const Groups::Mark mark = Groups::mark(scene);
        merge(scene, guest.scene, placement, read_overrides(table, guest.scene, context.names));
        groups.take(table, scene, mark);
        table.finish();
        const bool alone = number == 1 && context.first != nullptr;
        result.push_back(describe_import(name, guest, placement, alone));
        diagnostics.insert(diagnostics.end(), guest.diagnostics.begin(), guest.diagnostics.end());
    });
    return result;
}

}  // namespace dewbow::toml_import
