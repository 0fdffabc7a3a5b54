// SPDX-License-Identifier: Apache-2.0
#pragma once

// From glTF's materials to ours: each becomes what its properties amount to.
//
// glTF's surface is a metal (share m), and for the rest a dielectric of which the part t transmits
// and the remainder is opaque. So glass has the share (1 − m) t, and the opaque surface, whose
// metalness is m / (1 − (1 − m) t), the rest. Where textures shape m or t, and both are there, it
// is a mix of the metal with a mix of the other two.

#include <map>

#include "dewbow/import/gltf/material_properties.h"
#include "dewbow/scene/scene.h"

namespace dewbow::gltf {

class Materials {
public:
    Materials(Document& document, Scene& scene)
        : document_(document), scene_(scene), textures_(document) {}

    /// Index in the scene of the material that `reference` names; of the default material without
    /// one. Where the mesh has colours they multiply its base colour and its alpha. Only materials
    /// that are asked for are read. Throws InputError.
    int read(const std::optional<Json>& reference, bool vertex_colours);

private:
    /// What has to be said about the glass that is named; InputError if there is none.
    void note_glass(const MaterialProperties& properties);

    Document& document_;
    Scene& scene_;
    Textures textures_;
    std::map<std::pair<std::uint64_t, bool>, int> known_;
    std::map<bool, int> default_;
};

}  // namespace dewbow::gltf
