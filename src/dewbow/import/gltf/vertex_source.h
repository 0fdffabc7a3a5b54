// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where the numbers of a primitive's vertices come from: accessors, or a Draco stream.

#include "dewbow/import/gltf/accessor.h"
#include "dewbow/import/gltf/draco.h"

namespace dewbow::gltf {

class VertexSource {
public:
    /// Unpacks the Draco stream of `primitive` if it has one. Throws InputError.
    VertexSource(Document& document, const Json& primitive);

    bool has(const char* attribute) const { return attributes_.find(attribute).has_value(); }
    /// The numbers of `attribute`, or nothing if the primitive has none. Throws InputError.
    std::optional<Accessor> find(const char* attribute, const AccessorUse& use);
    /// Vertices of corners, each < `vertices`. Throws InputError.
    std::vector<std::uint32_t> corners(std::uint64_t vertices);

private:
    Document& document_;
    Json primitive_, attributes_;
    std::optional<DracoMesh> draco_;
};

}  // namespace dewbow::gltf
