// SPDX-License-Identifier: Apache-2.0
#pragma once

// Morph targets: displacements of vertices, each with a weight.

#include <vector>

#include "dewbow/import/gltf/accessor.h"

namespace dewbow::gltf {

/// Weights of a mesh's targets, in their order; targets beyond the list have 0.
using MorphWeights = std::vector<double>;

class Morph {
public:
    /// Reads the targets of `primitive`, which has `vertices` vertices, whose weight is not 0.
    /// Throws InputError.
    Morph(Document& document, const Json& primitive, std::uint64_t vertices,
          const MorphWeights& weights);

    /// The sum of the targets' displacements of vertex `i`.
    Vec3 of_position(std::uint64_t i) const { return sum(positions_, i); }
    Vec3 of_normal(std::uint64_t i) const { return sum(normals_, i); }
    Vec3 of_tangent(std::uint64_t i) const { return sum(tangents_, i); }

private:
    struct Target {
        double weight;
        Accessor displacements;
    };
    static Vec3 sum(const std::vector<Target>& targets, std::uint64_t i);

    std::vector<Target> positions_, normals_, tangents_;
};

}  // namespace dewbow::gltf
