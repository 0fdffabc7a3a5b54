// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/mesh_file.h"

#include <fmt/format.h>

#include "dewbow/base/file.h"
#include "dewbow/import/extension.h"
#include "dewbow/import/mesh/clean.h"
#include "dewbow/import/mesh/obj.h"
#include "dewbow/import/mesh/obj_scene.h"
#include "dewbow/import/mesh/ply.h"
#include "dewbow/import/mesh/stl.h"

namespace dewbow {
namespace {

/// OBJ, PLY or STL, by the extension.
Mesh parse(const std::filesystem::path& path, Diagnostics& diagnostics) {
    const std::string extension = extension_of(path);
    const std::string file = path.string();
    if (extension == ".ply") return parse_ply(file, read_file(path), diagnostics);
    if (extension == ".stl") return parse_stl(file, read_file(path), diagnostics);
    if (extension != ".obj")
        throw InputError({file, 0, 0, {}},
                         fmt::format("\"{}\" is no mesh format that is read", extension), {},
                         "expected .obj, .ply or .stl");
    ObjModel model = parse_obj(file, read_file(path), ObjDivision::none, diagnostics);
    return model.parts.empty() ? Mesh{} : std::move(model.parts.front().mesh);
}

}  // namespace

const std::vector<std::string>& mesh_extensions() {
    static const std::vector<std::string> extensions = {".obj", ".ply", ".stl"};
    return extensions;
}

std::shared_ptr<const Mesh> load_mesh(const std::filesystem::path& path, Diagnostics& diagnostics) {
    auto mesh = std::make_shared<Mesh>(parse(path, diagnostics));
    const SourcePlace place{path.string(), 0, 0, {}};
    if (mesh->triangles.empty()) throw InputError(place, "holds no triangle");
    const MeshRepairs repairs = clean(*mesh);
    repairs.report(place, diagnostics);
    if (mesh->triangles.empty()) throw InputError(place, repairs.sentence_of_nothing_left());
    mesh->name = path.stem().string();
    return mesh;
}

ParsedScene load_mesh_scene(const std::filesystem::path& path) {
    if (extension_of(path) == ".obj") return load_obj_scene(path);
    ParsedScene parsed;
    parsed.scene = make_empty_scene();
    Shape shape;
    const auto mesh = load_mesh(path, parsed.diagnostics);
    shape.name = mesh->name;
    shape.geometry = mesh;
    shape.material = parsed.scene.add(default_material(!mesh->colours.empty()));
    parsed.scene.shapes.push_back(std::move(shape));
    return parsed;
}

}  // namespace dewbow
