// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/morph.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewbow::gltf {

Morph::Morph(Document& document, const Json& primitive, std::uint64_t vertices,
             const MorphWeights& weights) {
    const auto targets = primitive.find("targets");
    if (!targets) return;
    const auto read = [&](const Json& target, const char* name, double weight,
                          std::vector<Target>& list) {
        const auto reference = target.find(name);
        if (!reference) return;
        Accessor displacements(document, *reference, kVectorUse);
        if (displacements.count() != vertices) {
            reference->fail(fmt::format("there are {} displacements for {} vertices",
                                        displacements.count(), vertices));
        }
        list.push_back({weight, std::move(displacements)});
    };
    for (std::size_t k = 0; k < std::min(targets->size(), weights.size()); ++k) {
        if (weights[k] == 0.0) continue;
        const Json target = (*targets)[k];
        read(target, "POSITION", weights[k], positions_);
        read(target, "NORMAL", weights[k], normals_);
        read(target, "TANGENT", weights[k], tangents_);
    }
}

Vec3 Morph::sum(const std::vector<Target>& targets, std::uint64_t i) {
    Vec3 sum;
    for (const Target& target : targets) sum += vec3_of(target.displacements[i]) * target.weight;
    return sum;
}

}  // namespace dewbow::gltf
