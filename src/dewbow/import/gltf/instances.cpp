// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/instances.h"

#include <fmt/format.h>

#include "dewbow/import/gltf/accessor.h"

namespace dewbow::gltf {
namespace {

/// The places of one node's instances.
class Places {
public:
    Places(Document& document, const Json& attributes)
        : attributes_(attributes),
          translations_(find(document, "TRANSLATION", kVectorUse)),
          rotations_(find(document, "ROTATION", kRotationUse)),
          scales_(find(document, "SCALE", kVectorUse)) {}

    std::uint64_t count() const { return count_.value_or(0); }

    Affine operator[](std::uint64_t i) const {
        Affine place;
        if (translations_) place = translation(finite("TRANSLATION", (*translations_)[i]));
        if (rotations_) {
            const auto q = (*rotations_)[i];
            const auto turn = rotation_of({q[0], q[1], q[2], q[3]});
            if (!turn) attributes_.require("ROTATION").fail(fmt::format("rotation {} is zero", i));
            place = place * *turn;
        }
        if (scales_) place = place * scaling(finite("SCALE", (*scales_)[i]));
        return place;
    }

private:
    std::optional<Accessor> find(Document& document, const char* name, const AccessorUse& use) {
        const auto reference = attributes_.find(name);
        if (!reference) return std::nullopt;
        Accessor accessor(document, *reference, use);
        if (count_.value_or(accessor.count()) != accessor.count())
            reference->fail(
                fmt::format("there are {} {}, but {} places", accessor.count(), use.what, *count_));
        count_ = accessor.count();
        return accessor;
    }

    Vec3 finite(const char* name, const Accessor::Element& e) const {
        for (const double number : e)
            if (!kCoordinateRange.contains(number))
                attributes_.require(name).fail(fmt::format("holds {}", number));
        return vec3_of(e);
    }

    Json attributes_;
    std::optional<std::uint64_t> count_;
    std::optional<Accessor> translations_, rotations_, scales_;
};

}  // namespace

std::vector<Affine> read_instances(Document& document, const Json& node) {
    const auto extension = find_extension(node, "EXT_mesh_gpu_instancing");
    if (!extension) return {Affine{}};
    const Places places(document, extension->require("attributes"));
    std::vector<Affine> instances;
    for (std::uint64_t i = 0; i < places.count(); ++i) instances.push_back(places[i]);
    return instances;
}

}  // namespace dewbow::gltf
