// SPDX-License-Identifier: Apache-2.0
#pragma once

// [camera] and [cameras.NAME]: where the picture is taken from, and through what.

#include "dewbow/import/toml/table.h"
#include "dewbow/scene/camera.h"

namespace dewbow::toml_import {

/// position, look_at, up = [0, 1, 0]; projection = "perspective" with vertical_fov_deg = 40,
/// "orthographic" with height_*, "panorama"; lens, stereo. (`from` is read by the caller.)
CameraView read_camera(Table& table, const std::string& name);

}  // namespace dewbow::toml_import
