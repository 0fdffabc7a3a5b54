// SPDX-License-Identifier: Apache-2.0
#pragma once

// KHR_draco_mesh_compression: the vertices and triangles of a primitive, packed by Draco.

#include <map>
#include <memory>
#include <string>

#include "dewbow/import/json/json.h"

namespace dewbow::gltf {

struct DracoMesh {
    struct Values {
        int components = 0;
        std::shared_ptr<const std::vector<float>> values;  ///< [vertex][component]
    };
    std::uint64_t vertices = 0;
    std::vector<std::uint32_t> indices;        ///< of triangles; all < `vertices`
    std::map<std::string, Values> attributes;  ///< by glTF's names
};

/// What `packed` holds. Where it is not that, InputError at `compression`, the extension object
/// that describes it. Memory is taken for what so many bytes can hold at most.
DracoMesh unpack_draco(const Json& compression, std::string_view packed);

}  // namespace dewbow::gltf
