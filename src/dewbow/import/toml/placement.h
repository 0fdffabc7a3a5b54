// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where a thing stands. First it is scaled, then turned, then moved.

#include "dewbow/import/toml/table.h"
#include "dewbow/math/transform.h"

namespace dewbow::toml_import {

/// Reads `scale` (a number or [x, y, z]), `rotate_deg` = [[axis x, y, z, angle], …] in that order,
/// or `rotate_x_deg`, `rotate_y_deg`, `rotate_z_deg` in that order, and `position`. The result is
/// invertible.
/// @param with_look_at  reads `look_at` too, instead of a rotation: the thing's +z turns to that
/// point and its x axis stays level.
Affine read_placement(Table& table, bool with_look_at);

/// World from camera, reading `position`, `look_at` and `up` = [0, 1, 0].
Affine read_viewpoint(Table& table);

}  // namespace dewbow::toml_import
