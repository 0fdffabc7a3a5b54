// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/scene_toml.h"

#include <fmt/format.h>

#include "dewbow/base/file.h"
#include "dewbow/import/toml/glass.h"
#include "dewbow/import/toml/imports.h"
#include "dewbow/import/toml/lights.h"
#include "dewbow/import/toml/materials.h"
#include "dewbow/import/toml/shapes.h"
#include "dewbow/import/toml/view.h"

namespace dewbow {
namespace {

using namespace toml_import;

constexpr std::uint64_t kMaxTomlBytes = std::uint64_t{64} << 20;

const PerspectiveCamera& imported_camera(const TomlDocument& document, const TomlValue& from,
                                         const std::vector<Import>& imports) {
    const std::string& name = read_text(document, from, "from");
    std::vector<std::string> names;
    for (const Import& import : imports) {
        names.push_back(import.name);
        if (import.name != name) continue;
        if (!import.camera)
            fail(document, from.place, fmt::format("import \"{}\" has no camera", name));
        return *import.camera;
    }
    fail(document, from.place, fmt::format("there is no import \"{}\"", name),
         hint_for(name, names));
}

void read_camera_table(const TomlDocument& document, const TomlValue* value,
                       const std::vector<Import>& imports, ParsedScene& parsed) {
    if (value) {
        Table table(document, *value, "[camera]");
        const TomlValue* from = table.find("from");
        parsed.scene.camera = from ? imported_camera(document, *from, imports) : read_camera(table);
        parsed.has_camera = true;
        table.finish();
        return;
    }
    for (const Import& import : imports) {
        if (!import.camera || parsed.has_camera) continue;
        parsed.scene.camera = *import.camera;
        parsed.has_camera = true;
    }
}

void read_surroundings(const TomlDocument& document, const TomlValue* value, Scene& scene) {
    if (!value) return;
    Table table(document, *value, "[surroundings]");
    scene.surroundings = read_medium(table, "surroundings", scene.surroundings->priority);
    table.finish();
}

/// A scene that is lit by an import alone has the import's white, unless it states its own.
void adopt_white(const TomlValue* film, bool lit_itself, const std::vector<Import>& imports,
                 Scene& scene) {
    if (lit_itself) return;
    if (film && film->table()) {
        for (const TomlEntry& entry : *film->table()) {
            if (entry.key == "white_luminance_cd_m2") return;
        }
    }
    for (const Import& import : imports) {
        if (!import.lit) continue;
        scene.film.white_luminance = import.white_luminance;
        return;
    }
}

}  // namespace

ParsedScene parse_scene_toml(const std::filesystem::path& path, std::string text) {
    const TomlDocument document = parse_toml(path.string(), std::move(text));
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    ParsedScene parsed;
    parsed.scene = make_empty_scene();
    Scene& scene = parsed.scene;

    Table root(document, document.root, "the scene file");
    const TomlValue* film = root.find("film");
    read_film(document, film, scene.film);
    read_render(document, root.find("render"), scene.render);
    read_surroundings(document, root.find("surroundings"), scene);
    const MaterialNames names = read_materials(document, root.find("materials"), scene);
    read_shapes(document, root.find("shapes"), names, folder, scene, parsed.diagnostics);
    read_lights(document, root.find("lights"), folder, scene, parsed.diagnostics);
    const bool lit_itself = brings_light(scene);
    const auto imports =
        read_imports(document, root.find("imports"), names, folder, scene, parsed.diagnostics);
    adopt_white(film, lit_itself, imports, scene);
    read_camera_table(document, root.find("camera"), imports, parsed);
    root.finish();
    return parsed;
}

ParsedScene load_toml(const std::filesystem::path& path) {
    std::string text = read_file(path, kMaxTomlBytes);
    if (text.empty()) throw InputError(SourcePlace{path.string(), 0, 0, {}}, "the file is empty");
    return parse_scene_toml(path, std::move(text));
}

}  // namespace dewbow
