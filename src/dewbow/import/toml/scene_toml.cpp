// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/scene_toml.h"

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/base/file.h"
#include "dewbow/import/toml/camera.h"
#include "dewbow/import/toml/glass.h"
#include "dewbow/import/toml/imports.h"
#include "dewbow/import/toml/lights.h"
#include "dewbow/import/toml/materials.h"
#include "dewbow/import/toml/paper_rainbow.h"
#include "dewbow/import/toml/rains.h"
#include "dewbow/import/toml/settings.h"
#include "dewbow/import/toml/shapes.h"
#include "dewbow/import/toml/sky.h"
#include "dewbow/import/toml/view.h"

namespace dewbow {
namespace {

using namespace toml_import;

constexpr std::uint64_t kMaxTomlBytes = std::uint64_t{64} << 20;

/// The camera "import/camera", or the first one of "import".
const CameraView& imported_camera(const TomlDocument& document, const TomlValue& from,
                                  const std::vector<Import>& imports) {
    const std::string& name = read_text(document, from, "from");
    std::vector<std::string> imported, offered;
    for (const Import& import : imports) {
        imported.push_back(import.name);
        for (const CameraView& camera : import.cameras) {
            offered.push_back(camera.name);
            if (import.name == name || camera.name == name) return camera;
        }
        if (import.name == name)
            fail(document, from.place, fmt::format("import \"{}\" has no camera", name));
    }
    if (name.find('/') != std::string::npos && !offered.empty())
        fail(document, from.place, fmt::format("there is no camera \"{}\"", name),
             hint_for(name, offered));
    fail(document, from.place, fmt::format("there is no import \"{}\"", name),
         hint_for(name, imported));
}

CameraView read_one_camera(Table& table, const std::string& name,
                           const std::vector<Import>& imports) {
    const TomlValue* from = table.find("from");
    CameraView camera =
        from ? imported_camera(table.document(), *from, imports) : read_camera(table, name);
    camera.name = name;
    table.finish();
    return camera;
}

/// [camera], [cameras.NAME] and those of the imports, in this order.
void read_cameras(const TomlDocument& document, const TomlValue* chosen, const TomlValue* others,
                  const std::vector<Import>& imports, ParsedScene& parsed) {
    if (chosen) {
        Table table(document, *chosen, "[camera]");
        offer_camera(parsed.scene, read_one_camera(table, "camera", imports));
        parsed.camera_stated = true;
    }
    if (others && !others->table())
        fail(document, others->place,
             fmt::format("cameras is {}; expected tables", describe(*others)),
             "write [cameras.NAME] above each");
    if (others) {
        for (const TomlEntry& entry : *others->table()) {
            if (chosen && entry.key == "camera")
                fail(document, entry.key_place, "[cameras.camera] has the name of [camera]",
                     "give it another name");
            Table table(document, entry.value, fmt::format("[cameras.{}]", entry.key));
            offer_camera(parsed.scene, read_one_camera(table, entry.key, imports));
        }
    }
    for (const Import& import : imports)
        for (const CameraView& camera : import.cameras) offer_camera(parsed.scene, camera);
}

void read_surroundings(const TomlDocument& document, const TomlValue* value, Scene& scene,
                       Diagnostics& diagnostics) {
    if (!value) return;
    Table table(document, *value, "[surroundings]");
    scene.surroundings =
        read_medium(table, "surroundings", scene.surroundings->priority, &diagnostics);
    table.finish();
}

bool states(const TomlValue* table, std::string_view key) {
    if (!table || !table->table()) return false;
    return std::any_of(table->table()->begin(), table->table()->end(),
                       [&](const TomlEntry& entry) { return entry.key == key; });
}

/// A scene that is lit by an import alone has the import's white, unless it states its own.
void adopt_white(const TomlValue* film, bool lit_itself, const std::vector<Import>& imports,
                 Scene& scene) {
    if (lit_itself) return;
    if (states(film, "white_luminance_cd_m2")) return;
    for (const Import& import : imports) {
        if (!import.lit) continue;
        scene.film.white_luminance = import.white_luminance;
        return;
    }
}

/// Skies go from a millionth to a million times of what a film is made for: one that states neither
/// its exposure nor its white is exposed by the picture.
void expose_for_sky(const TomlValue* film, Film& settings) {
    if (!states(film, "exposure_stops") && !states(film, "white_luminance_cd_m2"))
        settings.exposure = ExposureMode::automatic;
}

/// @param guest  what the first import holds, if it has been read.
ParsedScene read_document(const TomlDocument& document, const std::filesystem::path& path,
                          const ParsedScene* guest) {
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    ParsedScene parsed;
    parsed.scene = make_empty_scene();
    Scene& scene = parsed.scene;
    if (guest) {
        scene.film = guest->scene.film;
        parsed.least_lamp_luminance = guest->least_lamp_luminance;
    }

    Table root(document, document.root, "the scene file");
    const TomlValue* film = root.find("film");
    read_film(document, film, scene.film);
    read_render(document, root.find("render"), scene.render);
    read_surroundings(document, root.find("surroundings"), scene, parsed.diagnostics);
    const MaterialNames names =
        read_materials(document, root.find("materials"), folder, scene, parsed.diagnostics);
    Groups groups;
    read_shapes(document, root.find("shapes"), names, folder, scene, groups, parsed.diagnostics);
    read_lights(document, root.find("lights"), folder, scene, parsed.diagnostics);
    if (const TomlValue* sky = root.find("sky")) {
        read_sky(document, *sky, scene);
        expose_for_sky(film, scene.film);
    }
    scene.paper_rainbow = read_paper_rainbow(document, root.find("paper_rainbow"));
    const bool lit_itself = brings_light(scene) || groups.bring_light(scene);
    const ImportContext context{names, folder, guest};
    const auto imports =
        read_imports(document, root.find("imports"), context, scene, groups, parsed.diagnostics);
    read_instances(document, root.find("instances"), names, folder, groups, scene);
    read_rains(document, root.find("rain"), folder, scene, parsed.diagnostics);
    adopt_white(film, lit_itself, imports, scene);
    read_cameras(document, root.find("camera"), root.find("cameras"), imports, parsed);
    root.finish();
    return parsed;
}

}  // namespace

ParsedScene parse_scene_toml(const std::filesystem::path& path, std::string text,
                             const std::vector<std::string>& settings) {
    TomlDocument document = parse_toml(path.string(), std::move(text));
    apply_settings(document, settings);
    return read_document(document, path, nullptr);
}

ParsedScene with_settings(const std::filesystem::path& path, const ParsedScene& guest,
                          const std::vector<std::string>& settings) {
    const std::string name = path.filename().string();
    TomlValue import{TomlValue::Table{{"file", {}, {name, {}}}}, {}};
    TomlDocument document{path.string(), {}, {}, {}};
    document.root.value =
        TomlValue::Table{{"imports", {}, {TomlValue::Array{std::move(import)}, {}}}};
    apply_settings(document, settings);
    return read_document(document, path, &guest);
}

ParsedScene load_toml(const std::filesystem::path& path, const std::vector<std::string>& settings) {
    std::string text = read_file(path, kMaxTomlBytes);
    if (text.empty()) throw InputError(SourcePlace{path.string(), 0, 0, {}}, "the file is empty");
    return parse_scene_toml(path, std::move(text), settings);
}

}  // namespace dewbow
