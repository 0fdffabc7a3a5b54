// SPDX-License-Identifier: Apache-2.0
#pragma once

// The triangles of a mesh's primitives.

#include <memory>

#include "dewbow/import/gltf/document.h"
#include "dewbow/import/gltf/morph.h"
#include "dewbow/import/mesh/clean.h"

namespace dewbow::gltf {

/// Most triangles that one file may hold.
inline constexpr std::uint64_t kMaxTriangles = std::uint64_t{1} << 27;

/// Reads primitives, each once.
class Primitives {
public:
    explicit Primitives(Document& document) : document_(document) {}

    /// The triangles of `primitive`, a part of the mesh called `name`, with its morph targets by
    /// `weights`; nullptr if there are none, which is noted. Throws InputError.
    std::shared_ptr<const Mesh> read(const Json& primitive, const std::string& name,
                                     const MorphWeights& weights);

    /// What had to be repaired in all of them.
    const MeshRepairs& repairs() const { return repairs_; }

private:
    Mesh build(const Json& primitive, const MorphWeights& weights);

    Document& document_;
    std::map<std::string, std::shared_ptr<const Mesh>> known_;  ///< by JSON pointer and weights
    std::uint64_t triangles_ = 0;
    MeshRepairs repairs_;
};

}  // namespace dewbow::gltf
