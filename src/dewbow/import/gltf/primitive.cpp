// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/primitive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dewbow/import/gltf/vertex_source.h"

namespace dewbow::gltf {
namespace {

enum Mode : std::uint64_t { kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6 };
constexpr std::uint64_t kMaxMode = 6;

/// The triangles that `indices` are in that mode.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<std::uint32_t>& indices,
                                                       std::uint64_t mode) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    if (indices.size() < 3) return triangles;
    const std::size_t step = mode == kTriangles ? 3 : 1;
    triangles.reserve((indices.size() - 2) / step + 1);
    for (std::size_t i = 0; i + 2 < indices.size(); i += step) {
        if (mode == kTriangleFan) {
            triangles.push_back({indices[i + 1], indices[i + 2], indices[0]});
        } else {
            // Every other triangle of a strip is turned round.
            const std::size_t odd = mode == kTriangleStrip ? i % 2 : 0;
            triangles.push_back({indices[i], indices[i + 1 + odd], indices[i + 2 - odd]});
        }
    }
    return triangles;
}

/// Numbers the vertices that are used from 0 on, in the order of first use, so that a primitive
/// which uses a few of a large accessor's vertices costs only those.
class UsedVertices {
public:
    UsedVertices(std::uint64_t vertices, std::size_t corners) {
        // A table of all where most are used, else one of those that are.
        if (vertices / 4 <= corners) table_.resize(vertices, kUnused);
    }

    std::uint32_t operator()(std::uint32_t index) {
        std::uint32_t& entry =
            table_.empty() ? few_.try_emplace(index, kUnused).first->second : table_[index];
        if (entry == kUnused) {
            entry = std::uint32_t(used_.size());
            used_.push_back(index);
        }
        return entry;
    }
    const std::vector<std::uint32_t>& used() const { return used_; }

private:
    static constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

    std::vector<std::uint32_t> table_;
    std::unordered_map<std::uint32_t, std::uint32_t> few_;
    std::vector<std::uint32_t> used_;
};

/// What a primitive's vertices have, none or one for each vertex.
class Attributes {
public:
    Attributes(Document& document, const Json& primitive, VertexSource& source,
               const Accessor& positions, const MorphWeights& weights)
        : positions_(positions),
          normals_(find(primitive, source, "NORMAL", kNormalUse)),
          tangents_(find(primitive, source, "TANGENT", kTangentUse)),
          colours_(find(primitive, source, "COLOR_0", kColourUse)),
          texcoords_{find(primitive, source, "TEXCOORD_0", kTexcoordUse),
                     find(primitive, source, "TEXCOORD_1", kTexcoordUse)},
          morph_(document, primitive, positions.count(), weights) {}

    /// Adds vertex `i` to `mesh`.
    void add(std::uint64_t i, Mesh& mesh) const {
        mesh.vertices.push_back({vec3_of(positions_[i]) + morph_.of_position(i)});
        if (normals_) mesh.normals.push_back({vec3_of((*normals_)[i]) + morph_.of_normal(i)});
        if (tangents_) mesh.tangents.push_back(tangent(i));
        if (colours_) mesh.colours.push_back(colour(i));
        for (std::size_t set = 0; set < 2; ++set) {
            if (!texcoords_[set]) continue;
            const auto uv = (*texcoords_[set])[i];
            mesh.texcoords[set].push_back({float(uv[0]), float(uv[1])});
        }
    }

private:
    std::optional<Accessor> find(const Json& primitive, VertexSource& source, const char* name,
                                 const AccessorUse& use) const {
        auto accessor = source.find(name, use);
        if (accessor && accessor->count() != positions_.count()) {
            primitive.require("attributes")
                .require(name)
                .fail(fmt::format("there are {} {} for {} vertices", accessor->count(), use.what,
                                  positions_.count()));
        }
        return accessor;
    }

    /// Zero where the file's is no direction: there normal maps lie as the surface's coordinates.
    std::array<float, 4> tangent(std::uint64_t i) const {
        const auto e = (*tangents_)[i];
        const Vec3 t = vec3_of(e) + morph_.of_tangent(i);
        const float w = e[3] < 0.0 ? -1.0f : 1.0f;
        if (!std::isfinite(dot(t, t))) return {0.0f, 0.0f, 0.0f, w};
        return {float(t.x), float(t.y), float(t.z), w};
    }

    std::array<float, 4> colour(std::uint64_t i) const {
        auto e = (*colours_)[i];
        if (colours_->components() == 3) e[3] = 1.0;
        std::array<float, 4> rgba;
        for (std::size_t c = 0; c < 4; ++c)  // not a number counts as 0
            rgba[c] = e[c] > 0.0 ? float(std::min(e[c], 1.0)) : 0.0f;
        return rgba;
    }

    const Accessor& positions_;
    std::optional<Accessor> normals_, tangents_, colours_;
    std::array<std::optional<Accessor>, 2> texcoords_;
    Morph morph_;
};

/// Distinguishes shapes that the same primitive has under different weights.
std::string key_of(const Json& primitive, const MorphWeights& weights) {
    std::string key = primitive.pointer();
    if (!primitive.find("targets")) return key;
    for (const double weight : weights) key += fmt::format(" {}", weight);
    return key;
}

}  // namespace

Mesh Primitives::build(const Json& primitive, const MorphWeights& weights) {
    Mesh mesh;
    VertexSource source(document_, primitive);
    const auto positions = source.find("POSITION", kPositionUse);
    if (!positions) return mesh;
    const Attributes attributes(document_, primitive, source, *positions, weights);
    const auto mode = primitive.find("mode");
    mesh.triangles =
        triangles_of(source.corners(positions->count()), mode ? mode->whole(kMaxMode) : kTriangles);
    triangles_ += mesh.triangles.size();
    if (triangles_ > kMaxTriangles) {
        primitive.fail(fmt::format("the file holds more than {} triangles", kMaxTriangles));
    }
    UsedVertices used(positions->count(), mesh.triangles.size() * 3);
    for (auto& triangle : mesh.triangles) {
        for (std::uint32_t& index : triangle) index = used(index);
    }
    for (const std::uint32_t i : used.used()) attributes.add(i, mesh);
    return mesh;
}

std::shared_ptr<const Mesh> Primitives::read(const Json& primitive, const std::string& name,
                                             const MorphWeights& weights) {
    const auto [found, is_new] = known_.try_emplace(key_of(primitive, weights));
    if (!is_new) return found->second;
    const std::string who = fmt::format("mesh \"{}\"", name);
    const auto mode = primitive.find("mode");
    if (mode && mode->whole(kMaxMode) < kTriangles) {
        document_.notes().add(mode->place(), "points and lines of {} are not shown", who);
        return nullptr;
    }
    constexpr std::string_view kKnownExtensions[] = {"KHR_draco_mesh_compression",
                                                     "KHR_materials_variants"};
    note_extensions(document_, primitive, kKnownExtensions, who);
    Mesh mesh = build(primitive, weights);
    mesh.name = name;
    repairs_ += clean(mesh);
    if (mesh.triangles.empty()) {
        document_.notes().add(primitive.place(), "nothing is shown of {}: no triangle has an area",
                              who);
        return nullptr;
    }
    found->second = std::make_shared<Mesh>(std::move(mesh));
    return found->second;
}

}  // namespace dewbow::gltf
