// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/gltf.h"

#include <fmt/format.h>

#include "dewbow/base/file.h"
#include "dewbow/import/gltf/cameras.h"
#include "dewbow/import/gltf/lights.h"
#include "dewbow/import/gltf/materials.h"
#include "dewbow/import/gltf/primitive.h"

namespace dewbow {
namespace {

using namespace gltf;

constexpr std::string_view kKnownNodeExtensions[] = {"KHR_lights_punctual"};
/// Most shapes (primitives times the nodes that place them) of a file.
constexpr std::size_t kMaxShapes = std::size_t{1} << 22;

/// The mesh as it lies in the world, for a transform that has no inverse: what is squeezed flat is
/// still seen.
std::shared_ptr<const Mesh> baked(const Mesh& mesh, const Affine& world_from_node) {
    auto result = std::make_shared<Mesh>();
    result->name = mesh.name;
    result->triangles = mesh.triangles;
    for (const Point<Object>& vertex : mesh.vertices) {
        result->vertices.push_back({world_from_node.apply(vertex.v)});
    }
    clean(*result);
    return result;
}

class SceneBuilder {
public:
    SceneBuilder(const std::filesystem::path& path, std::string_view bytes)
        : document_(path, bytes), primitives_(document_), materials_(document_, parsed_.scene) {}

    ParsedScene build() {
        parsed_.scene = make_empty_scene();
        parsed_.scene.film.white_luminance = 1.0;
        parsed_.scene.film.exposure = ExposureMode::automatic_if_far;
        for_each_node(document_, [&](const PlacedNode& node) { add_node(node); });
        if (parsed_.scene.shapes.empty()) {
            document_.notes().add(document_.root().place(),
                                  "{} holds no triangle that could be shown", "the scene");
        }
        parsed_.diagnostics = document_.notes().list();
        primitives_.repairs().report(document_.root().place(), parsed_.diagnostics);
        return std::move(parsed_);
    }

private:
    void add_node(const PlacedNode& node) {
        const std::string who = fmt::format("node \"{}\"", node.name);
        note_extensions(document_, node.json, kKnownNodeExtensions, who);
        if (node.json.find("skin")) {
            document_.notes().add(node.json.place(), "the skin of {} is not used: it is at rest",
                                  who);
        }
        if (auto light = read_light(document_, node))
            parsed_.scene.lights.push_back(std::move(*light));
        add_camera(node);
        if (const auto mesh = node.json.find("mesh")) add_mesh(node, *mesh);
    }

    void add_camera(const PlacedNode& node) {
        auto camera = read_camera(document_, node);
        if (camera) offer_camera(parsed_.scene, std::move(*camera));
    }

    void add_mesh(const PlacedNode& node, const Json& reference) {
        const Json mesh = document_.item("meshes", reference);
        std::string name = node.name.empty() ? mesh.text("name", "") : node.name;
        if (name.empty()) name = "mesh " + mesh.pointer().substr(mesh.pointer().rfind('/') + 1);
        note_weights(mesh, name);
        note_weights(node.json, name);
        const Json primitives = mesh.require("primitives");
        const std::size_t count = primitives.size();
        for (std::size_t i = 0; i < count; ++i) {
            const auto triangles = primitives_.read(primitives[i], mesh.text("name", name));
            if (!triangles) continue;
            if (parsed_.scene.shapes.size() >= kMaxShapes) {
                node.json.fail(fmt::format("the file shows more than {} shapes", kMaxShapes));
            }
            Shape shape;
            shape.name = count == 1 ? name : fmt::format("{}/{}", name, i + 1);
            shape.geometry = triangles;
            shape.material = materials_.read(primitives[i].find("material"));
            note_vertex_colours(primitives[i], name);
            place(std::move(shape), *triangles, node);
        }
    }

    /// Weights of morph targets, of the mesh or of its node, change the shape unless they are zero.
    void note_weights(const Json& owner, const std::string& name) {
        const auto weights = owner.find("weights");
        for (std::size_t i = 0; weights && i < weights->size(); ++i) {
            if ((*weights)[i].number(kCoordinateRange) == 0.0) continue;
            document_.notes().add(weights->place(), "the morph targets of {} are not used",
                                  fmt::format("mesh \"{}\"", name));
            return;
        }
    }

    void note_vertex_colours(const Json& primitive, const std::string& name) {
        const auto colours = primitive.require("attributes").find("COLOR_0");
        if (!colours) return;
        document_.notes().add(colours->place(), "the vertex colours of {} are not used",
                              fmt::format("mesh \"{}\"", name));
    }

    void place(Shape shape, const Mesh& mesh, const PlacedNode& node) {
        if (node.world_from_node.inverse()) {
            shape.world_from_object = Transform<World, Object>(node.world_from_node);
            parsed_.scene.shapes.push_back(mirrors_.upright(std::move(shape)));
            return;
        }
        baked_triangles_ += mesh.triangles.size();
        if (baked_triangles_ > kMaxTriangles) {
            node.json.fail("too many triangles stand under transforms that have no inverse");
        }
        const auto flat = baked(mesh, node.world_from_node);
        if (flat->triangles.empty()) {
            document_.notes().add(node.json.place(),
                                  "nothing is shown of {}: it is scaled to nothing",
                                  fmt::format("node \"{}\"", node.name));
            return;
        }
        shape.geometry = flat;
        parsed_.scene.shapes.push_back(std::move(shape));
    }

    Document document_;
    ParsedScene parsed_;
    Primitives primitives_;
    Materials materials_;
    Mirrors mirrors_;
    std::uint64_t baked_triangles_ = 0;
};

}  // namespace

ParsedScene parse_gltf(const std::filesystem::path& path, std::string_view bytes) {
    return SceneBuilder(path, bytes).build();
}

ParsedScene load_gltf(const std::filesystem::path& path) {
    const std::string bytes = read_file(path);
    const SourcePlace place{path.string(), 0, 0, {}};
    if (bytes.empty()) throw InputError(place, "the file is empty");
    const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size() - 1);
    if (!bytes.starts_with("glTF") && bytes[first] != '{') {
        throw InputError(place,
                         "this is no glTF: it begins neither with \"glTF\", as .glb does, nor with "
                         "{, as .gltf does");
    }
    return parse_gltf(path, bytes);
}

}  // namespace dewbow
