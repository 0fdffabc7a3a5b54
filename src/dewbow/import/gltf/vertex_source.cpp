// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/vertex_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace dewbow::gltf {

VertexSource::VertexSource(Document& document, const Json& primitive)
    : document_(document), primitive_(primitive), attributes_(primitive.require("attributes")) {
    if (const auto draco = find_extension(primitive, "KHR_draco_mesh_compression"))
        draco_ = unpack_draco(*draco, document.view(draco->require("bufferView")).bytes);
}

std::optional<Accessor> VertexSource::find(const char* attribute, const AccessorUse& use) {
    const auto reference = attributes_.find(attribute);
    if (!reference) return std::nullopt;
    if (draco_) {
        const auto found = draco_->attributes.find(attribute);
        if (found != draco_->attributes.end()) {
            const int components = found->second.components;
            if (components < use.least_components || components > use.most_components) {
                reference->fail(
                    fmt::format("the Draco stream holds {} of {} numbers", use.what, components));
            }
            return Accessor(found->second.values, components);
        }
    }
    return Accessor(document_, *reference, use);
}

std::vector<std::uint32_t> VertexSource::corners(std::uint64_t vertices) {
    const auto index = primitive_.find("indices");
    if (draco_ || index) {
        std::vector<std::uint32_t> indices =
            draco_ ? std::move(draco_->indices) : read_indices(document_, *index);
        const auto largest = std::max_element(indices.begin(), indices.end());
        if (largest != indices.end() && *largest >= vertices) {
            (index ? *index : primitive_)
                .fail(fmt::format("uses vertex {}; there are {}, from 0", *largest, vertices));
        }
        return indices;
    }
    if (vertices > std::numeric_limits<std::uint32_t>::max())
        primitive_.fail("has too many vertices");
    std::vector<std::uint32_t> indices(vertices);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

}  // namespace dewbow::gltf
