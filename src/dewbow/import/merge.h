// SPDX-License-Identifier: Apache-2.0
#pragma once

// One scene put into another.

#include "dewbow/import/parsed_scene.h"

namespace dewbow {

/// A material of the guest, by name, that a material of the host takes the place of.
struct MaterialOverride {
    std::string name;
    int host_material = 0;
};

/// Adds the shapes, materials and lights of `guest` to `host`, moved by `world_from_guest`
/// (invertible). What the guest says of camera, film, rendering and surroundings is not taken over.
void merge(Scene& host, const Scene& guest, const Affine& world_from_guest,
           const std::vector<MaterialOverride>& overrides);

/// The light as it stands after the move.
Light moved(const Light& light, const Affine& world_from_guest);

/// The camera as it stands after the move: no scale and no mirror image is left in its frame. An
/// orthographic picture's height grows with the scale.
CameraView moved(CameraView camera, const Affine& world_from_guest);

/// A frame with the origin, the −z and the y of `affine`, orthonormal.
Affine without_scale(const Affine& affine);

}  // namespace dewbow
