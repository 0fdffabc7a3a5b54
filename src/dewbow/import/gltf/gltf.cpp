// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/gltf.h"

#include <fmt/format.h>

#include "dewbow/base/file.h"
#include "dewbow/import/gltf/cameras.h"
#include "dewbow/import/gltf/instances.h"
#include "dewbow/import/gltf/lights.h"
#include "dewbow/import/gltf/materials.h"
#include "dewbow/import/gltf/primitive.h"

namespace dewbow {
namespace {

using namespace gltf;

constexpr std::string_view kKnownNodeExtensions[] = {"EXT_mesh_gpu_instancing",
                                                     "KHR_lights_punctual", "KHR_node_visibility"};
/// Spectra of a stated luminance have it to four digits.
constexpr double kRounding = 1e-3;
/// Most shapes (primitives times the nodes that place them) of a file.
constexpr std::size_t kMaxShapes = std::size_t{1} << 22;

/// The mesh as it lies in the world, for a transform that has no inverse: what is squeezed flat is
/// still seen.
std::shared_ptr<const Mesh> baked(const Mesh& mesh, const Affine& world_from_node) {
    auto result = std::make_shared<Mesh>();
    result->name = mesh.name;
    result->triangles = mesh.triangles;
    result->texcoords = mesh.texcoords;
    result->colours = mesh.colours;
    for (const Point<Object>& vertex : mesh.vertices) {
        result->vertices.push_back({world_from_node.apply(vertex.v)});
    }
    clean(*result);
    return result;
}

class SceneBuilder {
public:
    SceneBuilder(const std::filesystem::path& path, std::string_view bytes,
                 std::optional<double> time_s)
        : document_(path, bytes),
          pose_(time_s ? Pose(document_, *time_s) : Pose()),
          primitives_(document_),
          materials_(document_, parsed_.scene) {
        if (!time_s && document_.count("animations") > 0) {
            document_.notes().add(document_.root().require("animations").place(),
                                  "{} is shown at rest; --frame N shows its animations",
                                  "the scene");
        }
    }

    ParsedScene build() {
        parsed_.scene = make_empty_scene();
        parsed_.scene.film.white_luminance = 1.0;
        // Viewers of glTF light what does not shine brighter than white itself.
        parsed_.least_lamp_luminance = 1.0 + kRounding;
        parsed_.scene.film.exposure = ExposureMode::automatic_if_far;
        for_each_node(document_, pose_, [&](const PlacedNode& node) { add_node(node); });
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
        add_camera(node);
        if (!node.visible) return;
        const std::string who = fmt::format("node \"{}\"", node.name);
        note_extensions(document_, node.json, kKnownNodeExtensions, who);
        if (node.json.find("skin")) {
            document_.notes().add(node.json.place(), "the skin of {} is not used: it is at rest",
                                  who);
        }
        if (auto light = read_light(document_, node))
            parsed_.scene.lights.push_back(std::move(*light));
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
        const MorphWeights weights = weights_of(node, mesh);
        const std::vector<Affine> instances = read_instances(document_, node.json);
        const Json primitives = mesh.require("primitives");
        const std::size_t count = primitives.size();
        for (std::size_t i = 0; i < count; ++i) {
            const auto triangles =
                primitives_.read(primitives[i], mesh.text("name", name), weights);
            if (!triangles) continue;
            Shape shape;
            shape.name = count == 1 ? name : fmt::format("{}/{}", name, i + 1);
            shape.geometry = triangles;
            shape.material =
                materials_.read(primitives[i].find("material"), !triangles->colours.empty());
            place_all(shape, *triangles, node, instances);
        }
    }

    /// Of the mesh's morph targets: those of an animation, of the node, or of the mesh.
    MorphWeights weights_of(const PlacedNode& node, const Json& mesh) const {
        if (const auto* animated = pose_.find(node.index, "weights")) return *animated;
        auto weights = node.json.find("weights");
        if (!weights) weights = mesh.find("weights");
        return weights ? weights->numbers(weights->size(), kCoordinateRange) : MorphWeights{};
    }

    void place_all(const Shape& shape, const Mesh& mesh, const PlacedNode& node,
                   const std::vector<Affine>& instances) {
        if (parsed_.scene.shapes.size() + instances.size() > kMaxShapes)
            node.json.fail(fmt::format("the file shows more than {} shapes", kMaxShapes));
        for (std::size_t i = 0; i < instances.size(); ++i) {
            Shape one = shape;
            if (instances.size() > 1) one.name += fmt::format(" {}", i + 1);
            place(std::move(one), mesh, node, node.world_from_node * instances[i]);
        }
    }

    void place(Shape shape, const Mesh& mesh, const PlacedNode& node,
               const Affine& world_from_mesh) {
        if (world_from_mesh.inverse()) {
            shape.world_from_object = Transform<World, Object>(world_from_mesh);
            parsed_.scene.shapes.push_back(mirrors_.upright(std::move(shape)));
            return;
        }
        baked_triangles_ += mesh.triangles.size();
        if (baked_triangles_ > kMaxTriangles) {
            node.json.fail("too many triangles stand under transforms that have no inverse");
        }
        const auto flat = baked(mesh, world_from_mesh);
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
    Pose pose_;
    ParsedScene parsed_;
    Primitives primitives_;
    Materials materials_;
    Mirrors mirrors_;
    std::uint64_t baked_triangles_ = 0;
};

}  // namespace

ParsedScene parse_gltf(const std::filesystem::path& path, std::string_view bytes,
                       std::optional<double> time_s) {
    return SceneBuilder(path, bytes, time_s).build();
}

ParsedScene load_gltf(const std::filesystem::path& path, std::optional<double> time_s) {
    const std::string bytes = read_file(path);
    const SourcePlace place{path.string(), 0, 0, {}};
    if (bytes.empty()) throw InputError(place, "the file is empty");
    const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size() - 1);
    if (!bytes.starts_with("glTF") && bytes[first] != '{') {
        throw InputError(place,
                         "this is no glTF: it begins neither with \"glTF\", as .glb does, nor with "
                         "{, as .gltf does");
    }
    return parse_gltf(path, bytes, time_s);
}

}  // namespace dewbow
