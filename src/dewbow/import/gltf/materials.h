// SPDX-License-Identifier: Apache-2.0
#pragma once

// From glTF's materials to ours: each becomes what its factors amount to.
//
// glTF's surface is a metal (share m), and for the rest a dielectric of which the part t transmits
// and the remainder is opaque. So glass has the share (1 − m) t, and the opaque surface, whose
// metalness is m / (1 − (1 − m) t), the rest.

#include <map>

#include "dewbow/import/gltf/document.h"
#include "dewbow/scene/scene.h"

namespace dewbow::gltf {

class Materials {
public:
    Materials(Document& document, Scene& scene) : document_(document), scene_(scene) {}

    /// Index in the scene of the material that `reference` names; of the default material without
    /// one. Only materials that are asked for are read. Throws InputError.
    int read(const std::optional<Json>& reference);

private:
    Document& document_;
    Scene& scene_;
    std::map<std::uint64_t, int> known_;
    std::optional<int> default_;
};

}  // namespace dewbow::gltf
