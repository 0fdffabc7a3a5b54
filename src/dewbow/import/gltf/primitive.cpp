// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/primitive.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "dewbow/import/gltf/accessor.h"

namespace dewbow::gltf {
namespace {

enum Mode : std::uint64_t { kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6 };

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

std::vector<std::uint32_t> corner_indices(Document& document, const Json& primitive,
                                          std::uint64_t vertices) {
    if (const auto index = primitive.find("indices")) {
        std::vector<std::uint32_t> indices = read_indices(document, *index);
        const auto largest = std::max_element(indices.begin(), indices.end());
        if (largest != indices.end() && *largest >= vertices) {
            index->fail(fmt::format("uses vertex {}; there are {}, from 0", *largest, vertices));
        }
        return indices;
    }
    if (vertices > std::numeric_limits<std::uint32_t>::max())
        primitive.fail("has too many vertices");
    std::vector<std::uint32_t> indices(vertices);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

}  // namespace

Mesh Primitives::build(const Json& primitive) {
    const Json attributes = primitive.require("attributes");
    const auto position = attributes.find("POSITION");
    Mesh mesh;
    if (!position) return mesh;
    const Vec3Accessor positions(document_, *position);
    std::optional<Vec3Accessor> normals;
    if (const auto normal = attributes.find("NORMAL")) {
        normals.emplace(document_, *normal);
        if (normals->count() != positions.count()) {
            normal->fail(fmt::format("there are {} normals for {} vertices", normals->count(),
                                     positions.count()));
        }
    }
    constexpr std::uint64_t kMaxMode = 6;
    const auto mode = primitive.find("mode");
    mesh.triangles = triangles_of(corner_indices(document_, primitive, positions.count()),
                                  mode ? mode->whole(kMaxMode) : kTriangles);
    triangles_ += mesh.triangles.size();
    if (triangles_ > kMaxTriangles) {
        primitive.fail(fmt::format("the file holds more than {} triangles", kMaxTriangles));
    }
    UsedVertices used(positions.count(), mesh.triangles.size() * 3);
    for (auto& triangle : mesh.triangles) {
        for (std::uint32_t& index : triangle) index = used(index);
    }
    mesh.vertices.reserve(used.used().size());
    for (const std::uint32_t i : used.used()) {
        mesh.vertices.push_back({positions[i]});
        if (normals) mesh.normals.push_back({(*normals)[i]});
    }
    return mesh;
}

std::shared_ptr<const Mesh> Primitives::read(const Json& primitive, const std::string& name) {
    const auto [found, is_new] = known_.try_emplace(primitive.pointer());
    if (!is_new) return found->second;
    const std::string who = fmt::format("mesh \"{}\"", name);
    const auto mode = primitive.find("mode");
    if (mode && mode->whole(6) < kTriangles) {
        document_.notes().add(mode->place(), "points and lines of {} are not shown", who);
        return nullptr;
    }
    constexpr std::string_view kKnownExtensions[] = {"KHR_draco_mesh_compression"};
    note_extensions(document_, primitive, kKnownExtensions, who);
    Mesh mesh = build(primitive);
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
