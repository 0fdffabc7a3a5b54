// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/mesh_file.h"

#include <fmt/format.h>

#include "dewbow/base/file.h"
#include "dewbow/import/extension.h"
#include "dewbow/import/mesh/clean.h"
#include "dewbow/import/mesh/obj.h"
#include "dewbow/import/mesh/ply.h"

namespace dewbow {
namespace {

/// Reflectance of a surface that a file says nothing about: a photographer's mid to light grey.
constexpr double kNeutralGrey = 0.6;

Mesh parse(const std::filesystem::path& path, Diagnostics& diagnostics) {
    const std::string extension = extension_of(path);
    const std::string file = path.string();
    if (extension == ".obj") return parse_obj(file, read_file(path), diagnostics);
    if (extension == ".ply") return parse_ply(file, read_file(path));
    throw InputError({file, 0, 0, {}},
                     fmt::format("\"{}\" is no mesh format that is read", extension), {},
                     "expected .obj or .ply");
}

std::string sentence_of_nothing_left(const MeshRepairs& repairs) {
    if (repairs.bad_vertex_triangles == 0) return "has no triangle with an area";
    return fmt::format(
        "has no triangle that can be shown: {} with a vertex that is not finite, {} without area",
        repairs.bad_vertex_triangles, repairs.flat_triangles);
}

}  // namespace

const std::vector<std::string>& mesh_extensions() {
    static const std::vector<std::string> extensions = {".obj", ".ply"};
    return extensions;
}

std::shared_ptr<const Mesh> load_mesh(const std::filesystem::path& path, Diagnostics& diagnostics) {
    auto mesh = std::make_shared<Mesh>(parse(path, diagnostics));
    const SourcePlace place{path.string(), 0, 0, {}};
    if (mesh->triangles.empty()) throw InputError(place, "holds no triangle");
    const MeshRepairs repairs = clean(*mesh);
    repairs.report(place, diagnostics);
    if (mesh->triangles.empty()) throw InputError(place, sentence_of_nothing_left(repairs));
    mesh->name = path.stem().string();
    return mesh;
}

ParsedScene load_mesh_scene(const std::filesystem::path& path) {
    ParsedScene parsed;
    parsed.scene = make_empty_scene();
    Shape shape;
    const auto mesh = load_mesh(path, parsed.diagnostics);
    shape.name = mesh->name;
    shape.geometry = mesh;
    shape.material =
        parsed.scene.add({"default", Diffuse{make_constant(kNeutralGrey)}, nullptr, false});
    parsed.scene.shapes.push_back(std::move(shape));
    return parsed;
}

}  // namespace dewbow
